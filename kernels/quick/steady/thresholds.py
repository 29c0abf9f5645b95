"""Thresholds of whole spans: the indentations above which they stay in contact or under pressure.

The threshold t_j of contact is defined in spans.py. Thresholds depend on the speed, but not on the
load.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from .spans import SPAN


class Thresholds(NamedTuple):
    """Largest thresholds of the whole spans at one speed, and of the whole line."""

    contact: np.ndarray  # of t_j, shape (n // SPAN,): contact lasts in a span if d lies above it
    pressure: np.ndarray  # of z - vbar z', shape (n // SPAN,): p > 0 if d + d' lies above it
    line_contact: float  # largest t_j of the line
    line_pressure: float  # largest z - vbar z' of the line


@kernel
def thresholds_of(z, slope, speed, stiffness):
    """Return the Thresholds at ``speed`` (vbar). stiffness : K of the law (rheology/law.py)."""
    n = z.size
    contact, pressure = np.empty(n // SPAN), pressure_thresholds(z, slope, speed)
    in_span = np.empty(SPAN)
    inner = (n - 1) // SPAN  # spans whose upstream neighbour lies in the array
    line_contact = -np.inf
    for b in range(inner):
        h = z[b * SPAN : b * SPAN + SPAN + 1]
        for k in range(SPAN):
            in_span[k] = h[k + 1] + stiffness * (h[k] - h[k + 1])
        contact[b] = _largest(in_span)
        line_contact = max(line_contact, contact[b])
    tail = -np.inf
    for j in range(inner * SPAN, n):
        ahead = z[j + 1 if j + 1 < n else 0]
        tail = max(tail, ahead + stiffness * (z[j] - ahead))
    contact[inner:] = tail  # a whole span that ends the line
    return Thresholds(contact, pressure[:-1], max(line_contact, tail), pressure[-1])


@kernel
def pressure_thresholds(z, slope, speed):
    """Return the largest z - vbar z' of every whole span and, last, of all samples."""
    count = z.size // SPAN
    pressure = np.empty(count + 1)
    in_span = np.empty(SPAN)
    highest = -np.inf
    for b in range(count):
        h, s = z[b * SPAN : b * SPAN + SPAN], slope[b * SPAN : b * SPAN + SPAN]
        for k in range(SPAN):
            in_span[k] = h[k] - speed * s[k]
        pressure[b] = _largest(in_span)
        highest = max(highest, pressure[b])
    for j in range(count * SPAN, z.size):
        highest = max(highest, z[j] - speed * slope[j])
    pressure[count] = highest
    return pressure


@kernel
def pressure_thresholds_at(z, slope, speeds):
    """Return the pressure_thresholds at several speeds (vbar), one row for each speed."""
    pressure = np.empty((speeds.size, z.size // SPAN + 1))
    for k in range(speeds.size):
        at_speed = pressure_thresholds(z, slope, speeds[k])
        for b in range(at_speed.size):
            pressure[k, b] = at_speed[b]
    return pressure


@refcount_free_kernel
def _largest(values):
    """Return the largest of SPAN values, which are overwritten. Halving lets loops vectorise."""
    for half in (8, 4, 2, 1):
        for k in range(half):
            values[k] = max(values[k], values[half + k])
    return values[0]
