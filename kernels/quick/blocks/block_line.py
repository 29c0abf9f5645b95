"""The body of a line in blocks (see the package): attempts, forces and acceptance of a step."""

from typing import Any, NamedTuple

import numpy as np

from ...body.force_means import mean_forces
from ...body.ground import cell_minima, fill_slopes, fill_thresholds, first_sample
from ...body.patch_width import median_patch_width
from ...body.step import accept, attempt, elements_of, end_leg, forces, on_ground, patch_width
from ...compile.jit import inlined_kernel, kernel
from ...model.balance import balance_rows
from ...rheology.law import Elements
from ...rheology.retardation import Retardation
from .choice import Choice, can_touch, cap_over, is_near
from .scaled_units import (
    BLOCK_ELEMENTS,
    MIN_DECAY,
    Indenter,
    ScaledUnits,
    advance_scales,
    apply_and_predict,
    element_force,
    prepare_attempt,
    rescale_blocks,
    scaled_units,
    unscaled,
)
from .spring_rows import (
    EVALUATION,
    SUM_COLUMNS,
    SpringRows,
    add_overlap,
    add_weighted,
    clear,
    fold,
    forget_evaluation,
)


class BlockLine(NamedTuple):
    """Prony elements in blocks under a line; the arrays of elements are changed in place."""

    form: Retardation
    control: Any  # determines the indentation (model/balance.py)
    ground: Any  # the line over them (body/ground.py)
    lowest: np.ndarray  # lower bounds of its heights (body/ground.py)
    size: int  # number of elements, without padding of the last block
    units: ScaledUnits
    c: np.ndarray  # shape (2, blocks, BLOCK_ELEMENTS): thresholds of the last accepted and of the
    # attempted step; inf: cannot touch
    some: np.ndarray  # numbers of the chosen blocks come first
    sums: np.ndarray  # workspace of SpringRows
    evaluation: np.ndarray  # EVALUATION of SpringRows
    touching: np.ndarray  # workspace of _patch_width
    load_of_width: np.ndarray  # workspace of median_patch_width


class BlockState(NamedTuple):
    """State of a BlockLine besides its arrays."""

    old_d: float  # indentation before the last accepted step, in h
    d: float  # after it
    attempted_d: float  # after the step that was attempted last
    passes: int  # over the thresholds, in all attempts
    steps: int  # that were accepted
    final: bool  # whether the memory includes the forces before the attempted step
    side: int  # number of the thresholds of the last accepted step
    attempted_side: int  # of the attempted step; if final, the same, as fewer data are faster
    last: Indenter  # of the last accepted step
    choice: Choice


