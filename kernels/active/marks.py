"""Marks of samples: which may touch, and which do where their upstream neighbour does. One pass.

Displacements are bounded by those of the two steady states: where no force acts they decay with
E at one of the speeds or the other, and in contact they are z - d.
"""

from typing import NamedTuple

import numpy as np

from kernels.active.setting import rise
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
    """Return the marks of all samples, uint8, shape (n,) and zeros up to whole words."""
    z, (w, d), law = setting.z, setting.start, setting.law
    near, reach = levels.near, bounds.high + levels.near_slack
    n = z.size
    marks = np.empty((n // WORD + 1) * WORD, np.uint8)
    marks[n - 1 :] = 0
    for j in range(n - 1):
        low = z[j] - near[j] < reach
        held = low & (z[j] - w[j] < d) & (rise(law, z[j], z[j + 1]) < bounds.least)
        marks[j] = OPEN * low + (ALWAYS - OPEN) * held
    j = n - 1
    if z[j] - near[j] < reach:
        held = z[j] - w[j] < d and rise(law, z[j], z[0]) < bounds.least
        marks[j] = ALWAYS if held else OPEN
    return marks
