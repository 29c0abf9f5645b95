"""A rig of elements with Prony series, which steps only elements that can touch.

Elements are chosen and their memory is scaled as in scene/march_blocks.py. The forces of a step
are added to the memory when the step is accepted.
"""

from typing import Any, NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..model.balance import balance_rows
from ..rheology.law import Elements, law_of
from ..rheology.retardation import Retardation
from ..rheology.scaled_units import BLOCK_ELEMENTS, advance_scales, predict_block, rescale_blocks
from ..scene.march_blocks import (
    MAX_SHIFT_SAMPLES,
    ElementBlocks,
    can_touch,
    cap_over,
    in_blocks,
    round_apart,
)
from ..scene.samples import samples_per_contact
from ..scene.spring_rows import SpringRows, forget_evaluation, spring_rows_of
from .rig import RIG_STATE, accept, attempt, patch_width, trial_friction
from .shiftable_line import ShiftableLine, heights_at, interval_at

# State of a block rig: one record, changed in place.
BLOCK_RIG_STATE = np.dtype(
    [
        *RIG_STATE.descr,
        ("steps", np.int64),  # number of accepted steps
        ("begin", np.int64),  # interval over element 0 when blocks were chosen, or -1
        ("count", np.int64),  # number of chosen blocks
        ("chosen_d", np.float64),  # indentation when blocks were chosen, in h
        ("cap", np.float64),  # maximum indentation at which other blocks cannot touch, in h
    ]
)


class BlockRig(NamedTuple):
    """A line on blocks of elements; the arrays are changed in place."""

    form: Retardation
    control: Any  # determines the indentation (model/balance.py)
    line: ShiftableLine
    blocks: ElementBlocks  # their memory includes the forces of all accepted steps
    p: np.ndarray  # shape (blocks, BLOCK_ELEMENTS): forces of the last accepted step
    rows: SpringRows
    z: np.ndarray  # shape (n,): heights of the line at the chosen blocks, in h
    state: np.ndarray  # BLOCK_RIG_STATE, shape (1,)


def block_rig(form: Any, control: Any, line: ShiftableLine, elements: Elements) -> BlockRig:
    """Return a rig in its initial state; form : a Retardation."""
    start, n = in_blocks(elements, 0), elements.p.size
    p, rows = np.maximum(-start.c, 0.0), spring_rows_of(start.c)
    state = np.zeros(1, BLOCK_RIG_STATE)
    state["d"] = state["trial_d"] = state["chosen_d"] = start.d
    state["begin"], state["cap"] = -1, np.inf
    return BlockRig(form, control, line, start.blocks, p, rows, np.empty(n), state)


@attempt.register(BlockRig)
def _attempt(rig, places, dt):
    law, n, state = law_of(rig.form, dt), rig.z.size, rig.state[0]
    old = state["d"]
    begin, t = interval_at(rig.line, places.after)
    if state["begin"] < 0 or round_apart(begin, state["begin"], n) > MAX_SHIFT_SAMPLES:
        _choose(rig, begin, old, state["chosen_d"])
        state["begin"], state["chosen_d"] = begin, old
    _balance(rig, law, begin, t)
    highest = rig.rows.evaluation[0]["highest_d"]
    while highest > state["cap"]:  # other elements could have touched there
        _choose(rig, state["begin"], highest, old)
        _balance(rig, law, begin, t)
        highest = rig.rows.evaluation[0]["highest_d"]
    c, d, count = rig.rows.c, state["trial_d"], 0
    touching, p = np.empty(n, np.int64), np.empty(n)
    for b in rig.rows.some[: state["count"]]:
        for i in range(BLOCK_ELEMENTS):
            if c[b, i] < d:
                touching[count], p[count] = b * BLOCK_ELEMENTS + i, law.stiffness * (d - c[b, i])
                count += 1
    return trial_friction(rig, places, law.lag, touching[:count], p[:count]), law.lag


@kernel
def _choose(rig, begin, d, before):
    """Choose the blocks that can touch at the indentation d; before : an earlier indentation."""
    cap, count, state = cap_over(d, before, rig.line.lowest), 0, rig.state[0]
    for b in range(rig.p.shape[0]):
        if can_touch(rig.line.lowest, begin, b, rig.z.size, cap) or np.any(rig.p[b] > 0.0):
            rig.rows.some[count] = b
            count += 1
    state["cap"], state["count"] = cap, count


@kernel
def _balance(rig, law, begin, t):
    """Find the indentation at the end of a step, where element 0 is at t of interval ``begin``."""
    state = rig.state[0]
    memory, known_steps, scales = rig.blocks
    c, _, sums, evaluation = rig.rows
    some, old, stale = rig.rows.some[: state["count"]], state["d"], law.stale.sum()
    rows = SpringRows(c, some, sums, evaluation)
    rescale_blocks(scales, memory, known_steps, some, state["steps"])
    share, w = law.decay * scales.scale, np.empty(BLOCK_ELEMENTS)
    forget_evaluation(rows)
    for b in some:
        z = rig.z[b * BLOCK_ELEMENTS : (b + 1) * BLOCK_ELEMENTS]
        heights_at(rig.line, begin + b * BLOCK_ELEMENTS, t, z)
        predict_block(share, memory, b, w)
        for i in range(z.size):
            c[b, i] = z[i] - (w[i] - stale * rig.p[b, i])
    state["trial_d"] = balance_rows(rig.control, law, rows, old, state["steps"] + 1)[0]


@accept.register(BlockRig)
def _accept(rig, dt):
    law, state = law_of(rig.form, dt), rig.state[0]
    memory, known_steps, scales = rig.blocks
    state["steps"] += 1
    advance_scales(law, scales, state["steps"])
    some = rig.rows.some[: state["count"]]
    rescale_blocks(scales, memory, known_steps, some, state["steps"])
    fresh, stale = law.fresh / scales.scale, law.stale / scales.scale
    for b in some:
        for i in range(BLOCK_ELEMENTS):
            depth = state["trial_d"] - rig.rows.c[b, i]
            new, old = law.stiffness * depth if depth > 0.0 else 0.0, rig.p[b, i]
            rig.p[b, i] = new
            for k in range(fresh.size if new > 0.0 or old > 0.0 else 0):
                memory[b, k, i] -= fresh[k] * new + stale[k] * old
    d = state["trial_d"] + law.lag * (state["d"] - state["trial_d"])
    state["d"] = state["trial_d"]
    return state["normal_sum"] / rig.z.size, d, state["touching_sum"] / rig.z.size


@patch_width.register(BlockRig)
def _patch_width(rig):
    return samples_per_contact(rig.p.reshape(-1)[: rig.z.size])
