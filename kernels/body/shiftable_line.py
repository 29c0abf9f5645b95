"""Heights and slopes of a line at any position over the elements of a foundation at rest."""

from typing import NamedTuple

import numpy as np

from ..compile.jit import inlined_kernel, kernel
from ..lines.polynomials import (
    bernstein_coefficients,
    sample_derivatives,
    septic_coefficients,
    septic_slope,
)
from .ground import (
    CELL_SAMPLES,
    fill_heights,
    fill_slopes,
    fill_thresholds,
    first_sample,
    lowest_heights,
)


class ShiftableLine(NamedTuple):
    """Two periods of a line: one polynomial for each interval (lines/polynomials.py)."""

    polynomials: np.ndarray  # shape (8, 2 n): coefficients of the heights, in h
    lowest: np.ndarray  # lower bounds of the heights in cells of CELL_SAMPLES intervals
    steps_per_spacing: float


@kernel
def shiftable_line(z, slope, m):
    """Return a line that can be evaluated at any position; m : samples per spacing, a float."""
    n, spacing = z.size, 1.0 / m
    bend = sample_derivatives(z, slope, spacing)
    polynomials = np.empty((8, 2 * n))
    lowest = np.full((2 * n + CELL_SAMPLES - 1) // CELL_SAMPLES, np.inf)
    for j in range(2 * n):
        c = septic_coefficients(z, slope, bend, spacing, j % n)
        b = bernstein_coefficients(c)
        for power in range(8):
            polynomials[power, j] = c[power]
            lowest[j // CELL_SAMPLES] = min(lowest[j // CELL_SAMPLES], b[power])
    return ShiftableLine(polynomials, lowest, m)


@inlined_kernel
def interval_at(line, place):
    """Return (j, t): the interval over element 0 and the position in it; place : in samples."""
    whole = np.floor(place)
    return (-int(whole) - 1) % (line.polynomials.shape[1] // 2), place - whole


@lowest_heights.register(ShiftableLine)
def _lowest(ground):
    return ground.lowest


@first_sample.register(ShiftableLine)
def _first_sample(ground, place):
    return interval_at(ground, place)[0]


@fill_heights.register(ShiftableLine)
def _fill_heights(ground, place, first, z):
    j, t = interval_at(ground, place)
    for i in range(z.size):
        z[i] = height_at(ground.polynomials, j + first + i, t)


@fill_thresholds.register(ShiftableLine)
def _fill_thresholds(ground, place, first, n, w, c):
    j, t = interval_at(ground, place)
    for i in range(min(c.size, n - first)):
        c[i] = height_at(ground.polynomials, j + first + i, t) - w[i]


@inlined_kernel
def height_at(c, j, t):
    """Return the height at t of interval j; c : polynomials of a ShiftableLine."""
    high = c[4, j] + t * (c[5, j] + t * (c[6, j] + t * c[7, j]))
    return c[0, j] + t * (c[1, j] + t * (c[2, j] + t * (c[3, j] + t * high)))


@fill_slopes.register(ShiftableLine)
def _fill_slopes(ground, step, lag, first, n, slope):
    (j, t), m = interval_at(ground, step.after), ground.steps_per_spacing
    count = min(slope.size, n - first)
    for i in range(count):
        slope[i] = -m * slope_at(ground.polynomials, j + first + i, t)
    j, t = interval_at(ground, step.before)
    for i in range(count if lag > 0.0 else 0):
        before = -m * slope_at(ground.polynomials, j + first + i, t)
        slope[i] += lag * (before - slope[i])


@inlined_kernel
def slope_at(c, j, t):
    """Return the derivative with respect to t of ``height_at``."""
    if t == 0.0:
        return c[1, j]
    low, high = (c[0, j], c[1, j], c[2, j], c[3, j]), (c[4, j], c[5, j], c[6, j], c[7, j])
    return septic_slope(low + high, t)
