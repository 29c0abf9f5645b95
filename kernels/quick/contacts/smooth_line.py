"""A smooth line between its samples: bounds and sums of its polynomials, and their zeros."""

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
from ..steady.spans import SPAN

THIRD_NODE = math.sqrt(0.6)
NEVER = 2.0  # a t behind every interval
SURE = 1e-4  # of an interval, or of the way to where f is least: steps so small are the last ones
HALVINGS = 60  # at most: then an interval is as short as its rounding
# Points and weights of Gauss and Legendre from 0 to 1: exact to the ninth degree, and to 1e-12
# of the products of two polynomials of a line that has eight samples in its shortest wave.
GAUSS = tuple(
    (0.5 + 0.5 * x, 0.5 * w) for x, w in np.transpose(np.polynomial.legendre.leggauss(5)).tolist()
)


class Pieces(NamedTuple):
    """What is known of intervals of a line, or of spans of SPAN of them: arrays of one shape."""

    low: np.ndarray  # not above any height in it
    high: np.ndarray  # not below any
    flat: np.ndarray  # not above any slope
    area: np.ndarray  # integral of z over it
    square: np.ndarray  # integral of z'^2


class SmoothLine(NamedTuple):
    """A line between its samples, and what is shared by all loads and speeds; n intervals."""

    z: np.ndarray  # in h, shape (n,), as the next
    slope: np.ndarray  # in h/dx
    bend: np.ndarray  # second and third derivative, in h/dx^2 and h/dx^3, shape (2, n)
    spacing: float  # of the samples, in dx
    each: Pieces  # its intervals, shape (n,)
    spans: Pieces  # shape (n // SPAN,)
    deepest: tuple[int, float, float]  # interval, t and height of the deepest point


