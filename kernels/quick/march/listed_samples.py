"""Samples of a march: undecided ones are listed run by run, those that always touch are summed.

Sums over a span follow from those in steady/spans.py, and its samples are not visited. For a sample
j and its upstream neighbour j + 1 let Delta f_j = f_(j+1) - f_j. With slopes s_j and any level,

    level - a_j = (level - z_j / K) + E Delta z_j,    lagged slope = s_j + lag Delta s_j,

so spans.py determines their sums over a span, and the sum of their products.
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

# Elements of a tally: number of samples, sums of overlaps, of lagged slopes, of their products.
TALLY_SAMPLES, TALLY_DEPTH, TALLY_WEIGHT, TALLY_MOMENT = range(4)


class ListedSamples(NamedTuple):
    """Listed samples, run by run. A run is in line order: elements enter it at its end."""

    begin: np.ndarray  # first slot of each run, and the end of the last; shape (runs + 1,)
    z: np.ndarray  # heights
    weight: np.ndarray  # lagged slopes (friction.py)
    c: np.ndarray  # contact thresholds of the last step (model/contact.py)


class CollectedSamples(NamedTuple):
    """Listed samples in the order of a walk against the motion, run by run."""

    z: np.ndarray  # heights
    weight: np.ndarray  # lagged slopes
    c: np.ndarray  # thresholds in steady sliding at v1
    c_end: np.ndarray  # thresholds in steady sliding at v2


class SummedContact(NamedTuple):
    """Sums over samples j that always touch, as their upstream neighbours do."""

    level: float  # d / K at v2, the final D; sums relative to it lose no digits
    samples: float  # number
    depth: float  # sum of level - a_j
    weight: float  # sum of the lagged slopes
    moment: float  # sum of (level - a_j) times the lagged slope


@kernel
def listed_samples(runs, collected):
    """Return the ListedSamples of all Runs at the start of a march."""
    begin = np.zeros(runs.leading.size + 1, np.int64)
    for r in range(runs.leading.size):
        begin[r + 1] = begin[r] + runs.leading[r] - runs.trailing[r] + 1
    z, weight, c = np.empty(begin[-1]), np.empty(begin[-1]), np.empty(begin[-1])
    for r in range(runs.leading.size):
        k = begin[r + 1] - 1
        for i in range(begin[r], begin[r + 1]):
            z[k], weight[k], c[k] = collected.z[i], collected.weight[i], collected.c[i]
            k -= 1
    return ListedSamples(begin, z, weight, c)


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
