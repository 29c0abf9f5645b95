"""Thresholds of whole spans: above which indentation they stay in contact, or under pressure.

What a threshold is stands in spans.py. They depend on the speed, and serve all loads.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import borrowing, kernel
from .spans import SPAN, larger

EIGHT = 8  # samples that are compared at once, in the vector registers of the processor


class Thresholds(NamedTuple):
    """Largest thresholds of every whole span at one speed, each of shape (n // SPAN,)."""

    stay: np.ndarray  # of t_j: below d, contact lasts
    press: np.ndarray  # of z - vbar z': below d + d', the pressure is positive
    stay_all: float  # the same of all samples of the line
    press_all: float


@kernel
def thresholds_of(z, slope, speed, stiffness):
    """Return the Thresholds at ``speed`` (vbar). stiffness : K of the law (rheology/law.py)."""
    n = z.size
    stay, press = np.empty(n // SPAN), presses_of(z, slope, speed)
    eight = np.empty(EIGHT)
    whole = (n - 1) // SPAN  # spans with a sample of the array upstream of them
    stay_all = -np.inf
    for b in range(whole):
        h = z[b * SPAN : b * SPAN + SPAN + 1]
        for k in range(EIGHT):
            hold = h[k + 1] + stiffness * (h[k] - h[k + 1])
            other = h[k + 9] + stiffness * (h[k + 8] - h[k + 9])
            eight[k] = hold if hold > other else other
        stay[b] = _largest(eight)
        stay_all = larger(stay_all, stay[b])
    rest = -np.inf
    for j in range(whole * SPAN, n):
        ahead = z[j + 1 if j + 1 < n else 0]
        rest = larger(rest, ahead + stiffness * (z[j] - ahead))
    stay[whole:] = rest  # of a whole span that ends the line
    return Thresholds(stay, press[:-1], larger(stay_all, rest), press[-1])


@kernel
def presses_of(z, slope, speed):
    """Return the largest z - vbar z' of every whole span, and at last that of all samples."""
    count = z.size // SPAN
    press = np.empty(count + 1)
    eight = np.empty(EIGHT)
    highest = -np.inf
    for b in range(count):
        h, s = z[b * SPAN : b * SPAN + SPAN], slope[b * SPAN : b * SPAN + SPAN]
        for k in range(EIGHT):
            push, other = h[k] - speed * s[k], h[k + 8] - speed * s[k + 8]
            eight[k] = push if push > other else other
        press[b] = _largest(eight)
        highest = larger(highest, press[b])
    for j in range(count * SPAN, z.size):
        highest = larger(highest, z[j] - speed * slope[j])
    press[count] = highest
    return press


@kernel
def presses_at(z, slope, speeds):
    """Return what presses_of returns at several speeds (vbar), one row for each."""
    press = np.empty((speeds.size, z.size // SPAN + 1))
    for k in range(speeds.size):
        found = presses_of(z, slope, speeds[k])
        for b in range(found.size):
            press[k, b] = found[b]
    return press


@borrowing
def _largest(e):
    """Return the largest of eight numbers."""
    one, other = larger(larger(e[0], e[4]), larger(e[1], e[5])), larger(e[2], e[6])
    return larger(one, larger(other, larger(e[3], e[7])))
