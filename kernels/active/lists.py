"""What is stepped: the listed samples, and the others that touch, as sums."""

from typing import NamedTuple

import numpy as np

from kernels.active.strips import STRIP, add_stretch, in_order
from kernels.jit import kernel


class Lists(NamedTuple):
    """Listed samples: run after run, each in line order, elements coming from its end."""

    first: np.ndarray  # where each run begins, and the end of the last; shape (runs + 1,)
    z: np.ndarray  # heights
    weight: np.ndarray  # lagged slopes (friction.py)
    c: np.ndarray  # thresholds of the last step (contact.py)


class Sums(NamedTuple):
    """Sums over samples j that always touch."""

    level: float  # what D comes to, d / K at v2: the sums lose no digits near it
    samples: float  # how many
    depth: float  # of level - a_j
    weight: float  # of the lagged slopes
    moment: float  # of (level - a_j) times the lagged slope


@kernel
def lagged(slope, lag, j):
    """Return the lagged slope of one sample (friction.py)."""
    return slope[j] + lag * (slope[j + 1 if j + 1 < slope.size else 0] - slope[j])


@kernel
def lists_of(setting, bounds, runs):
    """Return the Lists of some Runs at the start of a march."""
    first = np.zeros(runs.top.size + 1, np.int64)
    for r in range(runs.top.size):
        first[r + 1] = first[r] + runs.top[r] - runs.bottom[r] + 1
    z, weight, c = np.empty(first[-1]), np.empty(first[-1]), np.empty(first[-1])
    for r in range(runs.top.size):
        i = first[r]
        for j in range(runs.bottom[r], runs.top[r] + 1):
            # What lies higher cannot touch at any height: low, it costs w no digits.
            z[i] = min(setting.z[j], bounds.high)
            weight[i] = lagged(setting.slope, setting.law.lag, j)
            c[i] = z[i] - setting.start.w[j]
            i += 1
    return Lists(first, z, weight, c)


@kernel
def sums_of(setting, stretches):
    """Return the Sums over stretches."""
    z, slope, law = setting.z, setting.slope, setting.law
    level = setting.end.d / law.stiffness
    depth, weight, moment = np.zeros(STRIP), np.zeros(STRIP), np.zeros(STRIP)
    samples = 0
    for s in range(stretches.start.size):
        start, stop = stretches.start[s], stretches.stop[s]
        add_stretch(law, z, slope, level, start, stop, depth, weight, moment)
        samples += stop - start
    return Sums(level, float(samples), in_order(depth), in_order(weight), in_order(moment))


@kernel
def weighed(c, weight, d):
    """Return (sum of d - c_i, sum of (d - c_i) weight_i) over the touching c_i < d.

    Four partial sums in a fixed order.
    """
    p0 = p1 = p2 = p3 = 0.0
    m0 = m1 = m2 = m3 = 0.0
    whole = c.size - c.size % 4
    for i in range(0, whole, 4):
        d0, d1, d2, d3 = d - c[i], d - c[i + 1], d - c[i + 2], d - c[i + 3]
        d0, d1 = (d0 if d0 > 0.0 else 0.0), (d1 if d1 > 0.0 else 0.0)
        d2, d3 = (d2 if d2 > 0.0 else 0.0), (d3 if d3 > 0.0 else 0.0)
        p0, p1, p2, p3 = p0 + d0, p1 + d1, p2 + d2, p3 + d3
        m0, m1 = m0 + d0 * weight[i], m1 + d1 * weight[i + 1]
        m2, m3 = m2 + d2 * weight[i + 2], m3 + d3 * weight[i + 3]
    for i in range(whole, c.size):
        depth = max(d - c[i], 0.0)
        p0, m0 = p0 + depth, m0 + depth * weight[i]
    return (p0 + p1) + (p2 + p3), (m0 + m1) + (m2 + m3)
