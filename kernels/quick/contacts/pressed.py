"""What of a contact is pressed: pressures, their sum and friction at any indentation.

A sample is pressed where d + d' lies above its threshold z - vbar z'. Of the spans that touch all
over, most are pressed all over and known by their sums; the samples of the others, which one finds
at a first guess, are listed.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import borrowing, kernel
from ..steady.spans import FIRST, HEIGHT, SLOPE, SPAN, STEEP, Spans
from .touching import Touching


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


@borrowing
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


@borrowing
def weighed_in_fours(threshold, weight, slope, deep):
    """Return (sum of w p, sum of w p z', sum of w) over samples with pressure p > 0.

    weight : w, or None where it is 1. slope : z', or None where only forces are asked for. Four
    partial sums in a fixed order.
    """
    n0 = n1 = n2 = n3 = t0 = t1 = t2 = t3 = c0 = c1 = c2 = c3 = 0.0
    whole = threshold.size - threshold.size % 4
    for i in range(0, whole, 4):
        p0, p1 = deep - threshold[i], deep - threshold[i + 1]
        p2, p3 = deep - threshold[i + 2], deep - threshold[i + 3]
        if weight is None:
            w0, w1 = (1.0 if p0 > 0.0 else 0.0), (1.0 if p1 > 0.0 else 0.0)
            w2, w3 = (1.0 if p2 > 0.0 else 0.0), (1.0 if p3 > 0.0 else 0.0)
        else:
            w0, w1 = (weight[i] if p0 > 0.0 else 0.0), (weight[i + 1] if p1 > 0.0 else 0.0)
            w2, w3 = (weight[i + 2] if p2 > 0.0 else 0.0), (weight[i + 3] if p3 > 0.0 else 0.0)
        c0, c1, c2, c3 = c0 + w0, c1 + w1, c2 + w2, c3 + w3
        w0, w1, w2, w3 = w0 * p0, w1 * p1, w2 * p2, w3 * p3
        n0, n1, n2, n3 = n0 + w0, n1 + w1, n2 + w2, n3 + w3
        if slope is not None:
            t0, t1 = t0 + w0 * slope[i], t1 + w1 * slope[i + 1]
            t2, t3 = t2 + w2 * slope[i + 2], t3 + w3 * slope[i + 3]
    for i in range(whole, threshold.size):
        p0 = deep - threshold[i]
        if p0 > 0.0:
            w0 = 1.0 if weight is None else weight[i]
            c0 += w0
            n0 += w0 * p0
            t0 += w0 * p0 * (0.0 if slope is None else slope[i])
    return (n0 + n1) + (n2 + n3), (t0 + t1) + (t2 + t3), (c0 + c1) + (c2 + c3)
