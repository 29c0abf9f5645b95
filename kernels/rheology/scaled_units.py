"""Internal variables divided by their own decay: an element without force needs no update.

Let y_k be the memory of unit k after a step with force p, including -B_k p. The next step changes
it to y'_k = E_k y_k - A_k p before its own force acts (prony.py), with E_k and A_k of the next
step. With y'_k = S_k a_k, and S_k <- E_k S_k in every step, this reads

    a_k <- a_k - (E_k B_k + A_k) / S_k p,

which leaves the a_k of a free element unchanged, to the bit. Before S_k underflows it is divided by
RESCALE_FACTOR, and every a_k is multiplied by it. The factor is a power of two, so the bits do not
depend on when an element is rescaled. Memory is set to zero if it is due for two rescalings, or if
its unit decays by a factor below MIN_DECAY in one step.

Elements form blocks of BLOCK_ELEMENTS, so that the data of one loop fit into the first-level
cache.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import inlined_kernel, kernel

BLOCK_ELEMENTS = 64
RESCALE_FACTOR = 2.0**-512
MIN_SCALED_MEMORY = 2.0**-480  # smaller rescaled memory is set to zero
MIN_DECAY = 2.0**-100  # decay factor per step; below it old memory is lost in rounding


class Scales(NamedTuple):
    """Scales common to the units of all elements, each of shape (K,)."""

    scale: np.ndarray  # S_k
    last: np.ndarray  # last step at which memory was to be rescaled or set to zero
    before: np.ndarray  # the last such step before that; equal to ``last`` if set to zero
    fresh: np.ndarray  # B_k of the last step; 0 if memory already includes its force
    due: np.ndarray  # decrease of a_k per unit force of the last step; 0 if already subtracted


@kernel
def unit_scales(units, step):
    """Return the initial Scales, all S_k = 1, after the step number ``step``."""
    zeros, steps = np.zeros((2, units)), np.full((2, units), step)
    return Scales(np.ones(units), steps[0], steps[1], zeros[0], zeros[1])


@inlined_kernel
def advance_scales(law, scales, step):
    """Advance the scales to a step; law : the Prony of that step."""
    for k in range(law.decay.size):
        scale = law.decay[k] * scales.scale[k]
        if law.decay[k] < MIN_DECAY:
            scale = 1.0
            scales.before[k] = scales.last[k] = step
        elif scale < RESCALE_FACTOR:
            scale /= RESCALE_FACTOR
            scales.before[k], scales.last[k] = scales.last[k], step
        scales.scale[k] = scale
        scales.due[k] = (law.decay[k] * scales.fresh[k] + law.stale[k]) / scale
        scales.fresh[k] = law.fresh[k]


@inlined_kernel
def rescale_blocks(scales, memory, updated, some, step):
    """Rescale the memory of the blocks ``some`` up to a step.

    memory : shape (blocks, K, BLOCK_ELEMENTS). updated : step up to which each block is rescaled.
    """
    latest = 0
    for k in range(scales.last.size):
        latest = max(latest, scales.last[k])
    for b in some:
        for k in range(scales.last.size if updated[b] < latest else 0):
            if scales.before[k] > updated[b]:
                for i in range(BLOCK_ELEMENTS):
                    memory[b, k, i] = 0.0
            elif scales.last[k] > updated[b]:
                for i in range(BLOCK_ELEMENTS):
                    y = RESCALE_FACTOR * memory[b, k, i]
                    memory[b, k, i] = y if abs(y) > MIN_SCALED_MEMORY else 0.0
        updated[b] = max(updated[b], step)


@inlined_kernel
def predict_block(share, memory, b, total):
    """Fill ``total`` (BLOCK_ELEMENTS,) with sum_k share_k a_k of block b."""
    for i in range(BLOCK_ELEMENTS):
        total[i] = 0.0
    for k in range(share.size):
        of_unit = share[k]
        for i in range(BLOCK_ELEMENTS):
            total[i] += of_unit * memory[b, k, i]


class Indenter(NamedTuple):
    """Indenter; its force on an element of threshold c < level is stiffness * (level - c)."""

    level: float  # in h
    stiffness: float


@inlined_kernel
def element_force(pressing, c):
    """Return the force of an element of threshold c."""
    depth = pressing.level - c
    return pressing.stiffness * depth if depth > 0.0 else 0.0


@inlined_kernel
def advance_and_predict(due, share, memory, b, pressing, c, room):
    """Subtract due_k p from the memory of block b, then sum as ``predict_block`` does.

    c : thresholds, shape (BLOCK_ELEMENTS,). room : shape (2 BLOCK_ELEMENTS,), filled with the sums
    and the forces p; it is one array, as loops over two would check whether these overlap.
    """
    of_unit, drop = share[0], due[0]
    for i in range(BLOCK_ELEMENTS):
        p = element_force(pressing, c[i])
        y = memory[b, 0, i] - drop * p
        memory[b, 0, i] = y
        room[i], room[BLOCK_ELEMENTS + i] = of_unit * y, p
    for k in range(1, share.size):
        of_unit, drop = share[k], due[k]
        for i in range(BLOCK_ELEMENTS):
            y = memory[b, k, i] - drop * room[BLOCK_ELEMENTS + i]
            memory[b, k, i] = y
            room[i] += of_unit * y


@inlined_kernel
def mark_forces_applied(scales):
    """Record that all memory includes the force of the last step."""
    for k in range(scales.due.size):
        scales.due[k] = 0.0
