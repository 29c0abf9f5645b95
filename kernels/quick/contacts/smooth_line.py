"""A smooth line between its samples: bounds, integrals and zeros of its polynomials."""

import math
from typing import NamedTuple

import numpy as np

from ...compile.jit import inlined_kernel, kernel, refcount_free_kernel
from ...lines.polynomials import (
    bending,
    bernstein_coefficients,
    coefficients_between,
    sample_derivatives,
    septic_coefficients,
    septic_height,
    septic_slope,
)
from ...root_search import new_search, next_guess
from ..steady.spans import SPAN

THIRD_NODE = math.sqrt(0.6)
NO_ZERO = 2.0  # returned for t: beyond every interval
LAST_NEWTON_STEP, LAST_HALLEY_STEP = 1e-8, 1e-4  # in t
# Nodes and weights of Gauss-Legendre quadrature on [0, 1]: exact to the ninth degree, and to 1e-12
# for products of two polynomials of a line with eight samples in its shortest wave.
GAUSS_POINTS = tuple(
    (0.5 + 0.5 * x, 0.5 * w) for x, w in np.transpose(np.polynomial.legendre.leggauss(5)).tolist()
)


class IntervalBounds(NamedTuple):
    """Bounds and integrals for each interval of a line, or for each span of SPAN intervals."""

    low: np.ndarray  # lower bound of z
    high: np.ndarray  # upper bound of z
    min_slope: np.ndarray  # lower bound of z'
    area: np.ndarray  # integral of z
    square: np.ndarray  # integral of z'^2


class SmoothLine(NamedTuple):
    """A line between its n samples, shared by all loads and speeds."""

    z: np.ndarray  # in h, shape (n,)
    slope: np.ndarray  # in h/dx, shape (n,)
    bend: np.ndarray  # second and third derivative, in h/dx^2 and h/dx^3, shape (2, n)
    spacing: float  # of the samples, in dx
    intervals: IntervalBounds  # shape (n,)
    spans: IntervalBounds  # shape (n // SPAN,)
    deepest: tuple[int, float, float]  # interval, t and height of the deepest point


