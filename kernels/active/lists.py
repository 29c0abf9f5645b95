"""What is stepped: the listed samples, and the others that touch, as sums."""

from typing import NamedTuple

import numpy as np

from kernels.active.setting import rise
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
def lists_of(setting, runs):
    """Return the Lists of some Runs at the start of a march."""
    first = np.zeros(runs.top.size + 1, np.int64)
    for r in range(runs.top.size):
        first[r + 1] = first[r] + runs.top[r] - runs.bottom[r] + 1
    z, weight, c = np.empty((3, first[-1]))
    for r in range(runs.top.size):
        i = first[r]
        for j in range(runs.bottom[r], runs.top[r] + 1):
            z[i] = setting.z[j]
            weight[i] = lagged(setting.slope, setting.law.lag, j)
            c[i] = setting.z[j] - setting.start.w[j]
            i += 1
    return Lists(first, z, weight, c)


@kernel
def sums_of(setting, stretches):
    """Return the Sums over stretches; four partial sums each, in a fixed order."""
    level = setting.end.d / setting.law.stiffness
    count = depth = weight = moment = 0.0
    for s in range(stretches.start.size):
        one = _stretch(setting, stretches.start[s], stretches.stop[s], level)
        count += one.samples
        depth += one.depth
        weight += one.weight
        moment += one.moment
    return Sums(level, count, depth, weight, moment)


@kernel
def _stretch(setting, start, stop, level):
    """Return the Sums over samples [start, stop)."""
    z, slope, law = setting.z, setting.slope, setting.law
    p0 = p1 = p2 = p3 = 0.0
    w0 = w1 = w2 = w3 = 0.0
    m0 = m1 = m2 = m3 = 0.0
    inner = min(stop, z.size - 1)  # the last sample of the line has its neighbour at z[0]
    whole = inner - (inner - start) % 4
    for j in range(start, whole, 4):
        a0, a1 = level - rise(law, z[j], z[j + 1]), level - rise(law, z[j + 1], z[j + 2])
        a2, a3 = level - rise(law, z[j + 2], z[j + 3]), level - rise(law, z[j + 3], z[j + 4])
        s0, s1, s2, s3, s4 = slope[j], slope[j + 1], slope[j + 2], slope[j + 3], slope[j + 4]
        s0, s1 = s0 + law.lag * (s1 - s0), s1 + law.lag * (s2 - s1)
        s2, s3 = s2 + law.lag * (s3 - s2), s3 + law.lag * (s4 - s3)
        p0, p1, p2, p3 = p0 + a0, p1 + a1, p2 + a2, p3 + a3
        w0, w1, w2, w3 = w0 + s0, w1 + s1, w2 + s2, w3 + s3
        m0, m1, m2, m3 = m0 + a0 * s0, m1 + a1 * s1, m2 + a2 * s2, m3 + a3 * s3
    for j in range(whole, stop):
        depth = level - rise(law, z[j], z[j + 1 if j + 1 < z.size else 0])
        weight = lagged(slope, law.lag, j)
        p0, w0, m0 = p0 + depth, w0 + weight, m0 + depth * weight
    depth, weight = (p0 + p1) + (p2 + p3), (w0 + w1) + (w2 + w3)
    return Sums(level, float(stop - start), depth, weight, (m0 + m1) + (m2 + m3))


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
