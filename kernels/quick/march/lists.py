"""Shorter lists in a long march: the samples that remain undecided within narrower bounds.

Samples that have become decided move from the lists to the sums, or to the gaps. Only the runs are
visited. Samples where elements certainly land after a gap are summed too (crossings.py). Gaps g are
bounded as in kinds.py, but from present displacements in place of steady states.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import inlined_kernel, kernel, refcount_free_kernel
from ...rheology.kelvin import Kelvin
from ...rheology.law import State
from .crossings import (
    Entries,
    Gap,
    Landings,
    add_landing,
    decay_powers,
    fill_arrivals,
    run_entries,
    update_distances,
)
from .kinds import (
    MIN_GAP_SAMPLES,
    UNKNOWN_GAP,
    ListedSamples,
    Runs,
    allocate_runs,
    contact_kind,
)
from .problem import (
    ALWAYS_TOUCHES,
    NEVER_TOUCHES,
    UNDECIDED,
    Bounds,
    SummedContact,
    add_sample,
    line_rise,
)

CERTAIN_LANDING = 5  # a contact kind: elements always land here, after a gap


class ActiveSet(NamedTuple):
    """Lists of the samples that a march steps, and sums over the others that touch."""

    runs: Runs
    listed: ListedSamples
    sums: SummedContact
    entries: Entries
    landings: Landings


class SampleBounds(NamedTuple):
    """Bounds at a sample, now and in all steps to come."""

    gap_min: float  # gap_min, gap_max : of max(g, 0)
    gap_max: float
    u_min: float  # u_min, u_max : of the displacement u
    u_max: float


class ArrivalBounds(NamedTuple):
    """Bounds of the displacement with which elements arrive at a sample."""

    u_min: float
    u_max: float


class Source(NamedTuple):
    """The nearest sample upstream that may touch, from which elements come."""

    sample: int
    touches: bool  # whether it always touches


class RunSlots(NamedTuple):
    """Shorter runs, with their slots in the longer lists."""

    runs: Runs
    first: np.ndarray  # lowest slot of each run
    last: np.ndarray  # highest slot


class ListWalk(NamedTuple):
    """State of a walk over the listed samples, between two of them."""

    kind: int  # contact kind of the last sample
    source: Source
    sample: SampleBounds  # at the last sample
    arriving: ArrivalBounds  # of elements that arrive at the next sample
    run_count: int  # number of shorter runs so far


class Shortening(NamedTuple):
    """Input of a walk over the lists, and arrays for its results."""

    law: Kelvin
    line: np.ndarray  # heights of all samples
    bounds: Bounds  # narrower bounds of d and D
    active: ActiveSet
    past: np.ndarray  # d from the start to the end of the present step
    w: np.ndarray  # displacements, see present_displacements
    steps: int  # number of steps to come
    slots: RunSlots  # to fill
    added: np.ndarray  # tally of the samples that now always touch


@kernel
def shorten_lists(law, line, bounds, active, past, w, steps):
    """Return the ActiveSet for narrower bounds, at the end of a step.

    line : heights of all samples. past : d from the start to the end of this step.
    w : displacements, see present_displacements. steps : number of steps to come.
    """
    size, added = active.listed.c.size, np.zeros(4)
    slots = RunSlots(allocate_runs(size), np.empty(size, np.int64), np.empty(size, np.int64))
    task = Shortening(law, line, bounds, active, past, w, steps, slots, added)
    count = _walk_lists(task)
    runs = Runs(
        slots.runs.leading[:count],
        slots.runs.trailing[:count],
        slots.runs.distance[:count],
        slots.runs.source_touches[:count],
    )
    sums = SummedContact(
        active.sums.level,
        active.sums.samples + added[0],
        active.sums.depth + added[1],
        active.sums.weight + added[2],
        active.sums.moment + added[3],
    )
    listed = _selected_slots(active.listed, slots.first[:count], slots.last[:count])
    landings = update_distances(active.landings)
    entries = run_entries(law, listed, runs, State(w, past[-1]), line, steps)
    return ActiveSet(runs, listed, sums, entries, landings)


@refcount_free_kernel
def _walk_lists(task):
    """Sort the listed samples into contact kinds; return the number of shorter runs.

    task : Shortening. Certain landings are added to those of ``task.active``.
    """
    runs, listed = task.active.runs, task.active.listed
    count, crossing = 0, 0
    # If the source of the first run is a listed sample, the walk reaches it only at the end.
    source = Source(task.line.size, False)
    sample = SampleBounds(0.0, UNKNOWN_GAP, -task.bounds.d_max, 0.0)
    for r in range(runs.leading.size):
        j, direct = runs.leading[r], runs.source_touches[r] and runs.distance[r] == 1
        if runs.source_touches[r]:
            source = Source(j + runs.distance[r], True)
        arriving, sample = _entering_bounds(task, r, crossing, sample)
        crossing += not direct
        walk = ListWalk(NEVER_TOUCHES, source, sample, arriving, count)
        for i in range(listed.begin[r + 1] - 1, listed.begin[r] - 1, -1):
            walk = _sort_sample(task, walk, i, j, runs.leading[r])
            j -= 1
        source, sample, count = walk.source, walk.sample, walk.run_count
    new = task.slots.runs
    from_line_end = count > 0 and new.leading[0] + new.distance[0] == task.line.size
    if from_line_end and not new.source_touches[0]:
        new.distance[0] = source.sample + task.line.size - new.leading[0]
        new.source_touches[0] = source.touches
    return count


@inlined_kernel
def _sort_sample(task, walk, i, j, leading):
    """Sum sample j in slot i, list it, or leave it to a gap; return the ListWalk after it.

    leading : leading sample of its longer run.
    """
    law, line, listed, source = task.law, task.line, task.active.listed, walk.source
    rise = line_rise(law, line[j], _height_at(line, j + 1))
    c = listed.c[i] + (line[j] - listed.z[i])
    least, most, sample = _sample_bounds(task, line[j], c, rise, walk.sample, walk.arriving)
    touches = sample.gap_max == 0.0
    kind = contact_kind(False, walk.sample.gap_max == 0.0 and touches, least, most)
    behind_gap = walk.kind == NEVER_TOUCHES and source.touches
    if kind == UNDECIDED and behind_gap and touches and _lands_certainly(task, source, i, j):
        kind = CERTAIN_LANDING
    count = walk.run_count
    if kind == ALWAYS_TOUCHES:
        add_sample(task.active.sums.level - rise, listed.weight[i], task.added)
    elif kind == UNDECIDED:
        count = _list_sample(task.slots, walk, i, j, source.sample <= leading)
    if kind != NEVER_TOUCHES:
        source = Source(j, touches)
    arriving = ArrivalBounds(law.decay * sample.u_min, law.decay * sample.u_max)
    return ListWalk(kind, source, sample, arriving, count)


@inlined_kernel
def _lands_certainly(task, source, i, j):
    """Add sample j, in slot i, to the certain landings if possible; return whether it was added."""
    gap = Gap(_height_at(task.line, source.sample), source.sample, source.sample - j)
    landings, weight = task.active.landings, task.active.listed.weight[i]
    z, past = task.line[j], task.past
    return add_landing(task.law, landings, gap, z, weight, past, task.w, task.steps)


@inlined_kernel
def _list_sample(slots, walk, i, j, near):
    """Add sample j in slot i to the last shorter run or to a new one; return the number of runs.

    near : whether the source lies in the same longer run, so that the samples between are listed
    already.
    """
    runs, source, count = slots.runs, walk.source, walk.run_count
    short_gap = walk.kind == NEVER_TOUCHES and source.sample - j <= MIN_GAP_SAMPLES and near
    continues = short_gap and count > 0 and runs.trailing[count - 1] == source.sample
    if walk.kind != UNDECIDED and not continues:
        ahead = source.sample - 1 - j if short_gap and source.touches else 0
        runs.leading[count], slots.last[count] = j + ahead, i + ahead
        runs.distance[count] = source.sample - runs.leading[count]
        runs.source_touches[count] = source.touches
        count += 1
    runs.trailing[count - 1], slots.first[count - 1] = j, i
    return count


@refcount_free_kernel
def _entering_bounds(task, r, crossing, upstream):
    """Return (ArrivalBounds of run r, SampleBounds upstream of the run).

    crossing : index of the next crossing. upstream : SampleBounds at the end of the previous run.
    """
    runs, bounds, decay = task.active.runs, task.bounds, task.law.decay
    if runs.source_touches[r]:
        height = _height_at(task.line, runs.leading[r] + runs.distance[r])
        upstream = SampleBounds(0.0, 0.0, height - bounds.d_max, height - bounds.d_min)
        if runs.distance[r] == 1:
            return ArrivalBounds(decay * upstream.u_min, decay * upstream.u_max), upstream
    crossings, u_min, u_max = task.active.entries.crossings, upstream.u_min, upstream.u_max
    arriving = arrival_bounds(crossings, crossing, u_min, u_max, task.steps)
    return arriving, SampleBounds(0.0, UNKNOWN_GAP, u_min, u_max)


@refcount_free_kernel
def _height_at(line, j):
    """Return the height of sample j, which may lie one period ahead."""
    return line[j - line.size if j >= line.size else j]


@kernel
def _sample_bounds(task, z, c, rise, upstream, arriving):
    """Return (least, most, sample): bounds of g at a sample, and its SampleBounds.

    c : present threshold. rise : a_j. upstream : SampleBounds of the sample upstream.
    arriving : ArrivalBounds of this sample.
    """
    bounds, decay, d = task.bounds, task.law.decay, task.past[-1]
    least = max(
        rise - bounds.advance_max + decay * upstream.gap_min, z - arriving.u_max - bounds.d_max
    )
    most = min(
        rise - bounds.advance_min + decay * upstream.gap_max, z - arriving.u_min - bounds.d_min
    )
    least, most = min(least, c - d), max(most, c - d)
    u = z - max(c, d)
    u_min, u_max = min(arriving.u_min, z - bounds.d_max), min(arriving.u_max, z - bounds.d_min)
    sample = SampleBounds(max(least, 0.0), max(most, 0.0), min(u, u_min), max(u, u_max))
    return least, most, sample


@kernel
def _selected_slots(listed, first, last):
    """Return the ListedSamples of the slots first[r] ... last[r]."""
    begin = np.zeros(first.size + 1, np.int64)
    for r in range(first.size):
        begin[r + 1] = begin[r] + last[r] - first[r] + 1
    size = begin[-1]
    z, weight, c = np.empty(size), np.empty(size), np.empty(size)
    for r in range(first.size):
        for i in range(first[r], last[r] + 1):
            k = begin[r] + i - first[r]
            z[k], weight[k], c[k] = listed.z[i], listed.weight[i], listed.c[i]
    return ListedSamples(begin, z, weight, c)


@kernel
def present_displacements(law, active, d, w, steps):
    """Fill w, shape (n,), with the displacements of elements in runs and on their way to them.

    d : present indentation. steps : number of steps to come; later arrivals are left out.
    """
    runs, listed, _, (_, crossings), _ = active
    powers = decay_powers(law.decay, steps)
    f = 0
    for r in range(runs.leading.size):
        if not (runs.source_touches[r] and runs.distance[r] == 1):
            begin, end, place = crossings.begin[f], crossings.begin[f + 1], crossings.next[f]
            for k in range(1, min(runs.distance[r], powers.size - 1) + 1):
                j = runs.leading[r] + k
                arrival = crossings.arrivals[place]
                w[j - w.size if j >= w.size else j] = arrival / powers[k] if arrival else 0.0
                place += 1
                if place == end:
                    place = begin if crossings.is_ring[f] else end - 1
            f += 1
    for r in range(runs.leading.size):
        for i in range(listed.begin[r], listed.begin[r + 1]):
            w[runs.trailing[r] + i - listed.begin[r]] = listed.z[i] - max(listed.c[i], d)


@refcount_free_kernel
def arrival_bounds(crossings, f, u_min, u_max, steps):
    """Return the ArrivalBounds of a crossing in the steps to come.

    f : index of the crossing. u_min, u_max : bounds of the displacement where elements leave.
    """
    begin, end = crossings.begin[f], crossings.begin[f + 1]
    if crossings.is_ring[f]:
        low, high = crossings.decay[f] * u_min, crossings.decay[f] * u_max
    else:
        begin, end = crossings.next[f], end - 1
        negligible = end - begin < steps
        low, high = (0.0, 0.0) if negligible else (np.inf, -np.inf)
    for slot in range(begin, end):
        low, high = min(low, crossings.arrivals[slot]), max(high, crossings.arrivals[slot])
    return ArrivalBounds(low, high)


@fill_arrivals.register(State)
def _fill_present_arrivals(flight, arrivals, powers, line, leading, distance, u):
    w, d = flight
    count = min(arrivals.size, powers.size - 1)
    wrap = min(line.size - leading - 1, count)
    for k in range(wrap):
        j = leading + 1 + k
        arrivals[k] = powers[k + 1] * min(w[j], line[j] - d)
    for k in range(wrap, count):
        j = k - wrap
        arrivals[k] = powers[k + 1] * min(w[j], line[j] - d)