@kernel
def smooth_line(z, slope, spacing):
    """Return the SmoothLine of samples. z (in h), slope (in h/dx) : shape (n,)."""
    n = z.size
    bend = sample_derivatives(z, slope, spacing)
    each, spans = _room(n), _room(n // SPAN)
    for j in range(n - 1):  # without a branch, so that several are found at once
        _fill_interval(z, slope, bend, spacing, j + 1, j, each)
    _fill_interval(z, slope, bend, spacing, 0, n - 1, each)
    low, high, flat, area, square = each
    for b in range(n // SPAN):
        lowest, above, flattest, areas, squares = np.inf, np.inf, np.inf, 0.0, 0.0
        for j in range(b * SPAN, (b + 1) * SPAN):
            lowest, above = lower(lowest, low[j]), lower(above, -high[j])
            flattest, areas, squares = (
                lower(flattest, flat[j]),
                areas + area[j],
                squares + square[j],
            )
        spans.low[b], spans.high[b], spans.flat[b] = lowest, -above, flattest
        spans.area[b], spans.square[b] = areas, squares
    deepest = _deepest_point(z, slope, bend, spacing, low)
    return SmoothLine(z, slope, bend, spacing, each, spans, deepest)


@inlined_kernel
def lower(one, other):
    """Return the lower of two numbers, without the branch that min takes for NaN."""
    return one if one < other else other


@inlined_kernel
def _fill_interval(z, slope, bend, spacing, k, j, each):
    """Fill in the Pieces ``each`` of the interval from sample j to k, the next."""
    c = coefficients_between(z, slope, bend, spacing, k, j)
    b0, b1, b2, b3, b4, b5, b6, b7 = bernstein_coefficients(c)
    each.low[j] = lower(lower(lower(b0, b1), lower(b2, b3)), lower(lower(b4, b5), lower(b6, b7)))
    each.high[j] = -lower(
        lower(lower(-b0, -b1), lower(-b2, -b3)), lower(lower(-b4, -b5), lower(-b6, -b7))
    )
    fall = lower(lower(b0 - b1, b1 - b2), lower(b2 - b3, b3 - b4))
    each.flat[j] = 7.0 / spacing * lower(fall, lower(lower(b4 - b5, b5 - b6), b6 - b7))
    each.area[j] = spacing * 0.125 * (((b0 + b1) + (b2 + b3)) + ((b4 + b5) + (b6 + b7)))
    each.square[j] = squared(c, 0.0, 1.0) / spacing


@kernel
def _room(n):
    return Pieces(np.empty(n), np.empty(n), np.empty(n), np.empty(n), np.empty(n))


@kernel
def span_of(j, left):
    """Return which span begins with interval j where elements come to it; -1 if none does.

    Elements come to intervals from high numbers to low ones. left : how many there are to come to.
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
    """Return the integral of a polynomial from t = start to stop, by three points.

    They are exact to the fifth degree, and the rest is small in eight samples of a wave.
    """
    middle, half = 0.5 * (start + stop), 0.5 * (stop - start)
    out = THIRD_NODE * half
    return (
        half
        * (
            8.0 * septic_height(c, middle)
            + 5.0 * (septic_height(c, middle - out) + septic_height(c, middle + out))
        )
        / 9.0
    )


@inlined_kernel
def squared(c, start, stop):
    """Return the integral of the square of the derivative from t = start to stop."""
    total = 0.0
    for node, weight in GAUSS:
        slope = septic_slope(c, start + node * (stop - start))
        total += weight * slope * slope
    return total * (stop - start)


@kernel
def products(p, c, start, stop):
    """Return the integrals from t = start to stop of a polynomial, and of it times that of c'."""
    one = other = 0.0
    for node, weight in GAUSS:
        t = start + node * (stop - start)
        some = weight * septic_height(p, t)
        one += some
        other += some * septic_slope(c, t)
    return one * (stop - start), other * (stop - start)


@refcount_free_kernel
def _deepest_point(z, slope, bend, spacing, low):
    """Return (interval, t, height) of the deepest point of the line."""
    best = 0
    for j in range(z.size):
        best = j if z[j] < z[best] else best
    at, least = 1.0, z[best]
    for j in range(z.size):
        if low[j] < least:
            c = septic_coefficients(z, slope, bend, spacing, j)
            if septic_slope(c, 0.0) < 0.0 < septic_slope(c, 1.0):
                t = _valley(c, 0.0, 0.0, 0.0, 1.0)
                if septic_height(c, t) < least:
                    best, at, least = j, t, septic_height(c, t)
    return best, at, least


@kernel
def _valley(c, u, a, start, stop):
    """Return where f of first_zero is least: it falls at start and rises at stop."""
    low, high = start, stop
    t = 0.5 * (start + stop)
    for _ in range(HALVINGS):
        _, slope, bend = three_at(c, u, a, start, t)
        if slope < 0.0:
            low = t
        else:
            high = t
        new = t - slope / bend
        if abs(new - t) <= SURE * SURE:  # before it is compared with the bounds, of which t is one
            return min(max(new, start), stop)
        t = new if low < new < high else 0.5 * (low + high)
    return t


@kernel
def first_zero(c, u, a, start, stop, fresh):
    """Return the first t from start to stop where f is not positive; NEVER, where it is throughout.

    f(t) = c(t) - u e^(-a (t - start)), u <= 0. fresh : whether f is positive at ``start``; else
    it is zero there and positive at first, and is looked for where f is negative at ``stop`` alone.
    """
    begin, fall = septic_height(c, start) - u, septic_slope(c, start) + a * u
    if fresh and begin <= 0.0:
        return start
    end, rise, _ = three_at(c, u, a, start, stop)
    if end >= 0.0:
        if not fresh or fall >= 0.0 or rise <= 0.0:
            return NEVER
        stop = _valley(c, u, a, start, stop)
        end, _, _ = three_at(c, u, a, start, stop)
        if end >= 0.0:
            return NEVER
    low, high, width = start, stop, stop - start
    t = 0.5 * (low + high)
    if fresh:
        fall *= width
        root = math.sqrt(max(fall * fall - 4.0 * (end - begin - fall) * begin, 0.0))
        guess = start + width * (2.0 * begin / (root - fall))  # of the parabola
        t = guess if low < guess < high else t
    for _ in range(HALVINGS):
        value, slope, bend = three_at(c, u, a, start, t)
        if value >= 0.0:
            low = t
        else:
            high = t
        bottom = 2.0 * slope * slope - value * bend
        new = t - 2.0 * value * slope / bottom if bottom != 0.0 else t
        if abs(value) <= SURE * abs(slope) and abs(value * bend) <= SURE * slope * slope:
            return min(max(new, start), stop)
        if not low < new < high:
            new = 0.5 * (low + high)
        t = new
    return t


@inlined_kernel
def three_at(c, u, a, start, t):
    """Return c(t) - u e^(-a (t - start)), its derivative and the second one."""
    if u == 0.0:
        return septic_height(c, t), septic_slope(c, t), bending(c, t)
    left = u * math.exp(-a * (t - start))
    return septic_height(c, t) - left, septic_slope(c, t) + a * left, bending(c, t) - a * a * left
