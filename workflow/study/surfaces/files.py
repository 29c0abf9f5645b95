"""Files of measured lines: text, npy, netCDF, and what SurfaceTopography reads."""

from collections.abc import Callable

import numpy as np

from ...errors import UserError
from .lines import KEY, Asked, Lines, lines_of, plain, rounding
from .text import precision, read_text

USUAL_COLUMNS = (0, 1)
MOST_VALUES = 10**8  # heights in a netCDF file, of which a compressed one of 8 kB may hold more


def read_lines(asked: Asked) -> Lines:
    """Return the lines of a file, the reader chosen by the suffix of its name.

    Raises UserError, one line that names key and file, for a file that cannot be read, units
    that nobody names, samples that are not finite and positions that are not uniform.
    """
    reader = READERS.get(asked.path.suffix.lower(), _with_surface_topography)
    try:
        return reader(asked)
    except (OSError, EOFError, ValueError, TypeError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or str(error).partition("\n")[0]
        raise UserError(f"{KEY} = {asked.name!r}: cannot be read: {reason}") from None


def _text(asked: Asked) -> Lines:
    columns = _numbered(asked)
    table = read_text(KEY, asked.name, asked.path.read_bytes(), columns)
    return lines_of(asked, table.values, precision(table.written), table.units)


def _npy(asked: Asked) -> Lines:
    columns = _numbered(asked)
    values = np.load(asked.path, mmap_mode="r", allow_pickle=False)  # no more than is there
    if not isinstance(values, np.ndarray):
        raise ValueError("holds several arrays")
    if values.ndim != 2 or values.shape[1] <= max(columns) or values.dtype.kind not in "fiu":
        raise UserError(
            f"{KEY} = {asked.name!r}: holds an array of shape {values.shape} and type "
            f"{values.dtype}: must be numbers, a row per sample, with columns {list(columns)}"
        )
    table = values[:, columns].T.astype(float)
    known = np.full(table.shape[1], rounding(values[:, columns[0]]))
    return lines_of(asked, table, known, ())


def _netcdf(asked: Asked) -> Lines:
    import netCDF4

    with netCDF4.Dataset(asked.path) as data:
        x, z = _variables(asked, data.variables)
        if z.size > MOST_VALUES:
            raise ValueError(f"{z.size} heights, more than {MOST_VALUES}")
        own = tuple(str(getattr(v, "units", getattr(v, "unit", ""))) for v in (x, z))
        known = np.full(x.size, rounding(x[:]))
        heights = np.moveaxis(plain(z[:]), z.dimensions.index(x.dimensions[0]), -1)
        table = np.vstack([plain(x[:]), heights.reshape(-1, x.size)])
    return lines_of(asked, table, known, own)


def _variables(asked: Asked, variables: dict) -> tuple:
    """Return the variables of positions and heights of a netCDF file."""
    if asked.columns:
        names = asked.columns
    else:
        heights = [n for n, v in variables.items() if v.ndim and (n,) != v.dimensions]
        along = variables[heights[0]].dimensions if len(heights) == 1 else ("",)
        names = ("x" if "x" in along else along[-1], *heights)
    if len(names) != 2 or any(name not in variables for name in names):
        raise UserError(
            f"{KEY} = {asked.name!r}: holds the variables {', '.join(variables)}: name positions "
            'and heights, as surface.columns = ["x", "height"]'
        )
    x, z = (variables[name] for name in names)
    if x.ndim != 1 or not set(x.dimensions) <= set(z.dimensions):
        raise UserError(
            f"{KEY} = {asked.name!r}: {names[0]!r} holds no positions of the samples of "
            f"{names[1]!r}: must be of one dimension that both have"
        )
    return x, z


def _with_surface_topography(asked: Asked) -> Lines:
    try:
        import SurfaceTopography
    except ImportError:
        raise UserError(
            f"{KEY} = {asked.name!r}: files {asked.path.suffix or 'without suffix'} are read by "
            "SurfaceTopography, which is not installed: pip install 'elastomer-friction[measured]'"
        ) from None
    try:
        topography = SurfaceTopography.read_topography(str(asked.path))
    except Exception as error:  # readers of forty formats raise what they like
        raise ValueError(str(error)) from error
    unit = str(topography.unit or "")
    if topography.dim == 2:  # a map: every row along x is a line
        x = np.arange(topography.nb_grid_pts[0]) * topography.pixel_size[0]
        heights = plain(topography.heights()).T
    else:
        x, z = topography.positions_and_heights()
        heights = plain(z)[None, :]
    known = np.full(len(x), rounding(x))
    return lines_of(asked, np.vstack([x, heights]), known, (unit, unit))


def _numbered(asked: Asked) -> tuple[int, ...]:
    """Return the numbers of columns of a table; a netCDF file has names instead."""
    columns = asked.columns or USUAL_COLUMNS
    if not all(isinstance(column, int) for column in columns):
        raise UserError(
            f"surface.columns = {list(columns)!r}: {asked.name!r} has numbered columns, from 0"
        )
    return columns


READERS: dict[str, Callable[[Asked], Lines]] = {
    ".txt": _text,
    ".csv": _text,
    ".npy": _npy,
    ".nc": _netcdf,
}
