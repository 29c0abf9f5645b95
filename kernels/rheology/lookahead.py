"""Lookahead memory: internal variables that predict a step without the force of the previous one.

Let y_k be the memory of unit k after a step with force p. The next step changes it to
v_k = E_k y_k - A_k p before its own force acts (prony.py). If all steps have the same length,

    v_k <- E_k v_k - (E_k B_k + A_k) p,

and an element without force would reach sum v_k. In the relaxation form the memory itself suffices.

An element meets the samples of a line one after the other. The forces of a block of samples are
first predicted from the v_k before the block, without the forces within it. Each force is then
corrected for the earlier ones, so that no sample waits for a sum over all units.
"""

import math
from typing import NamedTuple

import numpy as np

from ..compile.jit import dispatch_on_type, dispatch_refcount_free, inlined_kernel
from .law import MIN_MAGNITUDE, advance_memory, predict
from .prony import Prony
from .relaxed import Relaxed, advance_element, predict_element

BLOCK_SAMPLES = 8  # samples; their forces are subtracted in groups of four


@dispatch_on_type
def lookahead_law(law):
    """Return a law of the same step whose predictions need no force of the previous step."""


@dispatch_on_type
def lookahead_memory(law, memory, p):
    """Return the lookahead memory (M,) of an element after a step with force p."""


@dispatch_refcount_free
def slide_element(law, y, d, heights, forces):
    """Move an element over samples of heights (n,) at the indentation d; return the sum of forces.

    law : from ``lookahead_law``. y (M,) : lookahead memory of the element, updated.
    forces (n,) : filled.
    """


@dispatch_refcount_free
def fill_memory(law, y, p, memory, at, stride, count):
    """Fill ``memory`` (M, n) of an element at the samples at, at + stride, ... (``count`` of them).

    law : from ``lookahead_law``. y (M,) : lookahead memory before the first of these samples,
    updated to that after the last. p (n,) : forces.
    """


class LookaheadUnits(NamedTuple):
    """Constants of one step of v_k, and of a block; stiffness as in every law (law.py)."""

    decay: np.ndarray  # E_k, shape (K,)
    due: np.ndarray  # E_k B_k + A_k, shape (K,): decrease of v_k per unit force
    fresh: np.ndarray  # B_k, shape (K,): decrease of y_k per unit force
    stiffness: float
    ahead: np.ndarray  # shape (K, BLOCK_SAMPLES): force at each sample of a block per unit v_k
    echo: np.ndarray  # shape (BLOCK_SAMPLES,): drop of forces 1, 2, ... samples after a unit force
    left: np.ndarray  # shape (K,): decay factor of v_k over a block
    removed: np.ndarray  # shape (BLOCK_SAMPLES, K): decrease of v_k after a block per unit force


@lookahead_law.register(Prony)
def _lookahead_units(law):
    due, powers = law.decay * law.fresh + law.stale, np.ones((BLOCK_SAMPLES + 1, law.decay.size))
    for m in range(BLOCK_SAMPLES):
        for k in range(law.decay.size):
            left = law.decay[k] * powers[m, k]
            powers[m + 1, k] = left if left > math.sqrt(MIN_MAGNITUDE) else 0.0
    ahead, echo = law.stiffness * powers[:BLOCK_SAMPLES].T.copy(), np.empty(BLOCK_SAMPLES)
    for m in range(BLOCK_SAMPLES):
        echo[m] = (due * ahead[:, m]).sum()
    removed = due * powers[:BLOCK_SAMPLES][::-1]
    return LookaheadUnits(
        law.decay, due, law.fresh, law.stiffness, ahead, echo, powers[BLOCK_SAMPLES], removed
    )


@lookahead_law.register(Relaxed)
def _lookahead_branches(law):
    return law


@lookahead_memory.register(LookaheadUnits)
def _memory_of_units(law, memory, p):
    return law.decay * (memory + law.fresh * p) - law.due * p


@lookahead_memory.register(Relaxed)
def _memory_of_branches(law, memory, p):
    return memory.copy()


