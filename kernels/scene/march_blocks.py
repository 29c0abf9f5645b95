"""Following a programme with the elements alone that can touch.

An element is never pulled up, so that none touches where the line lies above a cap that the
indentation does not reach. Elements are stepped block by block where some of the line is below
the cap; the memory of all others is divided by its decay (rheology/scaled_units.py) and needs no
step. Where the indentation passes the cap, more blocks are looked at in the same step. Which
they are changes no bit.

A step is one pass over the blocks, in which the forces follow from the thresholds of the last step,
and what they do to the memory, and that in the coming step, gives the new thresholds; and as many
passes over these as balance the load. At the end of a leg memory counts as it is again, so that a
programme that is cut between legs goes on to the bit.

The plain march (follow.py) is what it is tested against.
"""

from typing import Any, NamedTuple

import numpy as np

from ..compile.jit import inlined_kernel, kernel
from ..model.balance import balance_rows
from ..motion.track import Track
from ..rheology.law import MIN_MAGNITUDE, Elements, law_of
from ..rheology.prony import Prony, fill_law
from ..rheology.retardation import Retardation
from ..rheology.scaled_units import (
    BLOCK_ELEMENTS,
    Indenter,
    Scales,
    advance_and_predict,
    advance_scales,
    element_force,
    mark_forces_applied,
    predict_block,
    rescale_blocks,
    unit_scales,
)
from .cycles import add_impulses
from .energy import keep_energies
from .follow import book_step, first_after, seen_at
from .records import count_lengths, keep_forces, keep_frame, keep_motion
from .samples import median_over_load
from .spring_rows import (
    COLUMNS,
    SpringRows,
    add_overlap,
    fold,
    refilled,
    spring_rows_of,
)

CELL = 16  # samples of which the lowest is known
SLACK = 16  # samples that the line may move before the blocks are chosen anew
SPARE = 0.02  # of the indentation, to the cap


class ElementBlocks(NamedTuple):
    """The memory of elements in blocks, of which elements that nothing meets fill up the last."""

    memory: np.ndarray  # scaled, shape (blocks, K, BLOCK_ELEMENTS)
    seen: np.ndarray  # shape (blocks,): the last step that the memory knows of
    scales: Scales


class BlockElements(NamedTuple):
    """Elements in blocks after a step whose force their memory may not know of yet."""

    blocks: ElementBlocks
    c: np.ndarray  # thresholds in it, shape (blocks, BLOCK_ELEMENTS); infinite where none can touch
    last: Indenter
    d: float  # in h


class Choice(NamedTuple):
    """Which blocks are looked at, and for how long."""

    at: int  # the sample of element 0 where they were chosen, or -1
    cap: float  # none of the others touches below this indentation, in h
    chosen: float  # the indentation before the step in which they were chosen
    number: int  # of them


class BlockMarch(NamedTuple):
    """What a march along a track goes by, and room for what it does."""

    form: Retardation
    control: Any  # what the indentation follows from (model/balance.py)
    track: Track
    done: int  # steps before it
    every: bool  # whether all blocks are looked at
    lowest: np.ndarray  # of all lines, in cells
    blocks: ElementBlocks
    rows: SpringRows  # the thresholds of blocks, of which those that are chosen come first
    constants: np.ndarray  # of the law of the last step, as fill_law leaves them
    room: np.ndarray  # of advance_and_predict
    depths: np.ndarray  # of _sums
    carried: np.ndarray  # of median_over_load


class Progress(NamedTuple):
    """How far a march has come."""

    passes: int  # over the thresholds
    old: float  # indentation before the last step, in h
    d: float  # after it
    last: Indenter
    law: tuple[float, float, float]  # of the last step: what fill_law returns
    choice: Choice


@kernel
def in_blocks(elements, done):
    """Return the BlockElements of Elements, after a number of steps."""
    units, n = elements.memory.shape
    count = (n + BLOCK_ELEMENTS - 1) // BLOCK_ELEMENTS
    memory, c = np.zeros((count, units, BLOCK_ELEMENTS)), np.full((count, BLOCK_ELEMENTS), np.inf)
    for b in range(count):
        first, size = b * BLOCK_ELEMENTS, min(BLOCK_ELEMENTS, n - b * BLOCK_ELEMENTS)
        c[b, :size] = -elements.p[first : first + size]
        memory[b, :, :size] = elements.memory[:, first : first + size]
    blocks = ElementBlocks(memory, np.full(count, done), unit_scales(units, done))
    return BlockElements(blocks, c, Indenter(0.0, 1.0), elements.d)


