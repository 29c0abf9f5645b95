"""Lines in the units of a file, and their conversion to m: units, steps, gaps."""

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ...ground import UserError, counted
from ...text_tables import unit_of
from .gaps import gaps_filled, marked_gaps, marked_spikes
from .positions import uniform_step

KEY = "surface.file"
MIN_SAMPLES = 8
MAX_MAP_ASPECT = 2  # of the sides of a map; others are strips
MAX_STEP = 0.1  # m, from sample to sample; a longer one is in another unit
SPIKE_SLOPE = 3.0  # from one sample to the next; source: ISO 13473-1:2019, 7.5


class LineFile(NamedTuple):
    """File of measured lines, with the settings for reading it."""

    path: Path
    name: str  # of the file, as written in the study
    columns: tuple = ()  # of positions, then heights: numbers, or names of variables
    units: tuple[str, ...] = ()  # of positions and heights; empty: those of the file
    step: float | None = None  # m, between samples; replaces positions
    gaps: str = "refuse"  # treatment of missing samples
    spikes: str = "refuse"  # treatment of spikes

    @property
    def prefix(self) -> str:
        """Return the start of messages: key and file."""
        return f"{KEY} = {self.name!r}"

    def refused(self, reason: str) -> UserError:
        """Return the error with a reason to refuse the file, and the remedy."""
        return UserError(f"{self.prefix}: {reason}")


class RawLines(NamedTuple):
    """Lines in the units of a file, with their metadata."""

    heights: np.ndarray  # shape (lines, n), NaN if a sample is missing
    units: tuple[str, ...]  # of positions, then one for each line or one for all; "" if absent
    description: str  # columns or variables, in words
    x: np.ndarray | None = None  # positions, shape (n,); None: the step is known
    precision: np.ndarray | float = 0.0  # of the positions
    step: float = 0.0  # m, if positions are absent
    row_spacing: float | None = None  # m, of the rows of a map; None: not stated


class Lines(NamedTuple):
    """Lines of a file in m."""

    heights: np.ndarray  # shape (lines, n)
    step: float  # m, between samples
    size: str  # number of lines and samples, in words
    notes: str  # units, columns and repairs, in words
    row_spacing: float | None = None  # m, of the rows of a map; None: not stated


def metres(unit: str) -> float | None:
    """Return the length (m) of a unit such as µm, UM or micron; None if it is not a length."""
    known = unit_of(unit)
    return known.factor if known is not None and known.family == "length" else None


def row_spacing(positions: np.ndarray, unit: str) -> float | None:
    """Return the mean distance of rows (m), or None if it is not known."""
    factor = metres(unit)
    if factor is None or positions.size < 2:
        return None
    return factor * float(np.ptp(positions)) / (positions.size - 1)


def plain(values: Any) -> np.ndarray:
    """Return values as floats, NaN if masked. Raises TypeError for complex numbers."""
    if np.iscomplexobj(values):
        raise TypeError("heights must not be complex")
    return np.ma.filled(np.ma.asarray(values, dtype=float), np.nan)


def check_numbered(file: LineFile) -> None:
    """Raise UserError if columns are requested by name from a file with numbered columns."""
    if not all(isinstance(column, int) for column in file.columns):
        raise UserError(
            f"surface.columns = {list(file.columns)!r}: {file.name!r} has numbered columns, from 0"
        )


def lines_of(file: LineFile, raw: RawLines) -> Lines:
    """Return lines in m, with equal steps and without gaps.

    Raises UserError for missing samples, unless surface.gaps states their treatment, for spikes at
    gaps, unless surface.spikes does, for missing units, for too few samples, for a step above
    MAX_STEP, and for positions that are not uniform.
    """
    if raw.x is not None and not np.isfinite(raw.x).all():
        sample = int(np.argmin(np.isfinite(raw.x)))
        raise file.refused(
            f"the position of sample {sample + 1} is missing: give surface.step in place of "
            "positions, or write it"
        )
    heights, gap_note = marked_gaps(file.prefix, raw.heights, file.gaps)
    unit, (of_positions, *of_lines) = _factors(file, raw)
    samples, step = heights.shape[1], raw.step
    if samples < MIN_SAMPLES:
        raise file.refused(f"{samples} samples per line: needs at least {MIN_SAMPLES}")
    if raw.x is not None:
        step = uniform_step(file.prefix, raw.x, raw.precision) * of_positions
    if abs(step) > MAX_STEP:
        raise file.refused(
            f"samples are {abs(step):.4g} m apart: must be at most {MAX_STEP:g} m; give "
            "surface.units, or the heights as text with the step that the instrument states"
        )
    if len(of_lines) != len(raw.heights):  # one unit for all lines
        of_lines = of_lines[:1] * len(raw.heights)
    in_metres = np.array(of_lines[: len(heights)])[:, None]
    least = SPIKE_SLOPE * abs(step) / in_metres
    heights, spike_note = marked_spikes(file.prefix, heights, least, file.spikes)
    heights = gaps_filled(file.prefix, heights) * in_metres
    if step < 0.0:
        heights = heights[:, ::-1]
    distance = f"{abs(step):.6g} m apart{' in the mean' if raw.x is not None else ''}"
    units = f"heights in {unit}, units {'as given' if file.units else 'as the file names them'}"
    size = f"{counted(len(heights), 'line')} of {samples} samples, {distance}"
    notes = "; ".join(filter(None, (units, raw.description, gap_note, spike_note)))
    return Lines(heights, abs(step), size, notes, raw.row_spacing)


def _factors(file: LineFile, raw: RawLines) -> tuple[str, list[float]]:
    """Return the unit of heights, and the factors to m of positions and of lines.

    The units of the user replace those of the file. The factor is 0 for absent positions.
    """
    units = file.units or raw.units
    factors = [metres(unit) or 0.0 for unit in units]
    if len(units) < 2 or 0.0 in (factors if raw.x is not None else factors[1:]):
        stated = f"names {list(units)}" if any(units) else "names none"
        raise UserError(
            f"surface.units: missing: {file.name!r} {stated}; give those of positions and heights, "
            'as units = ["mm", "um"]'
        )
    return units[1], factors