@predict.register(LookaheadUnits)
def _predict(law, memory, p, w):
    w[:] = 0.0
    for k in range(law.decay.size):
        for i in range(w.size):
            w[i] += memory[k, i]


@advance_memory.register(LookaheadUnits)
def _advance_memory(law, memory, w, p, new):
    for k in range(law.decay.size):
        decay, due = law.decay[k], law.due[k]
        for i in range(w.size):
            v = decay * memory[k, i] - due * new[i]
            memory[k, i] = v if abs(v) > MIN_MAGNITUDE else 0.0


@slide_element.register(LookaheadUnits)
def _slide_one(law, y, d, heights, forces):
    total, whole = 0.0, heights.size // BLOCK_SAMPLES * BLOCK_SAMPLES
    for i in range(0, whole, BLOCK_SAMPLES):
        block = forces[i : i + BLOCK_SAMPLES]
        for m in range(BLOCK_SAMPLES):
            block[m] = law.stiffness * (d - heights[i + m])
        _add_memory_forces(law.ahead, y, block)
        before = total
        for m in range(BLOCK_SAMPLES):
            force = block[m]
            for r in range(m):
                force -= law.echo[m - r - 1] * block[r]
            block[m] = max(force, 0.0)
            total += block[m]
        for k in range(y.size):
            y[k] *= law.left[k]
        for m in range(0, BLOCK_SAMPLES, 4):
            first, second, third, fourth = block[m], block[m + 1], block[m + 2], block[m + 3]
            removed = law.removed[m : m + 4]
            for k in range(y.size):
                y[k] -= (removed[0, k] * first + removed[1, k] * second) + (
                    removed[2, k] * third + removed[3, k] * fourth
                )
        if total == before:
            for k in range(y.size):
                y[k] = y[k] if abs(y[k]) > MIN_MAGNITUDE else 0.0
    for i in range(whole, heights.size):
        depth = d - heights[i]
        for k in range(y.size):
            depth += y[k]
        forces[i] = law.stiffness * max(depth, 0.0)
        total += forces[i]
        for k in range(y.size):
            v = law.decay[k] * y[k] - law.due[k] * forces[i]
            y[k] = v if abs(v) > MIN_MAGNITUDE else 0.0
    return total


@inlined_kernel
def _add_memory_forces(ahead, y, block):
    """Add the contributions of internal variables y (K,) to the forces of a block.

    ahead (K, BLOCK_SAMPLES) : contribution of each variable per unit value.
    """
    fours = y.size // 4 * 4
    for k in range(0, fours, 4):
        first, second, third, fourth = y[k], y[k + 1], y[k + 2], y[k + 3]
        some = ahead[k : k + 4]
        for m in range(BLOCK_SAMPLES):
            block[m] += (some[0, m] * first + some[1, m] * second) + (
                some[2, m] * third + some[3, m] * fourth
            )
    for k in range(fours, y.size):
        for m in range(BLOCK_SAMPLES):
            block[m] += ahead[k, m] * y[k]


@slide_element.register(Relaxed)
def _slide_of_branches(law, y, d, heights, forces):
    total = 0.0
    for i in range(heights.size):
        w = predict_element(law, y)
        forces[i] = law.stiffness * max(w + (d - heights[i]), 0.0)
        total += forces[i]
        advance_element(law, y, w, forces[i])
    return total


@fill_memory.register(LookaheadUnits)
def _fill_memory(law, y, p, memory, at, stride, count):
    for k in range(y.size):
        decay, due, fresh, v, j = law.decay[k], law.due[k], law.fresh[k], y[k], at
        for _ in range(count):
            memory[k, j] = v - fresh * p[j]
            v = decay * v - due * p[j]
            j += stride
        y[k] = v if abs(v) > MIN_MAGNITUDE else 0.0


@fill_memory.register(Relaxed)
def _fill_memory_of_branches(law, y, p, memory, at, stride, count):
    for j in range(at, at + stride * count, stride):
        advance_element(law, y, predict_element(law, y), p[j])
        for k in range(y.size):
            memory[k, j] = y[k]
