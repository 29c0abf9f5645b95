"""Input of the active-set march, its bounds of d, D and the displacements, and sums of contact.

Bounds of d and D are first guessed, then checked at every step. The displacements of the two steady
states bound those on the way from one to the other: in contact u = z - d, and without contact u
decays by a factor E in each step, which is that of v1 before the jump and that of v2 after it.
These bounds decide the contact kinds of most spans.

Sums over a span follow from those in steady/spans.py, and its samples are not visited. For a sample
j and its upstream neighbour j + 1 let Delta f_j = f_(j+1) - f_j. With slopes s_j, rises a_j, the
stiffness K and any level,

    level - a_j = (level - z_j / K) + E Delta z_j,    lagged slope = s_j + lag Delta s_j,

so the sums of spans.py give the sums over a span of both quantities and of their product.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...rheology.kelvin import Kelvin
from ...rheology.law import MIN_MAGNITUDE
from ..steady.span_sliding import DecayFactors
from ..steady.spans import (
    FIRST_HEIGHT,
    FIRST_SLOPE,
    HEIGHT_SUM,
    RISE_SUM,
    SLOPE_SUM,
    SPAN,
    TURN_SUM,
    WORK_SUM,
    Spans,
)

MIN_SPREAD = 1e-11  # smallest spread of d or D, relative to d; far above rounding
# Contact kinds. ALWAYS_TOUCHES requires that the sample upstream always touches.
# FORCED_UNDECIDED makes the first sample of the line UNDECIDED, whatever the bounds.
NEVER_TOUCHES, UNDECIDED, ALWAYS_TOUCHES, FORCED_UNDECIDED = 0, 2, 3, 4

# Indices into a tally: number of samples, sums of overlaps, of lagged slopes, of their products.
TALLY_SAMPLES, TALLY_DEPTH, TALLY_WEIGHT, TALLY_MOMENT = range(4)
PARTIAL_SUMS = 16  # number of partial sums, each advanced by four samples at a time


class SteadyState(NamedTuple):
    """Steady sliding at one speed, by spans of the line (steady/spans.py)."""

    decay: DecayFactors
    thresholds: np.ndarray  # indentation from which a whole span touches (steady/spans.py)
    entered: np.ndarray  # displacement of the element that enters each span
    d: float  # indentation


class JumpProblem(NamedTuple):
    """A line, and steady sliding on it before and after the velocity jump."""

    z: np.ndarray  # in h, shape (n,)
    slope: np.ndarray  # in h/dx, shape (n,)
    spans: Spans
    before: Kelvin  # law for steps of one sample at v1
    law: Kelvin  # the same at v2
    start: SteadyState  # at v1
    end: SteadyState  # at v2
    rate: float  # d' in h/tau just after the velocity jump


@kernel
def indentation_advance(law, d, previous):
    """Return D(t) = d(t) - E d(t - 1); as 1 - E = 1/K is used, no digits are lost near E = 1."""
    return (d - previous) + previous / law.stiffness


@kernel
def line_rise(law, z, upstream):
    """Return a_j = z_j - E z_(j+1). z : z_j. upstream : z_(j+1).

    An element that arrives from contact upstream overlaps the line by d - c = D - a_j.
    """
    return (z - upstream) + upstream / law.stiffness


class Bounds(NamedTuple):
    """Open intervals assumed to contain d and D(t) = d(t) - E d(t - 1), in h."""

    d_min: float
    d_max: float
    advance_min: float  # of D
    advance_max: float


EMPTY_BOUNDS = Bounds(np.inf, -np.inf, np.inf, -np.inf)


@kernel
def within_bounds(bounds, d, advance):
    """Return whether d and D = ``advance`` lie within the bounds; False for NaN."""
    d_inside = bounds.d_min < d < bounds.d_max
    return d_inside and bounds.advance_min < advance < bounds.advance_max


@kernel
def spread_bounds(law, visited, margin):
    """Return the range ``visited`` of d and D, widened on each side by ``margin`` of its spread.

    The bounds of D include d / K, its value at constant d, for every d within the bounds.
    """
    d_min, d_max, advance_min, advance_max = visited
    wide = margin * max(d_max - d_min, MIN_SPREAD * d_max)
    low, high = max(d_min - wide, 0.0), d_max + wide
    least, most = min(advance_min, low / law.stiffness), max(advance_max, high / law.stiffness)
    wide = margin * max(most - least, MIN_SPREAD * d_max)
    return Bounds(low, high, least - wide, most + wide)


@refcount_free_kernel
def initial_bounds(problem, d, margin):
    """Return the Bounds of a whole march. d : estimate of d after the first step."""
    one, two = problem.start.d, problem.end.d
    advance = indentation_advance(problem.law, d, one)
    visited = Bounds(min(one, two, d), max(one, two, d), advance, advance)
    return spread_bounds(problem.law, visited, margin)


@kernel
def extended_bounds(visited, d, advance):
    """Return the range ``visited`` of d and D, extended to include this d and D."""
    least, most = min(visited.advance_min, advance), max(visited.advance_max, advance)
    return Bounds(min(visited.d_min, d), max(visited.d_max, d), least, most)


class DisplacementBounds(NamedTuple):
    """Bounds of free displacements: far - far_slack <= w <= near + near_slack."""

    near: SteadyState  # the state in which displacements decay faster
    near_is_start: bool  # whether ``near`` is the state at v1
    near_slack: float
    far_slack: float


@kernel
def displacement_bounds(problem, bounds):
    """Return the DisplacementBounds; both slacks are at least zero."""
    near, far, near_is_start = problem.start, problem.end, True
    if problem.before.decay > problem.law.decay:
        near, far, near_is_start = far, near, False
    decay = problem.law.decay
    near_slack = decay * max(near.d - bounds.d_min, 0.0)
    far_slack = decay * max(bounds.d_max - far.d, 0.0)
    return DisplacementBounds(near, near_is_start, near_slack, far_slack)


@refcount_free_kernel
def decayed_displacement(decay, u):
    """Return the displacement of a free element one sample after the displacement u."""
    return decay.sample * u if u < -MIN_MAGNITUDE else 0.0


@refcount_free_kernel
def span_never_touches(problem, bounds, levels, b):
    """Return whether the lowest sample of a whole span lies too high to touch.

    levels : DisplacementBounds.
    """
    near = levels.near
    w = near.decay.span * near.entered[b]  # upper bound of displacements in the span
    return problem.spans.lowest[b] - w >= bounds.d_max + levels.near_slack


@refcount_free_kernel
def span_always_touches(problem, bounds, b):
    """Return whether a whole span always touches if the sample upstream of it does."""
    largest_rise = problem.end.thresholds[b] / problem.law.stiffness
    return problem.start.d > problem.start.thresholds[b] and largest_rise < bounds.advance_min


@refcount_free_kernel
def kind_of_first(problem, bounds, levels):
    """Return the contact kind of z[0], where a walk over the line ends."""
    z, (start, end) = problem.z, (problem.start, problem.end)
    u_start, u_end, w_start, w_end = start.entered[0], end.entered[0], 0.0, 0.0
    for j in range(min(SPAN, z.size) - 1, -1, -1):
        w_start = decayed_displacement(start.decay, u_start)
        w_end = decayed_displacement(end.decay, u_end)
        u_start, u_end = min(w_start, z[j] - start.d), min(w_end, z[j] - end.d)
    if z[0] - (w_start if levels.near_is_start else w_end) >= bounds.d_max + levels.near_slack:
        return NEVER_TOUCHES
    rise = line_rise(problem.law, z[0], z[1])
    touches = z[0] - w_start < start.d and rise < bounds.advance_min
    return ALWAYS_TOUCHES if touches else FORCED_UNDECIDED


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
