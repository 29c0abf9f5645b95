"""Sums over many samples: strip after strip, each sample of a strip to a partial sum of its own.

The compiler may take several samples of a strip at once, as no sum depends on another; so the
sums are fast, and the same bits on every machine.
"""

import numpy as np

from kernels.active.setting import rise
from kernels.contact import overlap
from kernels.jit import kernel

STRIP = 32  # samples, and partial sums


@kernel
def overlaps(z, w, factor, d):
    """Return (sum of d - c_j, number) over the touching elements c_j = z_j - factor w_j < d."""
    depth, count = np.zeros(STRIP), np.zeros(STRIP)
    strips = z.size // STRIP
    for s in range(strips):
        heights, reached = z[s * STRIP : (s + 1) * STRIP], w[s * STRIP : (s + 1) * STRIP]
        for i in range(STRIP):
            p = d - (heights[i] - factor * reached[i])
            depth[i] += p if p > 0.0 else 0.0
            count[i] += 1.0 if p > 0.0 else 0.0
    for j in range(strips * STRIP, z.size):
        p = d - (z[j] - factor * w[j])
        if p > 0.0:
            depth[0] += p
            count[0] += 1.0
    return in_order(depth), in_order(count)


@kernel
def overlap_of(c, d):
    """Return (sum of d - c_i, number) over the touching elements c_i < d, as overlap does.

    That one is faster for few elements.
    """
    if c.size < 4 * STRIP:
        return overlap(c, d)
    depth, count = np.zeros(STRIP), np.zeros(STRIP)
    strips = c.size // STRIP
    for s in range(strips):
        part = c[s * STRIP : (s + 1) * STRIP]
        for i in range(STRIP):
            p = d - part[i]
            depth[i] += p if p > 0.0 else 0.0
            count[i] += 1.0 if p > 0.0 else 0.0
    total, touching = overlap(c[strips * STRIP :], d)
    return total + in_order(depth), touching + in_order(count)


@kernel
def add_stretch(law, z, slope, level, start, stop, depth, weight, moment):
    """Add samples [start, stop) to partial sums of level - a_j, of lagged slopes, of products.

    a_j : setting.py. Lagged slopes: friction.py. depth, weight, moment : shape (STRIP,).
    """
    strips = (min(stop, z.size - 1) - start) // STRIP
    for s in range(strips):
        j = start + s * STRIP
        heights, slopes = z[j : j + STRIP + 1], slope[j : j + STRIP + 1]
        for i in range(STRIP):
            p = level - rise(law, heights[i], heights[i + 1])
            lagged = slopes[i] + law.lag * (slopes[i + 1] - slopes[i])
            depth[i] += p
            weight[i] += lagged
            moment[i] += p * lagged
    for j in range(start + strips * STRIP, stop):
        above = j + 1 if j + 1 < z.size else 0
        p = level - rise(law, z[j], z[above])
        lagged = slope[j] + law.lag * (slope[above] - slope[j])
        i = j % STRIP
        depth[i] += p
        weight[i] += lagged
        moment[i] += p * lagged


@kernel
def in_order(parts):
    """Return the sum of partial sums, from the first to the last."""
    total = 0.0
    for part in parts:
        total += part
    return total