@kernel
def block_line(form, control, ground, elements):
    """Return (BlockLine, BlockState) of Elements before their first step on a ground."""
    n, d = elements.p.size, elements.d
    units = scaled_units(elements.memory)
    blocks = units.known_steps.size
    c, p = np.full((2, blocks, BLOCK_ELEMENTS), np.inf), elements.p
    for i in range(n):
        c[0, i // BLOCK_ELEMENTS, i % BLOCK_ELEMENTS] = -p[i]
    sums, evaluation = np.empty((3, SUM_COLUMNS)), np.empty(1, EVALUATION)
    room = np.empty(c[0].size + blocks + 1), np.zeros(n)
    some, lowest = np.empty(blocks, np.int64), cell_minima(ground)
    body = BlockLine(form, control, ground, lowest, n, units, c, some, sums, evaluation, *room)
    start = Indenter(0.0, 1.0)
    return body, BlockState(d, d, d, 0, 0, True, 0, 0, start, Choice(-1, np.inf, d, 0))


@on_ground.register(BlockLine)
def _on_ground(body, state, ground):
    body = body._replace(ground=ground, lowest=cell_minima(ground))
    return body, state._replace(choice=state.choice._replace(begin=-1))


@attempt.register(BlockLine)
def _attempt(body, state, law, step):
    begin, choice = first_sample(body.ground, step.after), state.choice
    if not is_near(begin, choice, body.size):
        cap = cap_over(state.d, choice.chosen_d, body.lowest)
        choice = Choice(begin, cap, state.d, _choose(body, state, begin, cap))
    lacking = prepare_attempt(law, body.units, step.final)
    side = state.side if step.final and lacking == 0.0 else 1 - state.side
    while True:
        d, passes = _balance(body, state, law, step, choice.size, side, lacking)
        for k in range(body.units.drop.size):
            body.units.drop[k] = 0.0  # the memory of all elements with forces includes them now
        highest = body.evaluation[0]["highest_d"]
        if highest <= choice.cap:
            break
        cap = cap_over(highest, state.d, body.lowest)  # other elements could have touched
        count = _choose(body, state, choice.begin, cap)
        choice = Choice(choice.begin, cap, choice.chosen_d, count)
    indentations, sides = (state.old_d, state.d, d), (state.side, side)
    counts = state.passes + passes, state.steps
    return BlockState(*indentations, *counts, step.final, *sides, state.last, choice)


@inlined_kernel
def _choose(body, state, begin, cap):
    """List the blocks that can touch, or did in the last step; return their number."""
    c, count = body.c[state.side], 0
    for b in range(c.shape[0]):
        chosen = can_touch(body.lowest, begin, b, body.size, cap)
        if not chosen and min(body.c[0, b, 0], body.c[1, b, 0]) < np.inf:
            chosen = _is_pressed(c[b], state.last.level)
            for i in range(0 if chosen else BLOCK_ELEMENTS):
                body.c[0, b, i] = body.c[1, b, i] = np.inf
        if chosen:
            body.some[count] = b
            count += 1
    return count


@inlined_kernel
def _balance(body, state, law, step, count, side, lacking):
    """Return (d, passes) of a step of the first ``count`` listed blocks, and set thresholds."""
    units, some, room = body.units, body.some[:count], body.units.room
    c, new = body.c[state.side], body.c[side]
    rescale_blocks(units, some, state.steps)
    rows = SpringRows(new, some, body.sums[:2], body.evaluation)
    forget_evaluation(rows)
    for b in some:
        apply_and_predict(units, b, state.last, c[b])
        for i in range(BLOCK_ELEMENTS if lacking > 0.0 else 0):
            room[i] -= lacking * room[BLOCK_ELEMENTS + i]
        first = b * BLOCK_ELEMENTS
        fill_thresholds(body.ground, step.after, first, body.size, room, new[b])
    return balance_rows(body.control, law, rows, state.d, step.number)


@forces.register(BlockLine)
def _forces(body, state, law, step):
    c, d, sums = body.c[state.attempted_side], state.attempted_d, body.sums
    rows = SpringRows(c, body.some[: state.choice.size], sums, body.evaluation)
    slope = body.units.room[:BLOCK_ELEMENTS]
    clear(sums)
    for b in rows.some:
        if _is_pressed(c[b], d):
            fill_slopes(body.ground, step, law.lag, b * BLOCK_ELEMENTS, body.size, slope)
            add_overlap(rows, b, d)
            add_weighted(rows, b, slope, d)
    fold(sums)
    normal, tangential = law.stiffness * sums[0, 0], law.stiffness * sums[2, 0]
    return mean_forces((normal, tangential, sums[1, 0]), body.size)


@accept.register(BlockLine)
def _accept(body, state, law):
    steps, d, side, units = state.steps + 1, state.attempted_d, state.attempted_side, body.units
    if not state.final:
        _subtract_due(body, state)
    advance_scales(law, units, steps)
    for k in range(law.decay.size):
        if law.decay[k] < MIN_DECAY:
            _remember_force(body, state, k, law.stale[k], steps)
    last = Indenter(d, law.stiffness)
    return BlockState(state.d, d, d, state.passes, steps, True, side, side, last, state.choice)


@inlined_kernel
def _subtract_due(body, state):
    """Subtract the forces of the last accepted step from the memory of the listed blocks."""
    units, c = body.units, body.c[state.side]
    for b in body.some[: state.choice.size]:
        for k in range(units.due.size if _is_pressed(c[b], state.last.level) else 0):
            due = units.due[k]
            for i in range(BLOCK_ELEMENTS):
                units.memory[b, k, i] -= due * element_force(state.last, c[b, i])


@inlined_kernel
def _remember_force(body, state, k, stale, step):
    """Set the memory of units k to -stale p, with p of the last accepted step."""
    units, some, c = body.units, body.some[: state.choice.size], body.c[state.side]
    rescale_blocks(units, some, step)
    for b in some:
        for i in range(BLOCK_ELEMENTS):
            units.memory[b, k, i] = -stale * element_force(state.last, c[b, i])


@end_leg.register(BlockLine)
def _end_leg(body, state):
    units, c = body.units, body.c[state.side]
    rescale_blocks(units, range(c.shape[0]), state.steps)
    for b in range(c.shape[0]):
        for k in range(units.share.size):
            for i in range(BLOCK_ELEMENTS):
                p = element_force(state.last, c[b, i])
                units.memory[b, k, i] = unscaled(units, b, k, i, p)
    for k in range(units.share.size):
        units.scales.scale[k], units.fresh[k] = 1.0, 0.0
    return state


@patch_width.register(BlockLine)
def _patch_width(body, state):
    """Count in blocks with contact; a zero separates blocks that are not neighbours."""
    c, touching, stored, next_block = body.c[state.side], body.touching, 0, 0
    for b in body.some[: state.choice.size]:
        if not _is_pressed(c[b], state.last.level):
            continue
        if b != next_block:
            touching[stored] = 0.0
            stored += 1
        of_block = touching[stored : stored + BLOCK_ELEMENTS]
        for i in range(BLOCK_ELEMENTS):
            of_block[i] = element_force(state.last, c[b, i])
        stored += min(BLOCK_ELEMENTS, body.size - b * BLOCK_ELEMENTS)
        next_block = b + 1
    if next_block * BLOCK_ELEMENTS < body.size:
        touching[stored] = 0.0
        stored += 1
    return median_patch_width(touching[:stored], body.load_of_width)


@inlined_kernel
def _is_pressed(c, level):
    """Return whether an element of a block touches."""
    touching = 0  # a count, as a loop that ends early is not vectorized
    for i in range(BLOCK_ELEMENTS):
        touching += 1 if c[i] < level else 0
    return touching > 0


@elements_of.register(BlockLine)
def _elements_of(body, state):
    units, n, c = body.units, body.size, body.c[state.side]
    rescale_blocks(units, range(c.shape[0]), state.steps)
    memory, p = np.empty((units.share.size, n)), np.empty(n)
    for i in range(n):
        b, place = i // BLOCK_ELEMENTS, i % BLOCK_ELEMENTS
        p[i] = element_force(state.last, c[b, place])
        for k in range(units.share.size):
            memory[k, i] = unscaled(units, b, k, place, p[i])
    return Elements(memory, p, state.d)
