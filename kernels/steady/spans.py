"""Spans: what is known of sixteen samples in a row, so that most need not be visited.

In steady sliding at indentation d the sample upstream of j is j + 1. If j + 1 touches, its element
comes with E (z_{j+1} - d), E the decay of a step, and j touches where z_j - d lies below that:

    d > t_j = (z_j - E z_{j+1}) / (1 - E) = z_{j+1} + K (z_j - z_{j+1}),   K = 1 / (1 - E).

So a span entered in contact stays in contact throughout where d lies above the largest of its t_j,
and then its forces are sums over its heights. A span that is entered free, at u, is left free, at
E^16 u, where its lowest sample lies higher than that over -d.
"""

from typing import NamedTuple

import numpy as np

from kernels.jit import kernel

SPAN = 16


class Spans(NamedTuple):
    """Sums over the whole spans of a line, each of shape (n // SPAN,), and over all of it.

    Of heights and slopes from those of the first sample, z0 and s0: sums over spans that lie
    high or steep lose no digits.
    """

    lowest: np.ndarray  # height
    steepest: np.ndarray  # largest |z'|
    height: np.ndarray  # sum of z - z0
    slope: np.ndarray  # sum of z' - s0
    work: np.ndarray  # sum of (z - z0) (z' - s0)
    square: np.ndarray  # sum of (z' - s0)^2
    whole: np.ndarray  # shape (4,): the four sums over all samples, from the first of the line
    deepest: int  # sample, the lowest one


class Thresholds(NamedTuple):
    """Largest thresholds of every whole span at one speed, each of shape (n // SPAN,)."""

    stay: np.ndarray  # of t_j: below d, contact lasts
    press: np.ndarray  # of z - vbar z': below d + d', the pressure is positive
    stay_all: float  # the same of all samples of the line
    press_all: float


@kernel
def spans_of(z, slope):
    """Return the Spans of a line. z (in h), slope (in h/dx) : shape (n,)."""
    count = z.size // SPAN
    lowest, steepest = np.empty(count), np.empty(count)
    sums = np.empty((4, count))
    whole = np.zeros(4)
    for b in range(count):
        first = b * SPAN
        a0 = a1 = a2 = a3 = steep = 0.0
        low = z[first]
        for j in range(first, first + SPAN, 4):
            four = _four(z, slope, j, z[first], slope[first])
            a0, a1, a2, a3 = a0 + four[0], a1 + four[1], a2 + four[2], a3 + four[3]
            low, steep = _smaller(low, four[4]), _larger(steep, four[5])
        lowest[b], steepest[b] = low, steep
        sums[0, b], sums[1, b], sums[2, b], sums[3, b] = a0, a1, a2, a3
        a, c = z[first] - z[0], slope[first] - slope[0]
        whole[0] += a0 + SPAN * a
        whole[1] += a1 + SPAN * c
        whole[2] += a2 + a * a1 + c * (a0 + SPAN * a)
        whole[3] += a3 + c * (2.0 * a1 + SPAN * c)
    for j in range(count * SPAN, z.size):
        a, c = z[j] - z[0], slope[j] - slope[0]
        whole[0] += a
        whole[1] += c
        whole[2] += a * c
        whole[3] += c * c
    deepest = int(np.argmin(z))
    return Spans(lowest, steepest, sums[0], sums[1], sums[2], sums[3], whole, deepest)


@kernel
def _four(z, slope, j, z0, s0):
    """Return the sums, the lowest height and the largest |z'| of four samples from j on."""
    a, b, c, d = z[j] - z0, z[j + 1] - z0, z[j + 2] - z0, z[j + 3] - z0
    p, q, r, s = slope[j] - s0, slope[j + 1] - s0, slope[j + 2] - s0, slope[j + 3] - s0
    low = _smaller(_smaller(z[j], z[j + 1]), _smaller(z[j + 2], z[j + 3]))
    steep = _larger(
        _larger(abs(slope[j]), abs(slope[j + 1])), _larger(abs(slope[j + 2]), abs(slope[j + 3]))
    )
    work, square = (a * p + b * q) + (c * r + d * s), (p * p + q * q) + (r * r + s * s)
    return (a + b) + (c + d), (p + q) + (r + s), work, square, low, steep


@kernel
def _smaller(a, b):
    return a if a < b else b


@kernel
def _larger(a, b):
    return a if a > b else b


@kernel
def thresholds_of(z, slope, speed, stiffness):
    """Return the Thresholds at ``speed`` (vbar). stiffness : K of the law (rheology/law.py)."""
    n = z.size
    count = n // SPAN
    stay, press = np.empty(count), np.empty(count)
    stay_all = press_all = -np.inf
    for b in range(count + 1):
        hold = push = other_hold = other_push = -np.inf
        first, stop = b * SPAN, min((b + 1) * SPAN, n - 1)
        for j in range(first, stop - 1, 2):
            h, i, k = z[j], z[j + 1], z[j + 2]
            hold = _larger(hold, i + stiffness * (h - i))
            other_hold = _larger(other_hold, k + stiffness * (i - k))
            push = _larger(push, h - speed * slope[j])
            other_push = _larger(other_push, i - speed * slope[j + 1])
        for j in range(stop - (stop - first) % 2, min((b + 1) * SPAN, n)):
            ahead = z[j + 1 if j + 1 < n else 0]
            hold = _larger(hold, ahead + stiffness * (z[j] - ahead))
            push = _larger(push, z[j] - speed * slope[j])
        hold, push = _larger(hold, other_hold), _larger(push, other_push)
        if b < count:
            stay[b], press[b] = hold, push
        stay_all, press_all = _larger(stay_all, hold), _larger(press_all, push)
    return Thresholds(stay, press, stay_all, press_all)
