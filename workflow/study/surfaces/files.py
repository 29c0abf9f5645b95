"""Files of measured lines: text, npy, netCDF, and what SurfaceTopography reads."""

from typing import Any

import numpy as np

from ...ground import UserError, open_plain, read_plain
from ...system import unreadable
from ...text_tables import archive_kind, is_text
from .positions import rounding
from .raw_lines import KEY, LineFile, Lines, RawLines, check_numbered, lines_of, plain, row_spacing
from .text_lines import read_text_lines

USUAL_COLUMNS = (0, 1)
MOST_VALUES = 10**8  # heights in a netCDF file, of which a compressed one of 8 kB may hold more
ARCHIVED = (".x3p", ".npy")  # formats that are archives, or may hold one
NOT_PLAIN = (".sdf", ".ezd", ".nid", ".plu")  # text, but with headers that scale the numbers


def read_lines(asked: LineFile) -> Lines:
    """Return the lines of a file in m.

    ``.npy`` and ``.nc`` are known by their suffix, text by what it is, whatever its suffix; the
    rest goes to SurfaceTopography. Raises UserError, one line that names key and file, for a file
    that cannot be read, and as ``lines_of``.
    """
    suffix = asked.path.suffix.lower()
    reader = {".npy": _npy, ".nc": _netcdf}.get(suffix)
    try:
        open_plain(asked.path, linked=True).close()  # the readers of others open pipes too
        if reader is None:
            data = read_plain(asked.path)
            kind = archive_kind(data)
            if kind and suffix not in ARCHIVED:
                raise UserError(
                    f"{KEY} = {asked.name!r}: is {kind}: unpack it and name one of its files"
                )
            text = is_text(data) and suffix not in NOT_PLAIN
            reader = read_text_lines if text else _with_surface_topography
        return lines_of(asked, reader(asked))
    except (OSError, EOFError, ValueError, TypeError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or str(error).partition("\n")[0]
        raise UserError(f"{KEY} = {asked.name!r}: cannot be read: {reason}") from None


def _npy(asked: LineFile) -> RawLines:
    values = np.load(asked.path, mmap_mode="r", allow_pickle=False)  # no more than is there
    if not isinstance(values, np.ndarray):
        raise ValueError("holds several arrays")
    columns = asked.columns or (USUAL_COLUMNS if asked.step is None else (0,))
    check_numbered(asked)
    if values.ndim == 1 and asked.step is not None:
        values = values[:, None]
    if values.ndim != 2 or values.shape[1] <= max(columns) or values.dtype.kind not in "fiu":
        raise UserError(
            f"{KEY} = {asked.name!r}: holds an array of shape {values.shape} and type "
            f"{values.dtype}: must be numbers, a row per sample, with columns {list(columns)}"
        )
    table = values[:, columns].T.astype(float)
    if asked.step is not None:
        return RawLines(table, None, np.empty(0), asked.step, (), f"columns {list(columns)}")
    known = np.full(table.shape[1], rounding(values[:, columns[0]]))
    return RawLines(table[1:], table[0], known, None, (), f"columns {list(columns)}")


def _netcdf(asked: LineFile) -> RawLines:
    import netCDF4

    if why := unreadable([asked.path]).get(asked.path):
        raise ValueError(why)
    with netCDF4.Dataset(asked.path) as data:
        x, z = _variables(asked, data.variables)
        if z.size > MOST_VALUES:
            raise ValueError(f"{z.size} heights, more than {MOST_VALUES}")
        own = tuple(str(getattr(v, "units", getattr(v, "unit", ""))) for v in (x, z))
        known = np.full(x.size, rounding(x[:]))
        heights = np.moveaxis(plain(z[:]), z.dimensions.index(x.dimensions[0]), -1)
        told = f"variables {x.name} and {z.name}"
        across = [data.variables.get(name) for name in z.dimensions if name not in x.dimensions]
        rows = None
        if len(across) == 1 and across[0] is not None:
            unit = str(getattr(across[0], "units", getattr(across[0], "unit", own[0])))
            rows = row_spacing(plain(across[0][:]), unit)
        return RawLines(heights.reshape(-1, x.size), plain(x[:]), known, None, own, told, rows)


def _variables(asked: LineFile, variables: dict) -> tuple:
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


def _with_surface_topography(asked: LineFile) -> RawLines:
    try:
        import SurfaceTopography
    except ImportError:
        raise UserError(
            f"{KEY} = {asked.name!r}: files {asked.path.suffix or 'without suffix'} that are no "
            "text are read by SurfaceTopography, which is not installed: pip install "
            "SurfaceTopography"
        ) from None
    try:
        topography: Any = SurfaceTopography.read_topography(str(asked.path))
    except Exception as error:  # readers of forty formats raise what they like
        said = str(error).partition("\n")[0].rstrip(": ")
        tried = "" if said.startswith("tried") else f" ({said})"
        raise ValueError(f"no reader of SurfaceTopography knows it{tried}") from error
    unit, rows = str(topography.unit or ""), None
    if topography.dim == 2:  # a map: every row along x is a line
        x = np.arange(topography.nb_grid_pts[0]) * topography.pixel_size[0]
        heights = plain(topography.heights()).T
        rows = row_spacing(np.array([0.0, topography.pixel_size[1]]), unit)
    else:
        x, z = topography.positions_and_heights()
        heights = plain(z)[None, :]
    known = np.full(len(x), rounding(x))
    told = f"read by SurfaceTopography as a {'map' if topography.dim == 2 else 'line'}"
    return RawLines(heights, plain(x), known, None, (unit, unit), told, rows)