@kernel
def smooth_line(z, slope, spacing):
    """Return the SmoothLine through samples. z (in h), slope (in h/dx) : shape (n,)."""
    n = z.size
    bend = sample_derivatives(z, slope, spacing)
    intervals, spans = _allocate(n), _allocate(n // SPAN)
    for j in range(n - 1):  # without a branch, so that the loop vectorises
        _fill_interval(z, slope, bend, spacing, j + 1, j, intervals)
    _fill_interval(z, slope, bend, spacing, 0, n - 1, intervals)
    low, high, min_slope, area, square = intervals
    for b in range(n // SPAN):
        lowest, minus_highest, least_slope, areas, squares = np.inf, np.inf, np.inf, 0.0, 0.0
        for j in range(b * SPAN, (b + 1) * SPAN):
            lowest, minus_highest = lower(lowest, low[j]), lower(minus_highest, -high[j])
            least_slope = lower(least_slope, min_slope[j])
            areas, squares = areas + area[j], squares + square[j]
        spans.low[b], spans.high[b], spans.min_slope[b] = lowest, -minus_highest, least_slope
        spans.area[b], spans.square[b] = areas, squares
    deepest = _deepest_point(z, slope, bend, spacing, low)
    return SmoothLine(z, slope, bend, spacing, intervals, spans, deepest)


@inlined_kernel
def lower(one, other):
    """Return the lower of two numbers; unlike min, without a branch for NaN."""
    return one if one < other else other


@inlined_kernel
def _fill_interval(z, slope, bend, spacing, k, j, intervals):
    """Fill in the IntervalBounds of the interval from sample j to the next sample, k."""
    c = coefficients_between(z, slope, bend, spacing, k, j)
    b0, b1, b2, b3, b4, b5, b6, b7 = bernstein_coefficients(c)
    intervals.low[j] = lower(
        lower(lower(b0, b1), lower(b2, b3)), lower(lower(b4, b5), lower(b6, b7))
    )
    intervals.high[j] = -lower(
        lower(lower(-b0, -b1), lower(-b2, -b3)), lower(lower(-b4, -b5), lower(-b6, -b7))
    )
    fall = lower(lower(b0 - b1, b1 - b2), lower(b2 - b3, b3 - b4))
    intervals.min_slope[j] = 7.0 / spacing * lower(fall, lower(lower(b4 - b5, b5 - b6), b6 - b7))
    intervals.area[j] = spacing * 0.125 * (((b0 + b1) + (b2 + b3)) + ((b4 + b5) + (b6 + b7)))
    intervals.square[j] = slope_square(c, 0.0, 1.0) / spacing


@kernel
def _allocate(n):
    """Return empty IntervalBounds of n intervals."""
    return IntervalBounds(np.empty(n), np.empty(n), np.empty(n), np.empty(n), np.empty(n))


@kernel
def span_of(j, left):
    """Return the span that elements enter with interval j and pass entirely, or -1.

    Elements pass intervals in descending order. left : number of intervals still to pass.
    """
    return j // SPAN if j % SPAN == SPAN - 1 and left >= SPAN else -1


@kernel
def pressure(c, d, lag):
    """Return the coefficients of p = d - z + vbar z' (eq. 3). lag : vbar over the spacing."""
    c0, c1, c2, c3, c4, c5, c6, c7 = c
    return (
        d - c0 - lag * c1,
        -c1 - 2.0 * lag * c2,
        -c2 - 3.0 * lag * c3,
        -c3 - 4.0 * lag * c4,
        -c4 - 5.0 * lag * c5,
        -c5 - 6.0 * lag * c6,
        -c6 - 7.0 * lag * c7,
        -c7,
    )


@kernel
def integral(c, start, stop):
    """Return the integral of a polynomial from t = start to stop, by three Gauss points.

    The rule is exact to degree five. Higher terms are small with eight samples in a wave.
    """
    middle, half = 0.5 * (start + stop), 0.5 * (stop - start)
    out = THIRD_NODE * half
    sides = septic_height(c, middle - out) + septic_height(c, middle + out)
    return half * (8.0 * septic_height(c, middle) + 5.0 * sides) / 9.0


@inlined_kernel
def slope_square(c, start, stop):
    """Return the integral of the square of the derivative from t = start to stop."""
    total = 0.0
    for node, weight in GAUSS_POINTS:
        slope = septic_slope(c, start + node * (stop - start))
        total += weight * slope * slope
    return total * (stop - start)


@kernel
def products(p, c, start, stop):
    """Return the integrals of p and of p c' from t = start to stop."""
    of_p = of_product = 0.0
    for node, weight in GAUSS_POINTS:
        t = start + node * (stop - start)
        value = weight * septic_height(p, t)
        of_p += value
        of_product += value * septic_slope(c, t)
    return of_p * (stop - start), of_product * (stop - start)


@refcount_free_kernel
def _deepest_point(z, slope, bend, spacing, low):
    """Return (interval, t, height) of the deepest point of the line."""
    interval = 0
    for j in range(z.size):
        interval = j if z[j] < z[interval] else interval
    place, lowest = 1.0, z[interval]
    for j in range(z.size):
        if low[j] < lowest:
            c = septic_coefficients(z, slope, bend, spacing, j)
            if septic_slope(c, 0.0) < 0.0 < septic_slope(c, 1.0):
                t = _minimum(c, 0.0, 0.0, 0.0, 1.0)
                if septic_height(c, t) < lowest:
                    interval, place, lowest = j, t, septic_height(c, t)
    return interval, place, lowest


@kernel
def _minimum(c, u, a, start, stop):
    """Return the t of the minimum of f (first_zero), which falls at start and rises at stop."""
    search = new_search(0.5 * (start + stop), start, stop, np.inf)
    while not search.ended:
        _, slope, bend = derivatives_at(c, u, a, start, search.x)
        search = next_guess(search, search.x, slope, bend, 0.0, 0.0, LAST_NEWTON_STEP)
    return search.x


@kernel
def first_zero(c, u, a, start, stop, fresh):
    """Return the first t from start to stop where f <= 0, or NO_ZERO.

    f(t) = c(t) - u e^(-a (t - start)), u <= 0. fresh : False if f is zero at ``start`` and positive
    just after it; a zero is then sought only if f(stop) < 0.
    """
    begin, fall = septic_height(c, start) - u, septic_slope(c, start) + a * u
    if fresh and begin <= 0.0:
        return start
    end, rise, _ = derivatives_at(c, u, a, start, stop)
    if end >= 0.0:
        if not fresh or fall >= 0.0 or rise <= 0.0:
            return NO_ZERO
        stop = _minimum(c, u, a, start, stop)
        end, _, _ = derivatives_at(c, u, a, start, stop)
        if end >= 0.0:
            return NO_ZERO
    width, t = stop - start, 0.5 * (start + stop)
    if fresh:
        fall *= width
        root = math.sqrt(max(fall * fall - 4.0 * (end - begin - fall) * begin, 0.0))
        guess = start + width * (2.0 * begin / (root - fall))  # zero of the parabola
        t = guess if start < guess < stop else t
    search = new_search(t, start, stop, np.inf)
    while not search.ended:
        value, slope, bend = derivatives_at(c, u, a, start, search.x)
        search = next_guess(search, search.x, -value, -slope, -bend, 0.0, LAST_HALLEY_STEP)
    return search.x


@inlined_kernel
def derivatives_at(c, u, a, start, t):
    """Return (value, derivative, second derivative) of c(t) - u e^(-a (t - start))."""
    if u == 0.0:
        return septic_height(c, t), septic_slope(c, t), bending(c, t)
    free = u * math.exp(-a * (t - start))
    return septic_height(c, t) - free, septic_slope(c, t) + a * free, bending(c, t) - a * a * free
