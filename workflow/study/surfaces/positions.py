"""Positions of samples: to how much they are known, their step, and grids of points of a map."""

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np

from ...ground import UserError

UNEVEN = 0.01  # of a step: positions that are off by less are uniform
MIXED = 0.01  # of the steps: so many must be of another length where all of them are rounded
FILLED = 0.5  # of the points of a grid that a list must hold


def uniform_step(key: str, name: str, x: np.ndarray, precision: np.ndarray) -> float:
    """Return the step of uniform positions, negative where they descend.

    precision : to how much each position is known, shape of x. Positions that are written with
    few decimals step unevenly, now by 0.1 and now by 0.2; then the straight line fitted to them
    must pass within a decimal of all. Its slope is the step. The length of n samples is n steps.

    Raises UserError where the positions are not uniform. A single longer step is a gap, even
    where a decimal is as long as a step.
    """
    step, uneven, even = _fitted(x, precision)
    if step == 0.0 or not even:
        steps, worst = np.diff(x), int(np.argmax(uneven))
        raise UserError(
            f"{key} = {name!r}: sample {worst + 2} is {steps[worst]:.6g} after the one before, in "
            f"the mean steps are {step:.6g}: bring the samples to equal steps first"
        )
    return step


def is_uniform(x: np.ndarray, precision: np.ndarray) -> bool:
    """Return whether values go up or down in equal steps, as positions do and heights do not."""
    step, _, even = _fitted(x, precision)
    return bool(even and abs(step) > 0.0 and np.all(np.diff(x) * step >= 0.0))


def _fitted(x: np.ndarray, precision: np.ndarray) -> tuple[float, np.ndarray, bool]:
    """Return the step of a straight line, how far each step is from the usual, and if all fit."""
    index = np.arange(x.size) - 0.5 * (x.size - 1)
    step = float(np.sum(index * (x - x.mean())) / np.sum(index**2))
    off = np.abs(x - x.mean() - step * index)
    steps = np.diff(x)
    uneven = np.abs(steps - np.median(steps))
    even = np.all(off <= UNEVEN * abs(step))
    other = np.count_nonzero(uneven > 0.5 * precision[1:])
    if not even and other >= max(2.0, MIXED * x.size):
        even = np.all(off <= precision + UNEVEN * abs(step))
    return step, uneven, bool(even)


def rounding(values: Any) -> float:
    """Return to how much binary numbers of a type are known: four steps of the largest."""
    bare = np.ma.getdata(values)
    return 4.0 * float(np.spacing(np.abs(bare).max())) if bare.dtype.kind == "f" else 0.0


def precision(written: Iterable[str]) -> np.ndarray:
    """Return to how much each number is written: 0.1 for 1499.8, also for 3 in the same column.

    Formats cut numbers after a decimal or after a count of digits, and may leave out zeros at the
    end; so the finest decimal and the largest count of digits of the column hold for all of it.
    """
    words = list(written)
    parts = [_parts(word) for word in words]
    finest = min(exponent for _, exponent in parts)
    most = max(digits for digits, _ in parts)
    sizes = np.array([abs(float(word)) for word in words])
    with np.errstate(divide="ignore"):
        leading = np.floor(np.log10(sizes))
    return np.maximum(10.0**finest, 10.0 ** (leading - most + 1.0))


def _parts(word: str) -> tuple[int, int]:
    """Return the count of digits and the exponent of the last one of a written number."""
    mantissa, _, exponent = word.lower().partition("e")
    whole, _, decimals = mantissa.lstrip("+-").partition(".")
    digits = len((whole + decimals).lstrip("0"))
    return digits, int(exponent or 0) - len(decimals)


class PointGrid(NamedTuple):
    """A list of points of a map, put in order."""

    x: np.ndarray  # positions along a line, ascending, shape (n,)
    heights: np.ndarray  # shape (lines, n), NaN where the list holds no point
    rows: np.ndarray  # the positions of the lines, ascending, shape (lines,)
    first: np.ndarray  # the row of the list that holds each position of x, shape (n,)
    turned: bool  # whether the lines run along the second coordinate


def repeats(x: np.ndarray) -> bool:
    """Return whether positions come back so often that they are those of a map, not of a line."""
    return 2 * np.unique(x).size <= x.size


def grid_of(x: np.ndarray, y: np.ndarray, z: np.ndarray, along_x: bool) -> PointGrid | None:
    """Return the lines of a list of points, None where the points fill no grid.

    along_x : whether lines run along x; else they run along the coordinate that changes more often
    from point to point. All arrays have the shape (points,).
    """
    turned = not along_x and bool(np.count_nonzero(np.diff(y)) > np.count_nonzero(np.diff(x)))
    along, across = (y, x) if turned else (x, y)
    positions, first, column = np.unique(along, return_index=True, return_inverse=True)
    lines, row = np.unique(across, return_inverse=True)
    if lines.size * positions.size * FILLED > z.size or lines.size < 2:
        return None
    heights = np.full((lines.size, positions.size), np.nan)
    if np.unique(row * positions.size + column).size < z.size:  # a point twice
        return None
    heights[row, column] = z
    return PointGrid(positions, heights, lines, first, turned)
