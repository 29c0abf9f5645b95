"""Heights and slopes of a line at any position over the elements of a foundation at rest."""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..lines.polynomials import (
    bernstein_coefficients,
    sample_derivatives,
    septic_coefficients,
    septic_slope,
)
from ..scene.march_blocks import CELL_SAMPLES


class Places(NamedTuple):
    """Positions of a surface before and after a step, in samples."""

    before: float
    after: float


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


@kernel
def interval_at(line, place):
    """Return (j, t): the interval over element 0 and the position in it; place : in samples."""
    whole = np.floor(place)
    return (-int(whole) - 1) % (line.polynomials.shape[1] // 2), place - whole


@kernel
def heights_at(line, j, t, z):
    """Fill z with heights at consecutive elements, starting with the one at t of interval j."""
    c0, c1, c2, c3, c4, c5, c6, c7 = line.polynomials[:, j : j + z.size]
    if t == 0.0:
        z[:] = c0
        return
    for i in range(z.size):
        high = c4[i] + t * (c5[i] + t * (c6[i] + t * c7[i]))
        z[i] = c0[i] + t * (c1[i] + t * (c2[i] + t * (c3[i] + t * high)))


@kernel
def slope_at(line, j, t):
    """Return the slope at t of interval j, in h/dx."""
    c, m = line.polynomials, line.steps_per_spacing
    if t == 0.0:
        return -m * c[1, j]
    low, high = (c[0, j], c[1, j], c[2, j], c[3, j]), (c[4, j], c[5, j], c[6, j], c[7, j])
    return -m * septic_slope(low + high, t)
