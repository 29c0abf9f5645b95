"""Sums over the samples of a march: those that always touch, and those that are listed.

Sums over a span follow from those in steady/spans.py, and its samples are not visited. For a sample
j and its upstream neighbour j + 1 let Delta f_j = f_(j+1) - f_j. With slopes s_j, a_j and K of
problem.py, and any level,

    level - a_j = (level - z_j / K) + E Delta z_j,    lagged slope = s_j + lag Delta s_j,

so the sums of spans.py give the sums over a span of both quantities and of their product.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ..steady.spans import (
    FIRST_HEIGHT,
    FIRST_SLOPE,
    HEIGHT_SUM,
    RISE_SUM,
    SLOPE_SUM,
    SPAN,
    TURN_SUM,
    WORK_SUM,
)

# Indices into a tally: number of samples, sums of overlaps, of lagged slopes, of their products.
TALLY_SAMPLES, TALLY_DEPTH, TALLY_WEIGHT, TALLY_MOMENT = range(4)
PARTIAL_SUMS = 16  # number of partial sums, each advanced by four samples at a time


class SummedContact(NamedTuple):
    """Sums over the samples j that always touch and whose upstream neighbours always touch."""

    level: float  # d / K at v2, the final D; sums relative to it lose no digits
    samples: float  # number
    depth: float  # sum of level - a_j
    weight: float  # sum of the lagged slopes
    moment: float  # sum of (level - a_j) times the lagged slope


@refcount_free_kernel
def add_span(problem, level, b, tally):
    """Add to a tally a span whose samples always touch."""
    rows, law = problem.spans.rows, problem.law
    z, s = rows[b, FIRST_HEIGHT], rows[b, FIRST_SLOPE]
    rise, turn = rows[b + 1, FIRST_HEIGHT] - z, rows[b + 1, FIRST_SLOPE] - s
    rises, turns = rows[b, RISE_SUM], rows[b, TURN_SUM]
    depth, slopes = level - z / law.stiffness, SPAN * s + rows[b, SLOPE_SUM]
    tally[TALLY_SAMPLES] += SPAN
    tally[TALLY_DEPTH] += SPAN * depth - rows[b, HEIGHT_SUM] / law.stiffness + law.decay * rise
    tally[TALLY_WEIGHT] += slopes + law.lag * turn
    moment = depth * slopes - (rows[b, WORK_SUM] + s * rows[b, HEIGHT_SUM]) / law.stiffness
    lagged = depth * turn - (rise * turn - rises - turns) / law.stiffness
    along = law.decay * ((rises + s * rise) + law.lag * turns)
    tally[TALLY_MOMENT] += moment + law.lag * lagged + along


@refcount_free_kernel
def add_sample(depth, weight, tally):
    """Add to a tally a sample that always touches. depth : level - a_j. weight : lagged slope."""
    tally[TALLY_SAMPLES] += 1.0
    tally[TALLY_DEPTH] += depth
    tally[TALLY_WEIGHT] += weight
    tally[TALLY_MOMENT] += depth * weight


@refcount_free_kernel
def lagged_slope_at(slope, lag, j):
    """Return the lagged slope of one sample (friction.py)."""
    return slope[j] + lag * (slope[j + 1 if j + 1 < slope.size else 0] - slope[j])


@kernel
def pressure_sums(threshold, slope, d):
    """Return (sum of p, sum of p z', count) over samples with p = d - threshold > 0.

    slope : z', or None if only forces are needed. Partial sums in a fixed order, all in one array,
    let the loop vectorise.
    """
    sums = np.zeros(3 * PARTIAL_SUMS)
    whole = threshold.size - threshold.size % (4 * PARTIAL_SUMS)
    for first in range(0, whole, 4 * PARTIAL_SUMS):
        for k in range(PARTIAL_SUMS):
            i = first + k
            p = _overlap_terms(threshold, slope, i, d)
            q = _overlap_terms(threshold, slope, i + PARTIAL_SUMS, d)
            r = _overlap_terms(threshold, slope, i + 2 * PARTIAL_SUMS, d)
            s = _overlap_terms(threshold, slope, i + 3 * PARTIAL_SUMS, d)
            sums[k] += (p[0] + q[0]) + (r[0] + s[0])
            sums[PARTIAL_SUMS + k] += (p[2] + q[2]) + (r[2] + s[2])
            if slope is not None:
                sums[2 * PARTIAL_SUMS + k] += (p[1] + q[1]) + (r[1] + s[1])
    for i in range(whole, threshold.size):
        k, p = i % PARTIAL_SUMS, _overlap_terms(threshold, slope, i, d)
        sums[k] += p[0]
        sums[PARTIAL_SUMS + k] += p[2]
        sums[2 * PARTIAL_SUMS + k] += p[1]
    normal = tangential = count = 0.0
    for k in range(PARTIAL_SUMS):
        normal, count = normal + sums[k], count + sums[PARTIAL_SUMS + k]
        tangential += sums[2 * PARTIAL_SUMS + k]
    return normal, tangential, count


@refcount_free_kernel
def _overlap_terms(threshold, slope, i, d):
    """Return (p, p z', 1) of a sample, or zeros where p is not positive."""
    p = d - threshold[i]
    p = p if p > 0.0 else 0.0
    return p, (0.0 if slope is None else p * slope[i]), (1.0 if p > 0.0 else 0.0)
