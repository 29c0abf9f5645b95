"""Files of measured lines: text, npy, netCDF, and what SurfaceTopography reads; units and steps."""

import re
import unicodedata
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ...errors import UserError
from ..settings import BrokenRowError, Rows, read_rows

METRES = {
    **dict.fromkeys(("m", "meter", "meters", "metre", "metres"), 1.0),
    **dict.fromkeys(("cm", "centimeter", "centimeters", "centimetre", "centimetres"), 1e-2),
    **dict.fromkeys(("mm", "millimeter", "millimeters", "millimetre", "millimetres"), 1e-3),
    **dict.fromkeys(("um", "micrometer", "micrometers", "micrometre", "micrometres"), 1e-6),
    **dict.fromkeys(("micron", "microns"), 1e-6),
    **dict.fromkeys(("nm", "nanometer", "nanometers", "nanometre", "nanometres"), 1e-9),
    **dict.fromkeys(("å", "angstrom", "angstroms", "ångström"), 1e-10),
    **dict.fromkeys(("pm", "picometer", "picometers", "picometre", "picometres"), 1e-12),
}
BETWEEN = re.compile(r"[^\w]+|_")


def metres(unit: str) -> float | None:
    """Return the metres of a unit of length, or None where the word is none: µm, UM, micron …."""
    # Both characters for micro, and letters with a ring, have one form each.
    word = unicodedata.normalize("NFKC", unit.strip()).replace("μ", "u")
    return METRES.get(word.lower()) if word != "M" else None


def units_in(text: str) -> list[str]:
    """Return the units of length among the words of a line of a header, in order."""
    return [word for word in BETWEEN.split(text) if word and metres(word) is not None]


UNEVEN = 0.01  # of a step: positions that are off by less are uniform
MIXED = 0.01  # of the steps: so many must be of another length where all of them are rounded
KEY = "surface.file"
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


def lines_of(asked: Asked, table: np.ndarray, known: np.ndarray, own: tuple[str, ...]) -> Lines:
    """Return lines of the rows of a table: positions, then the heights of each line.

    known : to how much each position is known. own : units that the file itself names.
    """
    _check_finite(asked, table)
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
        f"{asked.name}: {len(heights)} {'line' if len(heights) == 1 else 'lines'} of "
        f"{table.shape[1]} samples, {abs(step):.6g} {units[0]} apart in the mean, heights in "
        f"{units[1]}, units {whose}"
    )
    return Lines(heights, abs(step) * _metres(units[0]), notes)


def uniform_step(key: str, name: str, x: np.ndarray, precision: np.ndarray) -> float:
    """Return the step of uniform positions, negative where they descend.

    precision : to how much each position is known, shape of x. Positions that are written with
    few decimals step unevenly, now by 0.1 and now by 0.2; then the straight line fitted to them
    must pass within a decimal of all. Its slope is the step. The length of n samples is n steps.

    Raises UserError where the positions are not uniform. A single longer step is a gap, even
    where a decimal is as long as a step.
    """
    index = np.arange(x.size) - 0.5 * (x.size - 1)
    step = float(np.sum(index * (x - x.mean())) / np.sum(index**2))
    off = np.abs(x - x.mean() - step * index)
    steps = np.diff(x)
    uneven = np.abs(steps - np.median(steps))
    even = np.all(off <= UNEVEN * abs(step))
    other = np.count_nonzero(uneven > 0.5 * precision[1:])
    if not even and other >= max(2.0, MIXED * x.size):
        even = np.all(off <= precision + UNEVEN * abs(step))
    if step == 0.0 or not even:
        worst = int(np.argmax(uneven))
        raise UserError(
            f"{key} = {name!r}: sample {worst + 2} is {steps[worst]:.6g} after the one before, in "
            f"the mean steps are {step:.6g}: bring the samples to equal steps first"
        )
    return step


def _check_finite(asked: Asked, table: np.ndarray) -> None:
    if not np.isfinite(table).all():
        row, sample = np.argwhere(~np.isfinite(table))[0]
        what = f"line {row} of {len(table) - 1}" if row else "positions"
        raise UserError(
            f"{KEY} = {asked.name!r}: {what}: sample {sample + 1} is {table[row, sample]}: all "
            "must be finite; fill gaps in first"
        )


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


def plain(values: Any) -> np.ndarray:
    """Return floats, NaN where a value is masked."""
    return np.ma.filled(np.ma.asarray(values, dtype=float), np.nan)


def rounding(values: Any) -> float:
    """Return to how much binary numbers of a type are known: four steps of the largest."""
    bare = np.ma.getdata(values)
    return 4.0 * float(np.spacing(np.abs(bare).max())) if bare.dtype.kind == "f" else 0.0


HEADER = 3  # lines before the numbers in which units are looked for


class Table(NamedTuple):
    """The columns asked for."""

    values: np.ndarray  # shape (columns, rows)
    written: tuple[str, ...]  # the numbers of the first column as they are written
    units: tuple[str, ...]  # of each column, from the header; empty where it names none


def read_text(key: str, name: str, data: bytes, columns: tuple[int, ...]) -> Table:
    """Return columns of a text file; ``key`` and ``name`` of the file are for messages.

    Raises UserError for a file without rows, and naming the line for a row that breaks off, holds
    words or numbers that are not finite.
    """
    try:
        rows = read_rows(data, columns)
    except BrokenRowError as error:
        raise UserError(
            f"{key} = {name!r}: {error}: must hold finite numbers in columns {list(columns)}"
        ) from None
    if not rows.lines:
        raise UserError(f"{key} = {name!r}: holds no line with numbers in columns {list(columns)}")
    return Table(rows.values, rows.written, _units_of_header(rows, columns))


def _units_of_header(rows: Rows, columns: tuple[int, ...]) -> tuple[str, ...]:
    """Return one unit per column from the lines just before the numbers, or none."""
    for line in reversed(rows.header[-HEADER:]):
        words = line.lstrip("#%/! ").split(rows.delimiter)
        if max(columns) < len(words):
            found = [units_in(words[column])[-1:] for column in columns]
            if all(found):
                return tuple(unit for (unit,) in found)
        units = units_in(line)  # "x [um] z [um]" has blanks within its titles
        if len(units) > max(columns):
            return tuple(units[column] for column in columns)
    return ()


def precision(written: Iterable[str]) -> np.ndarray:
    """Return to how much each number is written: 0.1 for 1499.8, also for 3 in the same column.

    Formats cut numbers after a decimal or after a count of digits, and may leave out zeros at the
    end; so the finest decimal and the largest count of digits of the column hold for all of it.
    """
    parts = [_parts(word) for word in written]
    finest = min(exponent for _, exponent in parts)
    most = max(digits for digits, _ in parts)
    sizes = np.array([abs(float(word)) for word in written])
    with np.errstate(divide="ignore"):
        leading = np.floor(np.log10(sizes))
    return np.maximum(10.0**finest, 10.0 ** (leading - most + 1.0))


def _parts(word: str) -> tuple[int, int]:
    """Return the count of digits and the exponent of the last one of a written number."""
    mantissa, _, exponent = word.lower().partition("e")
    whole, _, decimals = mantissa.lstrip("+-").partition(".")
    digits = len((whole + decimals).lstrip("0"))
    return digits, int(exponent or 0) - len(decimals)


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
