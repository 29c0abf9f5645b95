"""Internal variables divided by their own decay: an element without force needs no update.

Let y_k be the memory of unit k after a step with force p, without the part -B_k p. The next step
changes it to y'_k = E_k (y_k - B_k p) - A_k p before its own force acts (rheology/prony.py), with
E_k and A_k of the next step. With y_k = S_k a_k and S'_k = E_k S_k this reads

    a_k <- a_k - (E_k B_k + A_k) / S'_k p,

which leaves the a_k of a free element unchanged, to the bit. If a step may be attempted again, its
a_k are changed when it is accepted, as E_k of a long attempt may be so small that the factor would
erase their digits. Before S_k underflows it is divided by RESCALE_FACTOR, and every a_k is
multiplied by it. The factor is a power of two, so the bits do not depend on when an element is
rescaled. Memory that is due for two rescalings is set to zero. So is that of a unit that decays by
a factor below MIN_DECAY in one step, and its -A_k p is kept apart.

Elements form blocks of BLOCK_ELEMENTS, so that the data of one loop fit into the first-level
cache.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import inlined_kernel, kernel
from ...rheology.law import MIN_MAGNITUDE

BLOCK_ELEMENTS = 64
RESCALE_FACTOR = 2.0**-512
MIN_SCALED_MEMORY = 2.0**-480  # smaller rescaled memory is set to zero
MIN_DECAY = 2.0**-100  # decay factor per step; below it old memory is lost in rounding


class Scales(NamedTuple):
    """Scales common to the units of all elements, each of shape (K,)."""

    scale: np.ndarray  # S_k
    last: np.ndarray  # last step at which memory was to be rescaled or set to zero
    before: np.ndarray  # the last such step before that; equal to ``last`` if set to zero


class ScaledUnits(NamedTuple):
    """Memory of elements in blocks, changed in place."""

    memory: np.ndarray  # a_k, shape (blocks, K, BLOCK_ELEMENTS)
    known_steps: np.ndarray  # shape (blocks,): step up to which the memory is rescaled
    scales: Scales
    fresh: np.ndarray  # B_k of the last accepted step, shape (K,); 0 if a_k includes its force
    due: np.ndarray  # decrease of a_k per unit of p in the attempted step, shape (K,)
    drop: np.ndarray  # workspace, shape (K,): what the attempt subtracts, ``due`` or zero
    share: np.ndarray  # workspace, shape (K,): S'_k of the present attempt
    room: np.ndarray  # workspace, shape (2 BLOCK_ELEMENTS,)


class Indenter(NamedTuple):
    """Indenter; its force on an element of threshold c < level is stiffness * (level - c)."""

    level: float  # in h
    stiffness: float


@inlined_kernel
def element_force(pressing, c):
    """Return the force of an element of threshold c."""
    depth = pressing.level - c
    return pressing.stiffness * depth if depth > 0.0 else 0.0


@kernel
def scaled_units(memory):
    """Return the ScaledUnits of memory (K, n), with all S_k = 1, before any step."""
    units, n = memory.shape
    blocks = (n + BLOCK_ELEMENTS - 1) // BLOCK_ELEMENTS
    scaled, steps = np.zeros((blocks, units, BLOCK_ELEMENTS)), np.zeros((2, units), np.int64)
    for b in range(blocks):
        first, size = b * BLOCK_ELEMENTS, min(BLOCK_ELEMENTS, n - b * BLOCK_ELEMENTS)
        for k in range(units):
            for i in range(size):
                scaled[b, k, i] = memory[k, first + i]
    scales, known_steps = Scales(np.ones(units), steps[0], steps[1]), np.zeros(blocks, np.int64)
    zeros, workspace = np.zeros((3, units)), (np.empty(units), np.empty(2 * BLOCK_ELEMENTS))
    return ScaledUnits(scaled, known_steps, scales, zeros[0], zeros[1], zeros[2], *workspace)


@inlined_kernel
def prepare_attempt(law, units, final):
    """Set share, due and drop for an attempt; return the factor of p that the sums still lack.

    law : the Prony of the step. final : whether the memory may take in the force p at once.
    """
    lacking = 0.0
    for k in range(law.decay.size):
        share, due = law.decay[k] * units.scales.scale[k], 0.0
        if law.decay[k] < MIN_DECAY:
            share = 0.0
            lacking += law.stale[k]
        else:
            change = law.decay[k] * units.fresh[k] + law.stale[k]
            due = change / share
            lacking += 0.0 if final else change
        units.share[k], units.due[k], units.drop[k] = share, due, due if final else 0.0
    return lacking


@inlined_kernel
def advance_scales(law, units, step):
    """Advance the scales to an accepted step; law : the Prony of that step."""
    scale, last, before = units.scales
    for k in range(law.decay.size):
        scale[k] *= law.decay[k]
        if law.decay[k] < MIN_DECAY:
            scale[k] = 1.0
            before[k] = last[k] = step
        elif scale[k] < RESCALE_FACTOR:
            scale[k] /= RESCALE_FACTOR
            before[k], last[k] = last[k], step
        units.fresh[k] = law.fresh[k]


@inlined_kernel
def rescale_blocks(units, some, step):
    """Rescale the memory of the blocks ``some`` (an array or a range) up to a step."""
    memory, updated, scales, latest = units.memory, units.known_steps, units.scales, 0
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
def apply_and_predict(units, b, last, c):
    """Subtract drop_k p from the memory of block b, and sum share_k a_k.

    last : Indenter of the last accepted step. c : thresholds in it, shape (BLOCK_ELEMENTS,). The
    workspace ``room`` gets the sums and the forces p; it is one array, as loops over two would
    check whether these overlap.
    """
    share, drops, memory, room = units.share, units.drop, units.memory, units.room
    of_unit, drop = share[0], drops[0]
    for i in range(BLOCK_ELEMENTS):
        p = element_force(last, c[i])
        y = memory[b, 0, i] - drop * p
        memory[b, 0, i] = y
        room[i], room[BLOCK_ELEMENTS + i] = of_unit * y, p
    for k in range(1, share.size):
        of_unit, drop = share[k], drops[k]
        for i in range(BLOCK_ELEMENTS):
            y = memory[b, k, i] - drop * room[BLOCK_ELEMENTS + i]
            memory[b, k, i] = y
            room[i] += of_unit * y


@inlined_kernel
def unscaled(units, b, k, i, p):
    """Return the memory of an element after a step with the force p, before further attempts."""
    y = units.scales.scale[k] * units.memory[b, k, i] - units.fresh[k] * p
    return y if abs(y) > MIN_MAGNITUDE else 0.0
