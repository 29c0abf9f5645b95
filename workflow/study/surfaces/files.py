"""Files of measured lines: text, npy, netCDF, and what SurfaceTopography reads."""

from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from workflow.errors import UserError
from workflow.study.surfaces.prepare import uniform_step
from workflow.study.surfaces.text import precision, read_text
from workflow.study.surfaces.units import metres

KEY = "surface.file"
USUAL_COLUMNS = (0, 1)
LEAST_SAMPLES = 8


class Asked(NamedTuple):
    """How a file is to be read."""

    path: Path
    name: str  # of the file as the study gives it
    columns: tuple = ()  # positions, then heights: numbers, or names of variables
    units: tuple[str, ...] = ()  # of positions and heights; empty: the file names them


class Lines(NamedTuple):
    """Lines as a file holds them, in m."""

    heights: np.ndarray  # shape (lines, n)
    step: float
    notes: str


def read_lines(asked: Asked) -> Lines:
    """Return the lines of a file, the reader chosen by the suffix of its name.

    Raises UserError, one line that names key and file, for a file that cannot be read, units
    that nobody names, samples that are not finite and positions that are not uniform.
    """
    reader = READERS.get(asked.path.suffix.lower(), _with_surface_topography)
    try:
        return reader(asked)
    except (OSError, EOFError, ValueError) as error:
        reason = str(error).partition("\n")[0]
        raise UserError(f"{KEY} = {asked.name!r}: cannot be read: {reason}") from None


def _text(asked: Asked) -> Lines:
    columns = _numbered(asked)
    table = read_text(KEY, asked.name, asked.path.read_bytes(), columns)
    return _table(asked, table.values, precision(table.written), table.units)


def _npy(asked: Asked) -> Lines:
    columns = _numbered(asked)
    values = np.load(asked.path, allow_pickle=False)
    if values.ndim != 2 or values.shape[1] <= max(columns) or values.dtype.kind not in "fiu":
        raise UserError(
            f"{KEY} = {asked.name!r}: holds an array of shape {values.shape} and type "
            f"{values.dtype}: must be numbers, a row per sample, with columns {list(columns)}"
        )
    table = values[:, columns].T.astype(float)
    known = np.full(table.shape[1], _rounding(values[:, columns[0]]))
    return _table(asked, table, known, ())


def _netcdf(asked: Asked) -> Lines:
    import netCDF4

    with netCDF4.Dataset(asked.path) as data:
        x, z = _variables(asked, data.variables)
        own = tuple(str(getattr(variable, "units", "")) for variable in (x, z))
        known = np.full(x.size, _rounding(x[:]))
        heights = np.moveaxis(_plain(z[:]), z.dimensions.index(x.dimensions[0]), -1)
        table = np.vstack([_plain(x[:]), heights.reshape(-1, x.size)])
    return _table(asked, table, known, own)


def _variables(asked: Asked, variables: dict) -> tuple:
    """Return the variables of positions and heights of a netCDF file."""
    if asked.columns:
        names = asked.columns
    else:
        heights = [n for n, v in variables.items() if v.ndim and (n,) != v.dimensions]
        last = variables[heights[0]].dimensions[-1] if len(heights) == 1 else ""
        names = (last, *heights)
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
    if not asked.path.is_file():
        raise FileNotFoundError("no such file")
    topography = SurfaceTopography.read_topography(str(asked.path))
    unit = asked.units[:1] or (str(topography.unit or ""),)
    if topography.dim == 2:  # a map: every row along x is a line
        x = np.arange(topography.nb_grid_pts[0]) * topography.pixel_size[0]
        heights = _plain(topography.heights()).T
    else:
        x, z = topography.positions_and_heights()
        heights = _plain(z)[None, :]
    known = np.full(len(x), _rounding(x))
    return _table(asked, np.vstack([x, heights]), known, (*unit, *unit))


def _table(asked: Asked, table: np.ndarray, known: np.ndarray, own: tuple[str, ...]) -> Lines:
    """Return lines of the rows of a table: positions, then the heights of each line.

    known : to how much each position is known. own : units that the file itself names.
    """
    if not np.isfinite(table).all():
        row, sample = np.argwhere(~np.isfinite(table))[0]
        what = f"line {row} of {len(table) - 1}" if row else "positions"
        raise UserError(
            f"{KEY} = {asked.name!r}: {what}: sample {sample + 1} is {table[row, sample]}: all "
            "must be finite; fill gaps in first"
        )
    units = _units(asked, own, len(table))
    if table.shape[1] < LEAST_SAMPLES:
        raise UserError(
            f"{KEY} = {asked.name!r}: {table.shape[1]} samples per line: needs at least "
            f"{LEAST_SAMPLES}"
        )
    step = uniform_step(KEY, asked.name, table[0], known)
    heights = table[1:] * np.array([[_metres(unit)] for unit in units[1:]])
    if step < 0.0:
        heights = heights[:, ::-1]
    whose = "as given" if asked.units else "as the file names them"
    notes = (
        f"{asked.name}: {len(heights)} of {table.shape[1]} samples, {abs(step):.6g} {units[0]} "
        f"apart in the mean, heights in {units[1]}, units {whose}"
    )
    return Lines(heights, abs(step) * _metres(units[0]), notes)


def _units(asked: Asked, own: tuple[str, ...], rows: int) -> tuple[str, ...]:
    """Return one unit per row of a table: as asked for, else as the file names them."""
    units = asked.units or own
    if not units or any(metres(unit) is None for unit in units):
        named = f"names {list(units)}" if any(units) else "names none"
        raise UserError(
            f"surface.units: missing: {asked.name!r} {named}; give those of positions and heights, "
            'as units = ["mm", "um"]'
        )
    return units[:1] + (units[1:] if len(units) == rows else units[1:2] * (rows - 1))


def _metres(unit: str) -> float:
    factor = metres(unit)
    assert factor is not None  # _units has looked
    return factor


def _numbered(asked: Asked) -> tuple[int, ...]:
    """Return the numbers of columns of a table; a netCDF file has names instead."""
    columns = asked.columns or USUAL_COLUMNS
    if not all(isinstance(column, int) for column in columns):
        raise UserError(
            f"surface.columns = {list(columns)!r}: {asked.name!r} has numbered columns, from 0"
        )
    return columns


def _plain(values: Any) -> np.ndarray:
    """Return floats, NaN where a value is masked."""
    return np.ma.filled(np.ma.asarray(values, dtype=float), np.nan)


def _rounding(values: Any) -> float:
    """Return to how much binary numbers of a type are known: four steps of the largest."""
    plain = np.ma.getdata(values)
    return 4.0 * float(np.spacing(np.abs(plain).max())) if plain.dtype.kind == "f" else 0.0


READERS: dict[str, Callable[[Asked], Lines]] = {
    ".txt": _text,
    ".csv": _text,
    ".npy": _npy,
    ".nc": _netcdf,
}
