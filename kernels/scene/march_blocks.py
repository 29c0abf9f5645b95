"""March through a programme, for Prony series, that steps only elements that can touch.

An element is never pulled up, so it cannot touch where the line lies above a cap that exceeds the
indentation. Only blocks with part of the line below the cap are stepped. The memory of the others
needs no step because it is stored divided by its decay (rheology/scaled_units.py). If the
indentation exceeds the cap, more blocks are added in the same step. Results are bitwise independent
of the choice of blocks.

A step takes one pass over the blocks, and as many passes over their thresholds as balance the load.
The pass over the blocks computes the forces from the thresholds of the last step, adds them to the
memory, predicts the memory in the new step and fills the new thresholds. At the end of a leg the
memory is unscaled, so that a programme cut between legs resumes bit for bit.
Tests compare this march with that of all elements (march_elements.py).
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
from .energy import record_energies
from .march_elements import add_step_energies, first_after, line_at_step
from .records import count_lengths, record_forces, record_motion, record_snapshot
from .samples import median_patch_width
from .spring_rows import (
    SUM_COLUMNS,
    SpringRows,
    add_overlap,
    fold,
    forget_evaluation,
    spring_rows_of,
)

CELL_SAMPLES = 16  # per stored minimum of the line
MAX_SHIFT_SAMPLES = 16  # shift of the line after which blocks are chosen again
CAP_MARGIN = 0.02  # distance of the cap from the indentation, over the indentation
AFTER_ALL_STEPS = 2**62


class ElementBlocks(NamedTuple):
    """Memory of elements in blocks; the last block is padded with elements that never touch."""

    memory: np.ndarray  # scaled, shape (blocks, K, BLOCK_ELEMENTS)
    known_steps: np.ndarray  # shape (blocks,): last step included in the memory
    scales: Scales


class BlockElements(NamedTuple):
    """Elements in blocks after a step; their memory may not yet include the forces of that step."""

    blocks: ElementBlocks
    c: np.ndarray  # thresholds of the step, shape (blocks, BLOCK_ELEMENTS); inf: cannot touch
    last: Indenter  # of the step
    d: float  # in h


class Choice(NamedTuple):
    """Choice of the blocks that can touch, and its range of validity."""

    begin: int  # sample over element 0 when the blocks were chosen, or -1
    cap: float  # maximum indentation at which other blocks cannot touch, in h
    chosen_d: float  # indentation before the step in which the blocks were chosen, in h
    block_count: int


class BlockMarch(NamedTuple):
    """Constants and workspace of a march along a track."""

    form: Retardation
    control: Any  # determines the indentation (model/balance.py)
    track: Track
    done: int  # number of steps taken before the track
    all_blocks: bool  # whether all blocks are stepped
    lowest: np.ndarray  # minimum over all lines in each cell
    blocks: ElementBlocks
    rows: SpringRows  # thresholds of all blocks, and a list of the chosen ones
    constants: np.ndarray  # of the law of the last step, as fill_law leaves them
    settling: np.ndarray  # workspace of advance_and_predict
    depths: np.ndarray  # workspace of _sums
    load_of_width: np.ndarray  # workspace of median_patch_width


class Progress(NamedTuple):
    """Progress of a march."""

    passes: int  # over the thresholds, in total
    old: float  # indentation before the last step, in h
    d: float  # indentation after the last step, in h
    last: Indenter  # of the last step
    law: tuple[float, float, float]  # of the last step, as fill_law returns it
    choice: Choice


@kernel
def in_blocks(elements, done):
    """Return Elements as BlockElements; done : number of steps taken so far."""
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
    """Return BlockElements as Elements; n : their number without padding."""
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
    """Return the unscaled memory, shape (K, n); p : forces of the last step, shape (n,)."""
    memory = np.empty((blocks.memory.shape[1], p.size))
    for k in range(memory.shape[0]):
        scale, fresh = blocks.scales.scale[k], blocks.scales.fresh[k]
        for i in range(p.size):
            memory[k, i] = _unscaled(
                scale, fresh, blocks.memory[i // BLOCK_ELEMENTS, k, i % BLOCK_ELEMENTS], p[i]
            )
    return memory


@inlined_kernel
def _unscaled(scale, fresh, scaled, p):
    """Return the unscaled memory, including the force p of the last step."""
    y = scale * scaled - fresh * p
    return y if abs(y) > MIN_MAGNITUDE else 0.0


@kernel
def march_blocks(
    form,
    control,
    track,
    state,
    done,
    ends,
    recorded,
    frames,
    trace,
    energies,
    lengths,
    snapshots,
    window,
):
    """March BlockElements along a track; return (state, passes).

    form : a Retardation. state : its arrays are changed. ends : numbers of the steps at which legs
    end, increasing. The other arguments are those of ``march_elements``.
    """
    blocks, c, last, d = state
    n, s, rows = track.z.shape[1] // 2, 0, spring_rows_of(c)
    k, frame = first_after(recorded, done), first_after(frames, done)
    end = first_after(ends, done)
    room = np.empty((5, blocks.memory.shape[1])), np.empty(2 * BLOCK_ELEMENTS)
    more_room = np.empty(c.size + c.shape[0] + 1), np.zeros(n)
    all_blocks, lowest, memory = energies is not None, _cell_minima(track.z), np.empty((0, n))
    march = BlockMarch(
        form, control, track, done, all_blocks, lowest, blocks, rows, *room, *more_room
    )
    now = Progress(0, d, d, last, (1.0, 0.0, 0.0), Choice(-1, np.inf, d, 0))
    while s < track.dt.size:
        until = min(_step_number(recorded, k), _step_number(frames, frame)) - done
        until = min(until, _step_number(ends, end) - done, track.dt.size)
        if energies is not None or (window is not None and window.after < done + until):
            until = s + 1
        if energies is not None:
            p = _forces(c, last)[:n]
            memory = _memory(blocks, p)
        now = _march(march, now, s, until)
        s, step, last, d = until, done + until, now.last, now.d
        if snapshots is not None and frame < frames.size and step == frames[frame]:
            z, p_now = line_at_step(track.z, track, s, n), _forces(c, last)
            _record_snapshot(snapshots, frame, blocks, step, p_now, z, d, last.stiffness)
            frame += 1
        if energies is not None:
            w = line_at_step(track.z, track, s, n) - c.reshape(-1)[:n]
            new, law = _forces(c, last)[:n], law_of(form, track.dt[s - 1])
            add_step_energies(form, law, energies, track, s - 1, memory, p, new, w, now.old, d)
        if window is not None and window.after < step <= window.last:
            sums, _ = _sums(march, now, s)
            add_impulses(window, sums, track.dt[s - 1])
        if k < recorded.size and step == recorded[k]:
            if trace is not None:
                _record_trace(trace, k, march, now, s)
            if energies is not None:
                record_energies(energies, k, form, _memory(blocks, new), new)
            if lengths is not None:
                count_lengths(lengths, _forces(c, last)[:n])
            k += 1
        if end < ends.size and step == ends[end]:
            _unscale(blocks, _forces(c, last), step)
            end += 1
    return BlockElements(blocks, c, last, d), now.passes


@inlined_kernel
def _step_number(numbers, k):
    """Return step number k of an array, or AFTER_ALL_STEPS at the end of the array."""
    return numbers[k] if k < numbers.size else AFTER_ALL_STEPS


@inlined_kernel
def _march(march, now, s, until):
    """March from step s of the track to step ``until``; return the new Progress."""
    dt, constants = march.track.dt, march.constants
    passes, old, d, last, law_numbers, choice = now
    for t in range(s, until):
        if t == 0 or dt[t] != dt[t - 1]:
            law_numbers = fill_law(march.form, dt[t], constants)
        law, old = Prony(constants[0], constants[1], constants[2], *law_numbers), d
        d, used, choice = _step(march, law, t, old, last, choice)
        passes += used
        last = Indenter(d, law.stiffness)
    return Progress(passes, old, d, last, law_numbers, choice)


@inlined_kernel
def _step(march, law, t, old, last, choice):
    """Advance the blocks that can touch by step t; return (d, passes, Choice).

    old : indentation before step t. last : Indenter of the last step. The rows get new thresholds.
    """
    track, rows, lowest = march.track, march.rows, march.lowest
    n, begin = track.z.shape[1] // 2, track.begin[t + 1]
    advance_scales(law, march.blocks.scales, march.done + t + 1)
    chosen_begin, cap, chosen_d, count = choice
    if chosen_begin < 0 or round_apart(begin, chosen_begin, n) > MAX_SHIFT_SAMPLES:
        chosen_begin, cap = begin, np.inf if march.all_blocks else cap_over(old, chosen_d, lowest)
        count, chosen_d = _choose(rows, lowest, chosen_begin, n, cap, last.level), old
    while True:
        d, passes = _balance(march, law, t, old, last, count)
        highest_d = rows.evaluation[0]["highest_d"]
        if highest_d <= cap:
            return d, passes, Choice(chosen_begin, cap, chosen_d, count)
        cap = cap_over(highest_d, old, lowest)  # other elements could have touched there
        count = _choose(rows, lowest, chosen_begin, n, cap, last.level)


@inlined_kernel
def _balance(march, law, t, old, last, count):
    """Fill the thresholds of the first ``count`` chosen blocks; return (d, passes) of the step."""
    (memory, known_steps, scales), settling, track = march.blocks, march.settling, march.track
    c, some, sums, evaluation = march.rows
    rows, begin = SpringRows(c, some[:count], sums, evaluation), track.begin[t + 1]
    step, z = march.done + t + 1, track.z[track.line[t + 1], begin : begin + track.z.shape[1] // 2]
    rescale_blocks(scales, memory, known_steps, rows.some, step)
    forget_evaluation(rows)
    for b in rows.some:
        advance_and_predict(scales.due, scales.scale, memory, b, last, c[b], settling)
        heights = z[b * BLOCK_ELEMENTS : (b + 1) * BLOCK_ELEMENTS]
        for i in range(heights.size):
            c[b, i] = heights[i] - settling[i]
    mark_forces_applied(scales)
    return balance_rows(march.control, law, rows, old, step)


@kernel
def _cell_minima(z):
    """Return the minimum over all lines in each cell of the two periods; z : of a Track."""
    lowest = np.full((z.shape[1] + CELL_SAMPLES - 1) // CELL_SAMPLES, np.inf)
    for line in range(z.shape[0]):
        for j in range(z.shape[1]):
            lowest[j // CELL_SAMPLES] = min(lowest[j // CELL_SAMPLES], z[line, j])
    return lowest


@inlined_kernel
def cap_over(d, before, lowest):
    """Return a cap above the indentation d, and above the deepest part of the line.

    before : an earlier indentation; the margin allows for further changes of the same size.
    """
    deepest = np.inf
    for cell in range(lowest.size):
        deepest = min(deepest, lowest[cell])
    margin = max(CAP_MARGIN * abs(d - deepest), 4.0 * abs(d - before))
    return max(d, deepest) + max(margin, 1e-9)


@inlined_kernel
def round_apart(one, other, n):
    """Return the distance between two samples on a period of n samples."""
    apart = abs(one - other)
    return min(apart, n - apart)


@inlined_kernel
def can_touch(lowest, begin, b, n, cap):
    """Return whether part of the line over block b is below the cap, for any allowed shift."""
    first = (begin + b * BLOCK_ELEMENTS - MAX_SHIFT_SAMPLES) % n
    last = min(first + BLOCK_ELEMENTS + 2 * MAX_SHIFT_SAMPLES, 2 * n) - 1
    below = False
    for cell in range(first // CELL_SAMPLES, last // CELL_SAMPLES + 1):
        below = below or lowest[cell] < cap
    return below


@inlined_kernel
def _choose(rows, lowest, begin, n, cap, level):
    """List the blocks that can touch or did touch in the last step; return their number."""
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
def _unscale(blocks, p, step):
    """Unscale the memory of all blocks and add the forces p of the last step."""
    memory, known_steps, scales = blocks
    rescale_blocks(scales, memory, known_steps, np.arange(known_steps.size), step)
    for b in range(known_steps.size):
        block_p = p[b * BLOCK_ELEMENTS : (b + 1) * BLOCK_ELEMENTS]
        for k in range(scales.scale.size):
            scale, fresh = scales.scale[k], scales.fresh[k]
            for i in range(BLOCK_ELEMENTS):
                memory[b, k, i] = _unscaled(scale, fresh, memory[b, k, i], block_p[i])
    for k in range(scales.scale.size):
        scales.scale[k], scales.fresh[k] = 1.0, 0.0


@inlined_kernel
def _record_trace(trace, k, march, now, s):
    """Record the trace of the last of s steps of the track in row k."""
    lag, track = now.law[1], march.track
    sums, count = _sums(march, now, s)
    record_forces(trace, k, lag, sums, track.z.shape[1] // 2, now.old, now.d)
    width = median_patch_width(march.depths[:count], march.load_of_width)
    trace.samples_per_contact[k] = width
    record_motion(trace, k, lag, track, s - 1)


@inlined_kernel
def _sums(march, now, s):
    """Return (sums of eq. 5, number of stored depths) of the last of s steps (model/friction.py).

    Sums are by columns, as in add_overlap. The workspace ``depths`` gets the depths of all elements
    in rows with contact, and one zero for the rows between them, which separates contact patches.
    """
    track, rows, slope, depths = march.track, march.rows, march.settling, march.depths
    (stiffness, lag, _), n, sums = now.law, track.z.shape[1] // 2, rows.sums
    stored = next_row = 0
    before = track.slope[track.line[s - 1], track.begin[s - 1] :]
    after = track.slope[track.line[s], track.begin[s] :]
    for i in range(SUM_COLUMNS):
        sums[0, i] = sums[1, i] = sums[2, i] = 0.0
    for b in rows.some[: now.choice.block_count]:
        touching, size = 0, min(BLOCK_ELEMENTS, n - b * BLOCK_ELEMENTS)
        if b != next_row:
            depths[stored] = 0.0
            stored += 1
        row_depths = depths[stored : stored + BLOCK_ELEMENTS]
        for i in range(BLOCK_ELEMENTS):
            depth = now.d - rows.c[b, i]
            row_depths[i] = depth if depth > 0.0 else 0.0
            touching += 1 if depth > 0.0 else 0
        if touching == 0:
            continue
        add_overlap(rows, b, now.d)
        slope_before, slope_after = before[b * BLOCK_ELEMENTS :], after[b * BLOCK_ELEMENTS :]
        for i in range(size):
            slope[i] = slope_after[i] + lag * (slope_before[i] - slope_after[i])
        for part in range(0, BLOCK_ELEMENTS, SUM_COLUMNS):
            for i in range(SUM_COLUMNS):
                sums[2, i] += row_depths[part + i] * slope[part + i]
        stored, next_row = stored + size, b + 1
    if next_row * BLOCK_ELEMENTS < n:
        depths[stored] = 0.0
        stored += 1
    fold(sums)
    return (stiffness * sums[0, 0], stiffness * sums[2, 0], sums[1, 0]), stored


@kernel
def _record_snapshot(snapshots, frame, blocks, step, p, z, d, stiffness):
    """Record line and elements after a step; the memory does not include its forces p yet."""
    rescale_blocks(
        blocks.scales, blocks.memory, blocks.known_steps, np.arange(blocks.known_steps.size), step
    )
    u = np.empty(p.size)
    for b in range(blocks.known_steps.size):
        block_u = u[b * BLOCK_ELEMENTS : (b + 1) * BLOCK_ELEMENTS]
        predict_block(blocks.scales.scale, blocks.memory, b, block_u)
    for i in range(z.size):
        u[i] -= p[i] / stiffness
    record_snapshot(snapshots, frame, z, d, u[: z.size])