@kernel
def elements_of(state, n):
    """Return the n Elements of BlockElements."""
    p = _forces(state.c, state.last)[:n]
    return Elements(_memory(state.blocks, p), p, state.d)


@kernel
def _forces(c, last):
    """Return the forces of all elements, shape (blocks * BLOCK_ELEMENTS,)."""
    p = np.empty(c.size)
    thresholds = c.reshape(-1)
    for i in range(p.size):
        p[i] = element_force(last, thresholds[i])
    return p


@kernel
def _memory(blocks, p):
    """Return the memory as it is, shape (K, n); p : forces of the last step, shape (n,)."""
    memory = np.empty((blocks.memory.shape[1], p.size))
    for k in range(memory.shape[0]):
        scale, fresh = blocks.scales.scale[k], blocks.scales.fresh[k]
        for i in range(p.size):
            memory[k, i] = _known(
                scale, fresh, blocks.memory[i // BLOCK_ELEMENTS, k, i % BLOCK_ELEMENTS], p[i]
            )
    return memory


@inlined_kernel
def _known(scale, fresh, scaled, p):
    """Return memory as it is, which knows of the force p of the last step."""
    y = scale * scaled - fresh * p
    return y if abs(y) > MIN_MAGNITUDE else 0.0


@kernel
def follow_blocks(
    form, control, track, state, done, ends, kept, frames, trace, ledger, lengths, film, spell
):
    """Take BlockElements along a track; return (state, passes).

    form : a Retardation. ends : increasing numbers of the steps at which legs end. The others, and
    what is kept, are as of ``follow``. The arrays of the state are changed.
    """
    blocks, c, last, d = state
    n, s, rows = track.z.shape[1] // 2, 0, spring_rows_of(c)
    k, frame, end = first_after(kept, done), first_after(frames, done), first_after(ends, done)
    room = np.empty((5, blocks.memory.shape[1])), np.empty(2 * BLOCK_ELEMENTS)
    more_room = np.empty(c.size + c.shape[0] + 1), np.zeros(n)
    every, lowest, memory = ledger is not None, _lowest(track.z), np.empty((0, n))
    march = BlockMarch(form, control, track, done, every, lowest, blocks, rows, *room, *more_room)
    now = Progress(0, d, d, last, (1.0, 0.0, 0.0), Choice(-1, np.inf, d, 0))
    while s < track.dt.size:
        until = min(_number(kept, k), _number(frames, frame), _number(ends, end)) - done
        until = min(until, track.dt.size)
        if ledger is not None or (spell is not None and spell.after < done + until):
            until = s + 1
        if ledger is not None:
            p = _forces(c, last)[:n]
            memory = _memory(blocks, p)
        now = _march(march, now, s, until)
        s, step, last, d = until, done + until, now.last, now.d
        if film is not None and frame < frames.size and step == frames[frame]:
            z = seen_at(track.z, track, s, n)
            _keep_frame(film, frame, blocks, step, _forces(c, last), z, d, last.stiffness)
            frame += 1
        if ledger is not None:
            w = seen_at(track.z, track, s, n) - c.reshape(-1)[:n]
            new, law = _forces(c, last)[:n], law_of(form, track.dt[s - 1])
            book_step(form, law, ledger, track, s - 1, memory, p, new, w, now.old, d)
        if spell is not None and spell.after < step <= spell.last:
            sums, _ = _sums(march, now, s)
            add_impulses(spell, sums, track.dt[s - 1])
        if k < kept.size and step == kept[k]:
            if trace is not None:
                _keep_trace(trace, k, march, now, s)
            if ledger is not None:
                keep_energies(ledger, k, form, _memory(blocks, new), new)
            if lengths is not None:
                count_lengths(lengths, _forces(c, last)[:n])
            k += 1
        if end < ends.size and step == ends[end]:
            _count_as_it_is(blocks, _forces(c, last), step)
            end += 1
    return BlockElements(blocks, c, last, d), now.passes


@inlined_kernel
def _number(numbers, k):
    """Return number k of some, or one above all steps where there is none."""
    return numbers[k] if k < numbers.size else 2**62


@inlined_kernel
def _march(march, now, s, until):
    """Go on from step s of the track to another; return Progress."""
    dt, constants = march.track.dt, march.constants
    passes, old, d, last, of_law, choice = now
    for t in range(s, until):
        if t == 0 or dt[t] != dt[t - 1]:
            of_law = fill_law(march.form, dt[t], constants)
        law, old = Prony(constants[0], constants[1], constants[2], *of_law), d
        d, used, choice = _step(march, law, t, old, last, choice)
        passes += used
        last = Indenter(d, law.stiffness)
    return Progress(passes, old, d, last, of_law, choice)


@inlined_kernel
def _step(march, law, t, old, last, choice):
    """Take some blocks over step t from the indentation ``old``; return (d, passes, Choice).

    last : Indenter of the last step. Their thresholds fill the rows.
    """
    track, rows, lowest = march.track, march.rows, march.lowest
    n, begin = track.z.shape[1] // 2, track.begin[t + 1]
    advance_scales(law, march.blocks.scales, march.done + t + 1)
    at, cap, chosen, count = choice
    if at < 0 or round_apart(begin, at, n) > SLACK:
        at, cap = begin, np.inf if march.every else cap_over(old, chosen, lowest)
        count, chosen = _choose(rows, lowest, at, n, cap, last.level), old
    while True:
        d, passes = _balance(march, law, t, old, last, count)
        if rows.highest[0] <= cap:
            return d, passes, Choice(at, cap, chosen, count)
        cap = cap_over(rows.highest[0], old, lowest)  # what was left out would have been looked at
        count = _choose(rows, lowest, at, n, cap, last.level)


@inlined_kernel
def _balance(march, law, t, old, last, count):
    """Return (d, passes) of a step, taken with the first blocks that are chosen alone."""
    (memory, seen, scales), room, track = march.blocks, march.room, march.track
    c, some, sums, highest, found = march.rows
    rows, begin = SpringRows(c, some[:count], sums, highest, found), track.begin[t + 1]
    step, z = march.done + t + 1, track.z[track.line[t + 1], begin : begin + track.z.shape[1] // 2]
    rescale_blocks(scales, memory, seen, rows.some, step)
    refilled(rows)
    for b in rows.some:
        advance_and_predict(scales.due, scales.scale, memory, b, last, c[b], room)
        here = z[b * BLOCK_ELEMENTS : (b + 1) * BLOCK_ELEMENTS]
        for i in range(here.size):
            c[b, i] = here[i] - room[i]
    mark_forces_applied(scales)
    return balance_rows(march.control, law, rows, old, step)


@kernel
def _lowest(z):
    """Return the lowest of all lines in each cell of two periods; z : as of a Track."""
    lowest = np.full((z.shape[1] + CELL - 1) // CELL, np.inf)
    for line in range(z.shape[0]):
        for j in range(z.shape[1]):
            lowest[j // CELL] = min(lowest[j // CELL], z[line, j])
    return lowest


@inlined_kernel
def cap_over(d, before, lowest):
    """Return a cap above the indentation, and above some of the line.

    before : the indentation of a while ago: it may go on changing as it has.
    """
    deepest = np.inf
    for cell in range(lowest.size):
        deepest = min(deepest, lowest[cell])
    spare = max(SPARE * abs(d - deepest), 4.0 * abs(d - before))
    return max(d, deepest) + max(spare, 1e-9)


@inlined_kernel
def round_apart(one, other, n):
    """Return how many samples lie between two, round the period."""
    apart = abs(one - other)
    return min(apart, n - apart)


@inlined_kernel
def can_touch(lowest, begin, b, n, cap):
    """Return whether the line is below the cap over block b, while it moves by SLACK."""
    first = (begin + b * BLOCK_ELEMENTS - SLACK) % n
    last = min(first + BLOCK_ELEMENTS + 2 * SLACK, 2 * n) - 1
    below = False
    for cell in range(first // CELL, last // CELL + 1):
        below = below or lowest[cell] < cap
    return below


@inlined_kernel
def _choose(rows, lowest, begin, n, cap, level):
    """List the blocks that can touch, or did in the last step; return their number."""
    count = 0
    for b in range(rows.c.shape[0]):
        chosen = can_touch(lowest, begin, b, n, cap)
        if not chosen and rows.c[b, 0] < np.inf:
            for i in range(BLOCK_ELEMENTS):
                chosen = chosen or rows.c[b, i] < level
            for i in range(0 if chosen else BLOCK_ELEMENTS):
                rows.c[b, i] = np.inf
        if chosen:
            rows.some[count] = b
            count += 1
    return count


@kernel
def _count_as_it_is(blocks, p, step):
    """Let the memory of all blocks count as it is, and know of the last step; p : its forces."""
    memory, seen, scales = blocks
    rescale_blocks(scales, memory, seen, np.arange(seen.size), step)
    for b in range(seen.size):
        of_block = p[b * BLOCK_ELEMENTS : (b + 1) * BLOCK_ELEMENTS]
        for k in range(scales.scale.size):
            scale, fresh = scales.scale[k], scales.fresh[k]
            for i in range(BLOCK_ELEMENTS):
                memory[b, k, i] = _known(scale, fresh, memory[b, k, i], of_block[i])
    for k in range(scales.scale.size):
        scales.scale[k], scales.fresh[k] = 1.0, 0.0


@inlined_kernel
def _keep_trace(trace, k, march, now, s):
    """Keep what there is to know of the last of s steps."""
    lag, track = now.law[1], march.track
    sums, gathered = _sums(march, now, s)
    keep_forces(trace, k, lag, sums, track.z.shape[1] // 2, now.old, now.d)
    trace.samples_per_contact[k] = median_over_load(march.depths[:gathered], march.carried)
    keep_motion(trace, k, lag, track, s - 1)


@inlined_kernel
def _sums(march, now, s):
    """Return the sums of eq. 5 of the last of s steps (model/friction.py), and a number.

    By columns, as in add_overlap. So many depths are noted: how deep elements are, row by row of
    those that touch, and that of a free one where others lie between.
    """
    track, rows, slope, depths = march.track, march.rows, march.room, march.depths
    (stiffness, lag, _), n, sums, at, after = now.law, track.z.shape[1] // 2, rows.sums, 0, 0
    before = track.slope[track.line[s - 1], track.begin[s - 1] :]
    ahead = track.slope[track.line[s], track.begin[s] :]
    for i in range(COLUMNS):
        sums[0, i] = sums[1, i] = sums[2, i] = 0.0
    for b in rows.some[: now.choice.number]:
        touching, size = 0, min(BLOCK_ELEMENTS, n - b * BLOCK_ELEMENTS)
        if b != after:
            depths[at] = 0.0
            at += 1
        deep = depths[at : at + BLOCK_ELEMENTS]
        for i in range(BLOCK_ELEMENTS):
            depth = now.d - rows.c[b, i]
            deep[i] = depth if depth > 0.0 else 0.0
            touching += 1 if depth > 0.0 else 0
        if touching == 0:
            continue
        add_overlap(rows, b, now.d)
        one, two = before[b * BLOCK_ELEMENTS :], ahead[b * BLOCK_ELEMENTS :]
        for i in range(size):
            slope[i] = two[i] + lag * (one[i] - two[i])
        for part in range(0, BLOCK_ELEMENTS, COLUMNS):
            for i in range(COLUMNS):
                sums[2, i] += deep[part + i] * slope[part + i]
        at, after = at + size, b + 1
    if after * BLOCK_ELEMENTS < n:
        depths[at] = 0.0
        at += 1
    fold(sums)
    return (stiffness * sums[0, 0], stiffness * sums[2, 0], sums[1, 0]), at


@kernel
def _keep_frame(film, frame, blocks, step, p, z, d, stiffness):
    """Keep the line and all elements at the end of a step, whose force no memory knows of yet."""
    rescale_blocks(blocks.scales, blocks.memory, blocks.seen, np.arange(blocks.seen.size), step)
    u = np.empty(p.size)
    for b in range(blocks.seen.size):
        predict_block(
            blocks.scales.scale, blocks.memory, b, u[b * BLOCK_ELEMENTS : (b + 1) * BLOCK_ELEMENTS]
        )
    for i in range(z.size):
        u[i] -= p[i] / stiffness
    keep_frame(film, frame, z, d, u[: z.size])
