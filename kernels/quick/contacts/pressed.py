"""What of a contact is pressed: pressures, their sum and friction at any indentation.

A sample is pressed where d + d' lies above its threshold z - vbar z'. Of the spans that touch all
over, most are pressed all over and known by their sums; the samples of the others, which one finds
at a first guess, are listed.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ..steady.spans import FIRST, HEIGHT, SLOPE, SPAN, STEEP, Spans
from .touching import Touching

SIDE = 16  # partial sums, of four samples at a time


class MovingLine(NamedTuple):
    """A line, its spans, and the speed at which pressures are asked for."""

    z: np.ndarray  # in h, shape (n,)
    slope: np.ndarray  # in h/dx, shape (n,)
    spans: Spans
    speed: float  # vbar
    press: np.ndarray  # largest z - vbar z' of the spans (spans.py)


class Pressed(NamedTuple):
    """What touches, and thresholds of the pressure."""

    line: MovingLine
    touching: Touching
    threshold: np.ndarray  # of the samples that are touching one by one
    loose: np.ndarray  # thresholds of samples of spans that the guess does not press all over
    slope: np.ndarray  # of those samples
    spans: np.ndarray  # numbers of the spans that it does
    first: np.ndarray  # thresholds of their first samples
    sums: np.ndarray  # over each, of thresholds less the first


@kernel
def room_for_pressed(samples):
    """Return arrays with room for all of a line that Pressed needs."""
    spans = samples // SPAN + 1
    each = np.empty(samples), np.empty(samples), np.empty(samples)
    return each, np.empty(spans, np.int64), np.empty((2, spans))


@kernel
def pressed(line, touching, guess, room):
    """Return Pressed in the memory of ``room``. guess : of d + d'."""
    z, slope, spans, speed, press = line
    rows = spans.rows
    (threshold, loose, steep), numbers, (first, sums) = room
    threshold = threshold[: touching.weight.size]
    for i in range(threshold.size):
        threshold[i] = touching.height[i] - speed * touching.slope[i]
    count = whole = 0
    for b in touching.spans:
        j = b * SPAN
        if press[b] < guess:
            numbers[whole] = b
            first[whole] = rows[b, FIRST] - speed * rows[b, STEEP]
            sums[whole] = rows[b, HEIGHT] - speed * rows[b, SLOPE]
            whole += 1
        else:
            for k in range(SPAN):
                loose[count + k], steep[count + k] = z[j + k] - speed * slope[j + k], slope[j + k]
            count += SPAN
    some = loose[:count], steep[:count]
    return Pressed(line, touching, threshold, *some, numbers[:whole], first[:whole], sums[:whole])


@refcount_free_kernel
def span_under(line, b, deep):
    """Return (sum of p, sum of p z', number) over the samples of span b with pressure p > 0."""
    normal = tangential = count = 0.0
    for k in range(b * SPAN, (b + 1) * SPAN):
        p = deep - (line.z[k] - line.speed * line.slope[k])
        if p > 0.0:
            normal += p
            tangential += p * line.slope[k]
            count += 1.0
    return normal, tangential, count


@kernel
def weighed_side_by_side(threshold, weight, slope, deep):
    """Return (sum of w p, sum of w p z', sum of w) over samples with pressure p > 0.

    weight : w, or None where it is 1. slope : z', or None where only forces are asked for. Partial
    sums in a fixed order, all in one array: so the compiler adds several at once.
    """
    sums = np.zeros(3 * SIDE)
    whole = threshold.size - threshold.size % (4 * SIDE)
    for first in range(0, whole, 4 * SIDE):
        for k in range(SIDE):
            i = first + k
            p = _at_sample(threshold, weight, slope, i, deep)
            q = _at_sample(threshold, weight, slope, i + SIDE, deep)
            r = _at_sample(threshold, weight, slope, i + 2 * SIDE, deep)
            s = _at_sample(threshold, weight, slope, i + 3 * SIDE, deep)
            sums[k] += (p[0] + q[0]) + (r[0] + s[0])
            sums[SIDE + k] += (p[2] + q[2]) + (r[2] + s[2])
            if slope is not None:
                sums[2 * SIDE + k] += (p[1] + q[1]) + (r[1] + s[1])
    for i in range(whole, threshold.size):
        k, p = i % SIDE, _at_sample(threshold, weight, slope, i, deep)
        sums[k] += p[0]
        sums[SIDE + k] += p[2]
        sums[2 * SIDE + k] += p[1]
    normal = tangential = count = 0.0
    for k in range(SIDE):
        normal, count = normal + sums[k], count + sums[SIDE + k]
        tangential += sums[2 * SIDE + k]
    return normal, tangential, count


@refcount_free_kernel
def _at_sample(threshold, weight, slope, i, deep):
    """Return (w p, w p z', w) of a sample, or zeros where p is not positive."""
    p = deep - threshold[i]
    p = p if p > 0.0 else 0.0
    share = 1.0 if weight is None else weight[i]
    share = share if p > 0.0 else 0.0
    force = share * p
    return force, (0.0 if slope is None else force * slope[i]), share
