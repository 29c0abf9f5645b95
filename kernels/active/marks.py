"""Marks of samples: which may touch, and which do where their upstream neighbour does. One pass.

Displacements are bounded by those of the two steady states: where no force acts they decay with
E at one of the speeds or the other, and in contact they are z - d.
"""

from typing import NamedTuple

import numpy as np

from kernels.active.setting import rise
from kernels.active.strips import STRIP
from kernels.jit import kernel

FREE, OPEN, ALWAYS = 0, 1, 3  # never touches; may touch; always does if the one upstream does
WORD = 8  # marks that are read at once
ALL_ALWAYS = 0x0303030303030303


class Levels(NamedTuple):
    """Bounds of displacements by steady states: far - far_slack <= w <= near + near_slack."""

    near: np.ndarray  # w of the state in which elements forget faster
    near_slack: float
    far: np.ndarray
    far_slack: float


@kernel
def levels_of(setting, bounds):
    """Return the Levels: a displacement changes by no more than d does, less a step's decay."""
    near, far = setting.start, setting.end
    if setting.before.decay > setting.law.decay:
        near, far = far, near
    decay = setting.law.decay
    near_slack = decay * max(near.d - bounds.low, 0.0)
    return Levels(near.w, near_slack, far.w, decay * max(bounds.high - far.d, 0.0))


@kernel
def marks_of(setting, bounds, levels):
    """Return the marks of all samples, uint8, shape (n,) and zeros up to whole words.

    Strips of samples that are all alike are the rule: they are counted, not marked one by one.
    """
    z, w, near = setting.z, setting.start.w, levels.near
    n = z.size
    marks = np.empty((n // WORD + 1) * WORD, np.uint8)
    marks[n - 1 :] = FREE
    strips = (n - 1) // STRIP
    for s in range(strips):
        j = s * STRIP
        heights, least, now = z[j : j + STRIP + 1], near[j : j + STRIP], w[j : j + STRIP]
        low = held = 0
        for i in range(STRIP):
            above = heights[i + 1]
            may, does = _tests(setting, bounds, levels, heights[i], above, least[i], now[i])
            low += may
            held += does
        if low == 0:
            marks[j : j + STRIP] = FREE
        elif held == STRIP:
            marks[j : j + STRIP] = ALWAYS
        else:
            _mark(setting, bounds, levels, marks, j, j + STRIP)
    _mark(setting, bounds, levels, marks, strips * STRIP, n)
    return marks


@kernel
def _mark(setting, bounds, levels, marks, start, stop):
    """Mark samples [start, stop)."""
    z, w, near = setting.z, setting.start.w, levels.near
    for j in range(start, stop):
        above = z[j + 1 if j + 1 < z.size else 0]
        low, held = _tests(setting, bounds, levels, z[j], above, near[j], w[j])
        marks[j] = OPEN * low + (ALWAYS - OPEN) * held


@kernel
def _tests(setting, bounds, levels, z, above, near, w):
    """Return whether a sample may touch, and whether it does if the one upstream always does."""
    low = z - near < bounds.high + levels.near_slack
    steep = rise(setting.law, z, above)
    return low, low & (z - w < setting.start.d) & (steep < bounds.least)
