"""What is stepped: the listed samples, run after run, and the others that touch, as sums.

The sums go span by span, from those that are known of the line. Over a span, from its first sample
0 to the first one upstream of it, let Delta f_j = f_(j+1) - f_j. Then

    level - a_j = (level - z_j / K) + E Delta z_j,    lagged slope = s_j + lag Delta s_j,

so that their sums, and that of their products, need the sums of spans.py alone: no sample is
visited.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ..steady.spans import FIRST, HEIGHT, RISE, SLOPE, SPAN, STEEP, TURN, WORK


class Lists(NamedTuple):
    """Listed samples: run after run, each in line order, elements coming from its end."""

    first: np.ndarray  # where each run begins, and the end of the last; shape (runs + 1,)
    z: np.ndarray  # heights
    weight: np.ndarray  # lagged slopes (friction.py)
    c: np.ndarray  # thresholds of the last step (contact.py)


class Met(NamedTuple):
    """Listed samples as a walk against the motion meets them, run after run."""

    z: np.ndarray  # heights
    weight: np.ndarray  # lagged slopes
    c: np.ndarray  # thresholds in steady sliding at v1
    after: np.ndarray  # and at v2


class Sums(NamedTuple):
    """Sums over samples j that always touch."""

    level: float  # what D comes to, d / K at v2: the sums lose no digits near it
    samples: float  # how many
    depth: float  # of level - a_j
    weight: float  # of the lagged slopes
    moment: float  # of (level - a_j) times the lagged slope


@kernel
def lists_of(runs, met):
    """Return the Lists of all Runs at the start of a march."""
    first = np.zeros(runs.top.size + 1, np.int64)
    for r in range(runs.top.size):
        first[r + 1] = first[r] + runs.top[r] - runs.bottom[r] + 1
    z, weight, c = np.empty(first[-1]), np.empty(first[-1]), np.empty(first[-1])
    for r in range(runs.top.size):
        k = first[r + 1] - 1
        for i in range(first[r], first[r + 1]):
            z[k], weight[k], c[k] = met.z[i], met.weight[i], met.c[i]
            k -= 1
    return Lists(first, z, weight, c)


@refcount_free_kernel
def add_span(march, level, b, tally):
    """Add a span all of whose samples always touch to a tally: samples, depth, weight, moment."""
    rows, law = march.spans.rows, march.law
    z, s = rows[b, FIRST], rows[b, STEEP]
    up, turn = rows[b + 1, FIRST] - z, rows[b + 1, STEEP] - s
    one, other = rows[b, RISE], rows[b, TURN]
    deep, slopes = level - z / law.stiffness, SPAN * s + rows[b, SLOPE]
    tally[0] += SPAN
    tally[1] += SPAN * deep - rows[b, HEIGHT] / law.stiffness + law.decay * up
    tally[2] += slopes + law.lag * turn
    moment = deep * slopes - (rows[b, WORK] + s * rows[b, HEIGHT]) / law.stiffness
    lagging = deep * turn - (up * turn - one - other) / law.stiffness
    tally[3] += moment + law.lag * lagging + law.decay * ((one + s * up) + law.lag * other)


@refcount_free_kernel
def add_sample(depth, weight, tally):
    """Add one sample that always touches to a tally. depth : level - a_j. weight : lagged slope."""
    tally[0] += 1.0
    tally[1] += depth
    tally[2] += weight
    tally[3] += depth * weight


@refcount_free_kernel
def lagged(slope, lag, j):
    """Return the lagged slope of one sample (friction.py)."""
    return slope[j] + lag * (slope[j + 1 if j + 1 < slope.size else 0] - slope[j])
