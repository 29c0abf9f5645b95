"""Lines as a file holds them, and as they are in m: units, steps, gaps."""

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ...ground import UserError
from ...text_tables import unit_of
from .gaps import without_gaps
from .positions import uniform_step

KEY = "surface.file"
MIN_SAMPLES = 8


class LineFile(NamedTuple):
    """How a file is to be read."""

    path: Path
    name: str  # of the file as the study gives it
    columns: tuple = ()  # positions, then heights: numbers, or names of variables
    units: tuple[str, ...] = ()  # of positions and heights; empty: the file names them
    step: float | None = None  # m, of samples, in place of positions
    gaps: str = "refuse"  # what becomes of missing samples


class RawLines(NamedTuple):
    """Lines as a file holds them, and what it says of them."""

    heights: np.ndarray  # shape (lines, n), NaN where a sample is missing
    x: np.ndarray | None  # positions, shape (n,); None: the step is known
    known: np.ndarray  # to how much each position is known, shape (n,)
    step: float | None  # m, where there are no positions
    units: tuple[str, ...]  # of positions and of each line, or of all lines; "" where none is
    description: str = ""  # what was taken for what
    row_spacing: float | None = None  # m, of the rows of a map; None: not stated


class Lines(NamedTuple):
    """Lines of a file in m."""

    heights: np.ndarray  # shape (lines, n)
    step: float
    notes: str
    row_spacing: float | None = None  # m, of the rows of a map; None: not stated


def metres(unit: str) -> float | None:
    """Return the metres of a unit of length, or None where the word is none: µm, UM, micron …."""
    found = unit_of(unit)
    return found.factor if found is not None and found.family == "length" else None


def row_spacing(positions: np.ndarray, unit: str) -> float | None:
    """Return how far rows at these positions are apart (m); None where nobody says."""
    factor = metres(unit)
    if factor is None or positions.size < 2:
        return None
    return factor * float(np.ptp(positions)) / (positions.size - 1)


def plain(values: Any) -> np.ndarray:
    """Return floats, NaN where a value is masked. Raises TypeError for complex numbers."""
    if np.iscomplexobj(values):
        raise TypeError("complex numbers are no heights")
    return np.ma.filled(np.ma.asarray(values, dtype=float), np.nan)


def check_numbered(asked: LineFile) -> None:
    """Raise UserError where columns of a file that has no names are asked for by name."""
    if not all(isinstance(column, int) for column in asked.columns):
        raise UserError(
            f"surface.columns = {list(asked.columns)!r}: {asked.name!r} has numbered columns, "
            "from 0"
        )


def lines_of(asked: LineFile, raw: RawLines) -> Lines:
    """Return lines in m: in equal steps, without gaps, with units that somebody names.

    Raises UserError for missing samples, unless surface.gaps says what becomes of them, for units
    that nobody names, for too few samples, and for positions that are not uniform.
    """
    what = f"{KEY} = {asked.name!r}"
    samples = raw.heights.shape[1]
    if raw.x is not None and not np.isfinite(raw.x).all():
        sample = int(np.argmin(np.isfinite(raw.x)))
        raise UserError(
            f"{what}: the position of sample {sample + 1} is missing: give surface.step in place "
            "of positions, or write it"
        )
    heights, mended = without_gaps(what, raw.heights, asked.gaps)
    unit, (of_positions, *of_lines) = _factors(asked, raw)
    if samples < MIN_SAMPLES:
        raise UserError(f"{what}: {samples} samples per line: needs at least {MIN_SAMPLES}")
    step = raw.step
    if raw.x is not None:
        step = uniform_step(KEY, asked.name, raw.x, raw.known) * of_positions
    assert step is not None
    if len(of_lines) != len(raw.heights):  # one unit for all
        of_lines = of_lines[:1] * len(raw.heights)
    heights = heights * np.array(of_lines[: len(heights)])[:, None]
    if step < 0.0:
        heights = heights[:, ::-1]
    whose = "as given" if asked.units else "as the file names them"
    count = f"{len(heights)} {'line' if len(heights) == 1 else 'lines'} of {samples} samples"
    apart = f"{abs(step):.6g} m apart{' in the mean' if raw.x is not None else ''}"
    parts = [
        f"{asked.name}: {count}, {apart}, heights in {unit}, units {whose}",
        *filter(None, (raw.description, mended)),
    ]
    return Lines(heights, abs(step), "; ".join(parts), raw.row_spacing)


def _factors(asked: LineFile, raw: RawLines) -> tuple[str, list[float]]:
    """Return the unit of heights, and the metres of those of positions and of lines.

    They are as asked for, else as the file names them; 0 for that of positions where none are.
    """
    units = asked.units or raw.units
    factors = [metres(unit) or 0.0 for unit in units]
    if len(units) < 2 or 0.0 in (factors if raw.x is not None else factors[1:]):
        named = f"names {list(units)}" if any(units) else "names none"
        raise UserError(
            f"surface.units: missing: {asked.name!r} {named}; give those of positions and heights, "
            'as units = ["mm", "um"]'
        )
    return units[1], factors
