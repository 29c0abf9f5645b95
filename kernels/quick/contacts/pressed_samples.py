"""Pressures of a contact at any indentation.

A sample is pressed if d + d' lies above its threshold z - vbar z'. Most spans that touch everywhere
are pressed everywhere too, and contribute stored sums. A guess of d + d' selects these spans; the
samples of the others are listed.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ..steady.spans import FIRST_HEIGHT, FIRST_SLOPE, HEIGHT_SUM, SLOPE_SUM, SPAN, Spans
from .touching_samples import TouchingSamples

PARTIAL_SUMS = 16  # number of partial sums, each advanced by four samples at a time


class MovingLine(NamedTuple):
    """A line and its spans, moving at a speed."""

    z: np.ndarray  # in h, shape (n,)
    slope: np.ndarray  # in h/dx, shape (n,)
    spans: Spans
    speed: float  # vbar
    thresholds: np.ndarray  # largest z - vbar z' of each span (thresholds.py)


class PressedContact(NamedTuple):
    """The touching samples and the thresholds of their pressure."""

    line: MovingLine
    touching: TouchingSamples
    threshold: np.ndarray  # of the single samples of ``touching``
    loose_threshold: np.ndarray  # of the samples of spans that the guess does not press everywhere
    loose_slope: np.ndarray  # z' of those samples
    spans: np.ndarray  # indices of the spans that the guess presses everywhere
    first_threshold: np.ndarray  # of the first sample of each of these spans
    threshold_sum: np.ndarray  # per such span: sum of (threshold - first threshold)


@kernel
def allocate_pressed(samples):
    """Return the arrays that press_contact fills, with room for a whole line."""
    spans = samples // SPAN + 1
    per_sample = np.empty(samples), np.empty(samples), np.empty(samples)
    return per_sample, np.empty(spans, np.int64), np.empty((2, spans))


@kernel
def press_contact(line, touching, guess, room):
    """Return the PressedContact in the memory of ``room``. guess : of d + d'."""
    z, slope, spans, speed, thresholds = line
    rows = spans.rows
    (threshold, loose_threshold, loose_slope), numbers, (first, sums) = room
    threshold = threshold[: touching.weight.size]
    for i in range(threshold.size):
        threshold[i] = touching.height[i] - speed * touching.slope[i]
    loose = pressed = 0
    for b in touching.spans:
        j = b * SPAN
        if thresholds[b] < guess:
            numbers[pressed] = b
            first[pressed] = rows[b, FIRST_HEIGHT] - speed * rows[b, FIRST_SLOPE]
            sums[pressed] = rows[b, HEIGHT_SUM] - speed * rows[b, SLOPE_SUM]
            pressed += 1
        else:
            for k in range(SPAN):
                loose_threshold[loose + k] = z[j + k] - speed * slope[j + k]
                loose_slope[loose + k] = slope[j + k]
            loose += SPAN
    return PressedContact(
        line,
        touching,
        threshold,
        loose_threshold[:loose],
        loose_slope[:loose],
        numbers[:pressed],
        first[:pressed],
        sums[:pressed],
    )


@refcount_free_kernel
def span_sums(line, b, deep):
    """Return (sum of p, sum of p z', count) over the samples of span b with p > 0.

    deep : d + d'.
    """
    normal = tangential = count = 0.0
    for k in range(b * SPAN, (b + 1) * SPAN):
        p = deep - (line.z[k] - line.speed * line.slope[k])
        if p > 0.0:
            normal += p
            tangential += p * line.slope[k]
            count += 1.0
    return normal, tangential, count


@kernel
def pressure_sums(threshold, weight, slope, deep):
    """Return (sum of w p, sum of w p z', sum of w) over samples with p = deep - threshold > 0.

    weight : w, or None for 1. slope : z', or None if only forces are needed. Partial sums in a
    fixed order, all in one array, let the loop vectorise.
    """
    sums = np.zeros(3 * PARTIAL_SUMS)
    whole = threshold.size - threshold.size % (4 * PARTIAL_SUMS)
    for first in range(0, whole, 4 * PARTIAL_SUMS):
        for k in range(PARTIAL_SUMS):
            i = first + k
            p = _sample_terms(threshold, weight, slope, i, deep)
            q = _sample_terms(threshold, weight, slope, i + PARTIAL_SUMS, deep)
            r = _sample_terms(threshold, weight, slope, i + 2 * PARTIAL_SUMS, deep)
            s = _sample_terms(threshold, weight, slope, i + 3 * PARTIAL_SUMS, deep)
            sums[k] += (p[0] + q[0]) + (r[0] + s[0])
            sums[PARTIAL_SUMS + k] += (p[2] + q[2]) + (r[2] + s[2])
            if slope is not None:
                sums[2 * PARTIAL_SUMS + k] += (p[1] + q[1]) + (r[1] + s[1])
    for i in range(whole, threshold.size):
        k, p = i % PARTIAL_SUMS, _sample_terms(threshold, weight, slope, i, deep)
        sums[k] += p[0]
        sums[PARTIAL_SUMS + k] += p[2]
        sums[2 * PARTIAL_SUMS + k] += p[1]
    normal = tangential = count = 0.0
    for k in range(PARTIAL_SUMS):
        normal, count = normal + sums[k], count + sums[PARTIAL_SUMS + k]
        tangential += sums[2 * PARTIAL_SUMS + k]
    return normal, tangential, count


@refcount_free_kernel
def _sample_terms(threshold, weight, slope, i, deep):
    """Return (w p, w p z', w) of a sample, or zeros where p is not positive."""
    p = deep - threshold[i]
    p = p if p > 0.0 else 0.0
    share = 1.0 if weight is None else weight[i]
    share = share if p > 0.0 else 0.0
    force = share * p
    return force, (0.0 if slope is None else force * slope[i]), share
