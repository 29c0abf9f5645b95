"""Thresholds of whole spans: above which indentation they stay in contact, or under pressure.

What a threshold is stands in spans.py. They depend on the speed, and serve all loads.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from .spans import SPAN


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
    each = np.empty(SPAN)
    whole = (n - 1) // SPAN  # spans with a sample of the array upstream of them
    stay_all = -np.inf
    for b in range(whole):
        h = z[b * SPAN : b * SPAN + SPAN + 1]
        for k in range(SPAN):
            each[k] = h[k + 1] + stiffness * (h[k] - h[k + 1])
        stay[b] = _largest(each)
        stay_all = max(stay_all, stay[b])
    rest = -np.inf
    for j in range(whole * SPAN, n):
        ahead = z[j + 1 if j + 1 < n else 0]
        rest = max(rest, ahead + stiffness * (z[j] - ahead))
    stay[whole:] = rest  # of a whole span that ends the line
    return Thresholds(stay, press[:-1], max(stay_all, rest), press[-1])


@kernel
def presses_of(z, slope, speed):
    """Return the largest z - vbar z' of every whole span, and at last that of all samples."""
    count = z.size // SPAN
    press = np.empty(count + 1)
    each = np.empty(SPAN)
    highest = -np.inf
    for b in range(count):
        h, s = z[b * SPAN : b * SPAN + SPAN], slope[b * SPAN : b * SPAN + SPAN]
        for k in range(SPAN):
            each[k] = h[k] - speed * s[k]
        press[b] = _largest(each)
        highest = max(highest, press[b])
    for j in range(count * SPAN, z.size):
        highest = max(highest, z[j] - speed * slope[j])
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


@refcount_free_kernel
def _largest(each):
    """Return the largest number of a span; they change. By halves: many are compared at once."""
    for half in (8, 4, 2, 1):
        for k in range(half):
            each[k] = max(each[k], each[half + k])
    return each[0]
