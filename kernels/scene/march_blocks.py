"""Following a programme with the elements alone that can touch.

An element is never pulled up, so that none touches where the line lies above a cap that the
indentation does not reach. Elements are stepped block by block where some of the line is below
the cap; the memory of all others counts in what decays as it does (rheology/scaled.py) and needs
no step. Where the indentation passes the cap, more blocks are looked at in the same step. Which
they are changes no bit.

A block is settled when it is looked at next: what the last step did to its memory and what that
does in the coming one is one pass over it. At the end of a leg memory counts as it is again, so
that a programme that is cut between legs goes on to the bit.

The plain march (follow.py) is what it is tested against.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import inlined, kernel
from ..model.balance import balance_rows
from ..model.contact import SpringRows
from ..model.friction import weighed
from ..rheology.law import NEGLIGIBLE, Elements, law_of
from ..rheology.scaled import (
    BLOCK,
    Scales,
    all_settled,
    as_it_is,
    catch_up,
    go_on,
    look_ahead,
    settle_and_predict,
)
from .cycles import add_impulses
from .energy import keep_energies
from .follow import book_step, first_after, seen_at
from .records import count_lengths, keep_forces, keep_frame, keep_motion
from .samples import samples_per_contact

CELL = 16  # samples of which the lowest is known
SLACK = 16  # samples that the line may move before the blocks are chosen anew
SPARE = 0.02  # of the indentation, to the cap


class ElementBlocks(NamedTuple):
    """The memory of elements in blocks, of which elements that nothing meets fill up the last."""

    memory: np.ndarray  # scaled, shape (blocks, K, BLOCK)
    seen: np.ndarray  # shape (blocks,): the last step that the memory knows of
    pressed: np.ndarray  # shape (blocks,): 0 where no force acts, nor has in the step before
    scales: Scales


class BlockElements(NamedTuple):
    """The same with the forces, in 4 G dx h, and the indentation."""

    blocks: ElementBlocks
    p: np.ndarray  # shape (blocks, BLOCK): of the last step
    older: np.ndarray  # of the step before
    d: float  # in h


class Rows(NamedTuple):
    """Room for what is found out about some blocks in a step, a row for each."""

    active: np.ndarray  # the blocks that can touch
    springs: SpringRows  # their thresholds
    total: np.ndarray  # for rheology/scaled.py


class Choice(NamedTuple):
    """Which blocks are looked at, and for how long."""

    at: int  # the sample of element 0 where they were chosen, or -1
    cap: float  # none of the others touches below this indentation, in h
    chosen: float  # the indentation before the step in which they were chosen
    number: int  # of them


@kernel
def in_blocks(elements, done):
    """Return the BlockElements of Elements, after a number of steps."""
    units, n = elements.memory.shape
    count = (n + BLOCK - 1) // BLOCK
    memory, p = np.zeros((count, units, BLOCK)), np.zeros((count, BLOCK))
    pressed = np.zeros(count, np.int64)
    for b in range(count):
        of = elements.p[b * BLOCK : (b + 1) * BLOCK]
        for i in range(of.size):
            p[b, i] = of[i]
            pressed[b] = 2 if of[i] != 0.0 else pressed[b]
        for k in range(units):
            y = elements.memory[k, b * BLOCK : (b + 1) * BLOCK]
            for i in range(y.size):
                memory[b, k, i] = y[i]
    blocks = ElementBlocks(memory, np.full(count, done), pressed, as_it_is(units, done))
    return BlockElements(blocks, p, np.zeros_like(p), elements.d)


@kernel
def elements_of(state, n):
    """Return the n Elements of BlockElements whose blocks know of all steps."""
    return Elements(_memory(state.blocks, n), state.p.copy().reshape(-1)[:n], state.d)


@kernel
def _memory(blocks, n):
    """Return the memory as it is, shape (K, n), of blocks that know of all steps."""
    memory = np.empty((blocks.memory.shape[1], n))
    for b in range(blocks.seen.size):
        for k in range(memory.shape[0]):
            y, scale = memory[k, b * BLOCK : (b + 1) * BLOCK], blocks.scales.scale[k]
            for i in range(y.size):
                y[i] = scale * blocks.memory[b, k, i]
    return memory


@kernel
def follow_blocks(
    form, control, track, state, done, ends, kept, frames, trace, ledger, lengths, film, spell
):
    """Take BlockElements along a track; return (state, passes).

    form : a Retardation. ends : increasing numbers of the steps at which legs end. The others, and
    what is kept, are as of ``follow``. The arrays of the state are changed.
    """
    blocks, p, older, d = state
    n, passes, rows = track.z.shape[1] // 2, 0, room_for_blocks(blocks.seen.size)
    lowest, choice = _lowest(track.z), Choice(-1, np.inf, d, 0)
    k, frame, end = first_after(kept, done), first_after(frames, done), first_after(ends, done)
    law = law_of(form, track.dt[0])
    for s in range(track.dt.size):
        step, old = done + s + 1, d
        if s > 0 and track.dt[s] != track.dt[s - 1]:
            law = law_of(form, track.dt[s])
        every = ledger is not None
        d, used, choice = _move(
            control, law, blocks, p, older, step, rows, lowest, choice, every, track, s, old
        )
        passes += used
        p, older = older, p
        if film is not None and frame < frames.size and step == frames[frame]:
            z = seen_at(track.z, track, s + 1, n)
            _keep_frame(film, frame, law, blocks, p, older, step, z, d)
            frame += 1
        if ledger is not None:
            _book(form, law, ledger, track, s, blocks, p, older, rows.springs.c, old, d)
        _pass_by(law, blocks, step)
        keeping, ending = k < kept.size and step == kept[k], end < ends.size and step == ends[end]
        if ending or (keeping and ledger is not None):
            some = rows.active[: choice.number]
            _predict(law, blocks, p, older, step, some, track.z[0, :n], rows)
        if spell is not None and spell.after < step <= spell.last:
            some = rows.active[: choice.number]
            add_impulses(spell, _sums(law.lag, track, s, some, p), track.dt[s])
        if keeping:
            some = rows.active[: choice.number]
            _keep(k, form, law, track, s, old, d, blocks, some, p, trace, ledger, lengths)
            k += 1
        if ending:
            _count_as_it_is(blocks, step)
            end += 1
    some = rows.active[: choice.number]
    _predict(law, blocks, p, older, done + track.dt.size, some, track.z[0, :n], rows)
    return BlockElements(blocks, p, older, d), passes


@inlined
def _move(control, law, blocks, p, older, step, rows, lowest, choice, every, track, s, old):
    """Take some blocks over a step; return (d, passes, Choice). Their forces fill ``older``.

    every : whether all blocks are to be looked at. s : steps of the track before this one.
    """
    n, begin = track.z.shape[1] // 2, track.begin[s + 1]
    z = track.z[track.line[s + 1], begin : begin + n]
    look_ahead(law, blocks.scales)
    at, cap, chosen, count = choice
    if at < 0 or round_apart(begin, at, n) > SLACK:
        at, cap = begin, np.inf if every else cap_over(old, chosen, lowest)
        count, chosen = choose_blocks(rows.active, lowest, at, n, cap, blocks.pressed), old
    d, passes = balance_blocks(control, law, blocks, p, older, step, count, rows, z, old)
    while rows.springs.highest[0] > cap:  # what was left out would have been looked at
        cap = cap_over(rows.springs.highest[0], old, lowest)
        count = choose_blocks(rows.active, lowest, at, n, cap, blocks.pressed)
        d, passes = balance_blocks(control, law, blocks, p, older, step, count, rows, z, old)
    press_blocks(law, blocks.pressed, older, rows.active[:count], rows.springs.c, d)
    return d, passes, Choice(at, cap, chosen, count)


@inlined
def _pass_by(law, blocks, step):
    """Let a step be over, of which the blocks learn when they are looked at next.

    It is called with ``blocks`` as a whole, whose references are then not counted.
    """
    go_on(law, blocks.scales, step)


@kernel
def room_for_blocks(blocks):
    """Return Rows for as many blocks as there are."""
    springs = SpringRows(np.empty((blocks, BLOCK)), np.empty(1), np.empty(BLOCK))
    return Rows(np.empty(blocks, np.int64), springs, np.empty(3 * BLOCK))


@kernel
def _lowest(z):
    """Return the lowest of all lines in each cell of two periods; z : as of a Track."""
    lowest = np.full((z.shape[1] + CELL - 1) // CELL, np.inf)
    for line in range(z.shape[0]):
        for j in range(z.shape[1]):
            lowest[j // CELL] = min(lowest[j // CELL], z[line, j])
    return lowest


@inlined
def cap_over(d, before, lowest):
    """Return a cap above the indentation, and above some of the line.

    before : the indentation of a while ago: it may go on changing as it has.
    """
    deepest = np.inf
    for cell in range(lowest.size):
        deepest = min(deepest, lowest[cell])
    spare = max(SPARE * abs(d - deepest), 4.0 * abs(d - before))
    return max(d, deepest) + max(spare, 1e-9)


@inlined
def round_apart(one, other, n):
    """Return how many samples lie between two, round the period."""
    apart = abs(one - other)
    return min(apart, n - apart)


@inlined
def choose_blocks(active, lowest, begin, n, cap, pressed):
    """List the blocks that can touch while the line moves by SLACK, or do; return their number."""
    count = 0
    for b in range(pressed.size):
        first = (begin + b * BLOCK - SLACK) % n
        last = min(first + BLOCK + 2 * SLACK, 2 * n) - 1
        touchable = pressed[b] > 0
        for cell in range(first // CELL, last // CELL + 1):
            touchable = touchable or lowest[cell] < cap
        if touchable:
            active[count] = b
            count += 1
    return count


@inlined
def balance_blocks(control, law, blocks, p, older, step, count, rows, z, old):
    """Return (d, passes) of a step, taken with the first blocks that are active alone."""
    _predict(law, blocks, p, older, step - 1, rows.active[:count], z, rows)
    rows.springs.highest[0] = -np.inf
    springs = SpringRows(rows.springs.c[:count], rows.springs.highest, rows.springs.sums)
    return balance_rows(control, law, springs, old, step)


@inlined
def _predict(law, blocks, p, older, step, some, z, rows):
    """Find the thresholds of some blocks, all that are pressed among them.

    law : of the step that comes. The blocks learn of all steps until ``step``. p, older : forces of
    that step and of the one before.
    """
    catch_up(blocks.scales, blocks.memory, blocks.seen, some, step)
    settle_and_predict(
        law,
        blocks.scales,
        blocks.memory,
        blocks.pressed,
        p,
        older,
        some,
        z,
        rows.total,
        rows.springs.c,
    )
    all_settled(blocks.scales)


@inlined
def press_blocks(law, pressed, new, some, c, d):
    """Fill the rows of ``new`` that belong to some blocks with the forces of this step."""
    for row in range(some.size):
        b = some[row]
        touching = 0
        for i in range(BLOCK):
            depth = d - c[row, i]
            new[b, i] = law.stiffness * depth if depth > 0.0 else 0.0
            touching += 1 if depth > 0.0 else 0
        pressed[b] = 2 if touching > 0 else max(pressed[b] - 1, 0)


@kernel
def _count_as_it_is(blocks, step):
    """Let the memory of all blocks count as it is; all that are pressed know of the step."""
    memory, seen, _, scales = blocks
    catch_up(scales, memory, seen, np.arange(seen.size), step)
    for b in range(seen.size):
        for k in range(scales.scale.size):
            scale = scales.scale[k]
            for i in range(BLOCK):
                y = scale * memory[b, k, i]
                memory[b, k, i] = y if abs(y) > NEGLIGIBLE else 0.0
    for k in range(scales.scale.size):
        scales.scale[k] = 1.0


@kernel
def _keep(k, form, law, track, s, old, d, blocks, some, p, trace, ledger, lengths):
    """Keep a step as number k of those that are kept."""
    n = track.z.shape[1] // 2
    if trace is not None:
        keep_forces(trace, k, law.lag, _sums(law.lag, track, s, some, p), n, old, d)
        trace.samples_per_contact[k] = samples_per_contact(_forces(p, some, n))
        keep_motion(trace, k, law.lag, track, s)
    if ledger is not None:
        keep_energies(ledger, k, form, _memory(blocks, n), p.reshape(-1)[:n])
    if lengths is not None:
        count_lengths(lengths, p.reshape(-1)[:n])


@kernel
def _forces(p, some, n):
    """Return the forces of some blocks of n elements, one that is free where others lie between."""
    forces = np.zeros(some.size * (BLOCK + 1))
    at = 0
    for row in range(some.size):
        first, after = some[row] * BLOCK, some[row - 1] + 1 if row > 0 else 0
        at += 1 if some[row] != after else 0
        for i in range(min(BLOCK, n - first)):
            forces[at] = p[some[row], i]
            at += 1
    if some.size > 0 and (some[-1] + 1) * BLOCK < n:
        forces = np.append(forces[:at], 0.0)
        at += 1
    return forces[:at]


@kernel
def _sums(lag, track, s, some, p):
    """Return the sums of eq. 5 of a step, whose forces act on elements of some blocks alone."""
    n = track.z.shape[1] // 2
    before, now = seen_at(track.slope, track, s, n), seen_at(track.slope, track, s + 1, n)
    threshold, slope = np.zeros((some.size, BLOCK)), np.zeros((some.size, BLOCK))
    for row in range(some.size):
        b = some[row]
        old_slope, new_slope = before[b * BLOCK : (b + 1) * BLOCK], now[b * BLOCK : (b + 1) * BLOCK]
        for i in range(new_slope.size):
            threshold[row, i] = -p[b, i]
            slope[row, i] = new_slope[i] + lag * (old_slope[i] - new_slope[i])
    return weighed(threshold.reshape(-1), None, slope.reshape(-1), 0.0)


@kernel
def _keep_frame(film, frame, law, blocks, p, older, step, z, d):
    """Keep the line and all elements at the end of a step, of which no memory knows yet."""
    room, every = room_for_blocks(blocks.seen.size), np.arange(blocks.seen.size)
    _predict(law, blocks, older, p, step - 1, every, np.zeros_like(z), room)
    u, forces = -room.springs.c.reshape(-1)[: z.size], p.reshape(-1)
    for i in range(z.size):
        u[i] -= forces[i] / law.stiffness
    keep_frame(film, frame, z, d, u)


@kernel
def _book(form, law, ledger, track, s, blocks, p, older, c, old, d):
    """Book a step of which no memory knows yet; all blocks know the one before and are in c."""
    n = track.z.shape[1] // 2
    before, now = older.reshape(-1)[:n], p.reshape(-1)[:n]
    w = seen_at(track.z, track, s + 1, n) - c.reshape(-1)[:n]
    book_step(form, law, ledger, track, s, _memory(blocks, n), before, now, w, old, d)
