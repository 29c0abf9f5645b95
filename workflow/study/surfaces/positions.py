"""Positions of samples: their precision and step, and grids from the points of a map."""

import math
from array import array
from collections.abc import Iterable
from decimal import Decimal
from typing import Any, NamedTuple

import numpy as np

from ...ground import UserError

STEP_TOLERANCE = 0.01  # deviation of uniform positions, in steps
MIN_ROUNDED_SHARE = 0.01  # minimum share of uneven steps if positions are rounded
MIN_GRID_SHARE = 0.5  # minimum share of the points of a grid that a list contains


def uniform_step(prefix: str, x: np.ndarray, precision: np.ndarray | float) -> float:
    """Return the step of uniform positions; it is negative if they descend.

    prefix : start of an error message. precision : of the positions. The step is the slope of a
    fitted straight line. Positions written with few decimals have uneven steps, such as 0.1 and
    0.2; they must lie within their precision of the line.

    Raises UserError if the positions are not uniform. A single longer step is a gap, even if the
    precision is as coarse as a step.
    """
    step, uneven, even = _fitted_step(x, precision)
    if step == 0.0 or not even:
        steps, worst = np.diff(x), int(np.argmax(uneven))
        raise UserError(
            f"{prefix}: sample {worst + 2} is {steps[worst]:.6g} after the one before, in "
            f"the mean steps are {step:.6g}: bring the samples to equal steps first"
        )
    return step


def is_uniform(x: np.ndarray, precision: np.ndarray | float) -> bool:
    """Return whether values ascend or descend in equal steps, like positions and unlike heights."""
    if x.size < 2:
        return False
    step, _, even = _fitted_step(x, precision)
    return bool(even and abs(step) > 0.0 and np.all(np.diff(x) * step >= 0.0))


def _fitted_step(x: np.ndarray, precision: np.ndarray | float) -> tuple[float, np.ndarray, bool]:
    """Return the fitted step, the deviations of steps from their median, and whether all fit."""
    index = np.arange(x.size) - 0.5 * (x.size - 1)
    step = float(np.sum(index * (x - x.mean())) / np.sum(index**2))
    off = np.abs(x - x.mean() - step * index)
    steps = np.diff(x)
    uneven = np.abs(steps - np.median(steps))
    even = np.all(off <= STEP_TOLERANCE * abs(step))
    rounded_steps = np.count_nonzero(uneven > 0.5 * np.broadcast_to(precision, x.shape)[1:])
    if not even and rounded_steps >= max(2.0, MIN_ROUNDED_SHARE * x.size):
        even = np.all(off <= precision + STEP_TOLERANCE * abs(step))
    return step, uneven, bool(even)


def rounding(values: Any) -> float:
    """Return the precision of binary numbers: four spacings of the largest; 0 for integers."""
    bare = np.ma.getdata(values)
    return 4.0 * float(np.spacing(np.abs(bare).max())) if bare.dtype.kind == "f" else 0.0


def precision(written: Iterable[str]) -> np.ndarray:
    """Return the precision of written numbers: 0.1 for 1499.8, and for 3 in the same column.

    Formats limit the decimals or the digits of numbers, and may omit trailing zeros. Therefore the
    finest decimal and the largest number of digits in the column apply to the whole column.
    """
    finest, max_digits, numbers = math.inf, 0, array("d")
    for word in written:
        number = Decimal(word).as_tuple()
        finest = min(finest, int(number.exponent))  # an error for NaN, which no number is
        max_digits = max(max_digits, len(number.digits))
        numbers.append(float(word))
    sizes = np.abs(numbers)
    with np.errstate(divide="ignore"):
        leading = np.floor(np.log10(sizes))
    return np.maximum(float(f"1e{finest}"), 10.0 ** (leading - max_digits + 1.0))


class PointGrid(NamedTuple):
    """Points of a map, sorted into lines."""

    x: np.ndarray  # positions along a line, ascending, shape (n,)
    heights: np.ndarray  # shape (lines, n), NaN without a point
    rows: np.ndarray  # positions of the lines, ascending, shape (lines,)
    first: np.ndarray  # first row of the list with each position, shape (n,)
    turned: bool  # whether the lines run along the second coordinate


def repeats(x: np.ndarray) -> bool:
    """Return whether positions repeat as in a map: each at least twice on average."""
    return 2 * np.unique(x).size <= x.size


def grid_of(x: np.ndarray, y: np.ndarray, z: np.ndarray, along_x: bool) -> PointGrid | None:
    """Return the lines of a list of points, or None if the points do not form a grid.

    along_x : whether lines run along x; otherwise they run along the coordinate that changes more
    often from point to point. All arrays have the shape (points,).
    """
    turned = not along_x and bool(np.count_nonzero(np.diff(y)) > np.count_nonzero(np.diff(x)))
    along, across = (y, x) if turned else (x, y)
    positions, first, column = np.unique(along, return_index=True, return_inverse=True)
    lines, row = np.unique(across, return_inverse=True)
    if lines.size * positions.size * MIN_GRID_SHARE > z.size or lines.size < 2:
        return None
    heights = np.full((lines.size, positions.size), np.nan)
    if np.unique(row * positions.size + column).size < z.size:  # a point occurs twice
        return None
    heights[row, column] = z
    return PointGrid(positions, heights, lines, first, turned)
