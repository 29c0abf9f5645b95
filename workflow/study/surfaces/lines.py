"""Lines of a table of positions and heights: units, gaps, steps, whatever file it stood in."""

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ...errors import UserError
from .prepare import uniform_step
from .units import metres

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
