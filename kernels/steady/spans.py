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
    for b in range(count + 1):
        first, stop = b * SPAN, min((b + 1) * SPAN, z.size)
        if first == stop:
            break
        z0, s0 = z[first], slope[first]
        low, steep = np.inf, 0.0
        a0 = a1 = a2 = a3 = 0.0
        for j in range(first, stop):
            a, c = z[j] - z0, slope[j] - s0
            low = min(low, z[j])
            steep = max(steep, abs(slope[j]))
            a0 += a
            a1 += c
            a2 += a * c
            a3 += c * c
        if b < count:
            lowest[b], steepest[b] = low, steep
            sums[0, b], sums[1, b], sums[2, b], sums[3, b] = a0, a1, a2, a3
        a, c = z0 - z[0], s0 - slope[0]
        whole[0] += a0 + (stop - first) * a
        whole[1] += a1 + (stop - first) * c
        whole[2] += a2 + a * a1 + c * (a0 + (stop - first) * a)
        whole[3] += a3 + c * (2.0 * a1 + (stop - first) * c)
    return Spans(lowest, steepest, sums[0], sums[1], sums[2], sums[3], whole, int(np.argmin(z)))


@kernel
def thresholds_of(z, slope, speed, stiffness):
    """Return the Thresholds at ``speed`` (vbar). stiffness : K of the law (rheology/law.py)."""
    n = z.size
    count = n // SPAN
    stay, press = np.empty(count), np.empty(count)
    stay_all = press_all = -np.inf
    for b in range(count + 1):
        hold = push = -np.inf
        for j in range(b * SPAN, min((b + 1) * SPAN, n)):
            ahead = z[j + 1 if j + 1 < n else 0]
            hold = max(hold, ahead + stiffness * (z[j] - ahead))
            push = max(push, z[j] - speed * slope[j])
        if b < count:
            stay[b], press[b] = hold, push
        stay_all, press_all = max(stay_all, hold), max(press_all, push)
    return Thresholds(stay, press, stay_all, press_all)
