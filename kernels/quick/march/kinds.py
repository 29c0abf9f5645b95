"""Contact kinds of all samples, from one pass over the line against the motion.

Undecided samples are listed run by run, those that always touch are summed. The gap g_j(t) =
c_j(t) - d(t) above the element at sample j is negative where it touches. With a_j and D of
problem.py

    g_j(t) = a_j - D(t) + E max(g_(j+1)(t - 1), 0),

so bounds of D give bounds of g_j from those of g_(j+1). The two steady states give further bounds.
Spans that always touch or never touch are passed at once. In the few others, the displacements of
both steady states are recomputed sample by sample.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import inlined_kernel, kernel, refcount_free_kernel
from ..steady.spans import SPAN
from .problem import (
    ALWAYS_TOUCHES,
    FORCED_UNDECIDED,
    NEVER_TOUCHES,
    UNDECIDED,
    Bounds,
    DisplacementBounds,
    JumpProblem,
    SummedContact,
    add_sample,
    add_span,
    decayed_displacement,
    displacement_bounds,
    kind_of_first,
    lagged_slope_at,
    line_rise,
    span_always_touches,
    span_never_touches,
)

MIN_GAP_SAMPLES = 8  # a shorter gap is cheaper to list than to cross
UNKNOWN_GAP = 1e200  # an upper bound of gaps that excludes nothing


class ListedSamples(NamedTuple):
    """Listed samples, run by run. A run is in line order: elements enter it at its end."""

    begin: np.ndarray  # first slot of each run, and the end of the last; shape (runs + 1,)
    z: np.ndarray  # heights
    weight: np.ndarray  # lagged slopes (friction.py)
    c: np.ndarray  # contact thresholds of the last step (model/contact.py)


class CollectedSamples(NamedTuple):
    """Listed samples in the order of a walk against the motion, run by run."""

    z: np.ndarray  # heights
    weight: np.ndarray  # lagged slopes
    c: np.ndarray  # thresholds in steady sliding at v1
    c_end: np.ndarray  # thresholds in steady sliding at v2


class Runs(NamedTuple):
    """Runs of listed samples, in the order of the walk: from the end of the line to z[0]."""

    leading: np.ndarray  # sample of each run that elements reach first; it has the highest number
    trailing: np.ndarray  # sample of each run that elements reach last
    distance: np.ndarray  # from the leading sample upstream to its source, the next that may touch
    source_touches: np.ndarray  # whether the source always touches


class LineWalk(NamedTuple):
    """State of a walk over the line, between two samples."""

    kind: int  # contact kind of the last sample
    source: int  # the last sample that may touch
    source_touches: bool  # whether it always touches
    gap_min: float  # gap_min, gap_max : bounds of max(g, 0) at the last sample
    gap_max: float
    run_count: int  # number of runs so far
    listed_count: int  # number of listed samples so far


class Classification(NamedTuple):
    """Input of ``walk_line``, and where the walk stores its results."""

    problem: JumpProblem
    bounds: Bounds
    levels: DisplacementBounds
    first: int  # assumed kind of z[0]
    level: float  # of SummedContact
    tally: np.ndarray  # of the samples that always touch
    runs: Runs  # to fill
    collected: CollectedSamples  # to fill


class SampleKind(NamedTuple):
    """Contact kind of a sample, and what decides it."""

    kind: int
    rise: float  # a_j; 0 unless computed
    gap_min: float  # gap_min, gap_max : bounds of max(g, 0)
    gap_max: float


@kernel
def undecided_runs(problem, bounds):
    """Return (Runs, CollectedSamples, SummedContact); all other samples never touch."""
    levels = displacement_bounds(problem, bounds)
    first = kind_of_first(problem, bounds, levels)
    # The kind of z[0] depends on that of z[1], and so on round to z[0]: assume it, then check.
    runs, collected, sums, gap_max = walk_line(problem, bounds, levels, first)
    if first == ALWAYS_TOUCHES and gap_max > 0.0:
        runs, collected, sums, _ = walk_line(problem, bounds, levels, FORCED_UNDECIDED)
    return runs, collected, sums


@kernel
def walk_line(problem, bounds, levels, first):
    """Return (Runs, CollectedSamples, SummedContact, upper bound of max(g, 0) at z[0]).

    first : assumed kind of z[0]; a returned bound > 0 refutes ALWAYS_TOUCHES.
    """
    n, level, tally = problem.z.size, problem.end.d / problem.law.stiffness, np.zeros(4)
    runs = allocate_runs(n // 2 + 1)
    collected = CollectedSamples(np.empty(n), np.empty(n), np.empty(n), np.empty(n))
    task = Classification(problem, bounds, levels, first, level, tally, runs, collected)
    count, size, gap_max = _walk_spans(task)
    runs = Runs(
        runs.leading[:count],
        runs.trailing[:count],
        runs.distance[:count],
        runs.source_touches[:count],
    )
    collected = CollectedSamples(
        collected.z[:size], collected.weight[:size], collected.c[:size], collected.c_end[:size]
    )
    return runs, collected, SummedContact(level, tally[0], tally[1], tally[2], tally[3]), gap_max


@refcount_free_kernel
def _walk_spans(task):
    """Sort all samples; return (number of runs, of listed samples, bound of max(g, 0) at z[0]).

    task : Classification.
    """
    problem, bounds, levels, first = task.problem, task.bounds, task.levels, task.first
    n, whole, touches = problem.z.size, problem.spans.lowest.size, first == ALWAYS_TOUCHES
    # The sample upstream of the line's end is z[0]; the source lies farther if z[0] never touches.
    walk = LineWalk(NEVER_TOUCHES, n, touches, 0.0, 0.0 if touches else UNKNOWN_GAP, 0, 0)
    for b in range(problem.start.entered.size - 1, -1, -1):
        if b < whole and (b > 0 or first != FORCED_UNDECIDED):
            _, source, touches, gap_min, gap_max, count, size = walk
            if span_never_touches(problem, bounds, levels, b):
                kind, gap_min, gap_max = NEVER_TOUCHES, 0.0, UNKNOWN_GAP
                walk = LineWalk(kind, source, touches, gap_min, gap_max, count, size)
                continue
            if gap_max == 0.0 and span_always_touches(problem, bounds, b):
                add_span(problem, task.level, b, task.tally)
                kind, source, touches = ALWAYS_TOUCHES, b * SPAN, True
                walk = LineWalk(kind, source, touches, gap_min, gap_max, count, size)
                continue
        walk = _walk_span(task, b, walk)
    if first == NEVER_TOUCHES and walk.run_count > 0:
        task.runs.distance[0] = walk.source + n - task.runs.leading[0]
        task.runs.source_touches[0] = walk.source_touches
    return walk.run_count, walk.listed_count, walk.gap_max


@kernel
def allocate_runs(most):
    """Return Runs with room for ``most`` of them."""
    leading, trailing = np.empty(most, np.int64), np.empty(most, np.int64)
    return Runs(leading, trailing, np.empty(most, np.int64), np.empty(most, np.bool_))


@refcount_free_kernel
def _walk_span(task, b, walk):
    """Return the LineWalk after the samples of span b, visited one by one."""
    z, start, end = task.problem.z, task.problem.start, task.problem.end
    u_start, u_end = start.entered[b], end.entered[b]
    for j in range(min((b + 1) * SPAN, z.size) - 1, b * SPAN - 1, -1):
        w_start = decayed_displacement(start.decay, u_start)
        w_end = decayed_displacement(end.decay, u_end)
        u_start, u_end = min(w_start, z[j] - start.d), min(w_end, z[j] - end.d)
        walk = _sort_sample(task, walk, j, w_start, w_end)
    return walk


@inlined_kernel
def _sort_sample(task, walk, j, w_start, w_end):
    """Sum sample j, list it, or leave it to a gap; return the LineWalk after it.

    w_start, w_end : free displacements at v1 and v2.
    """
    problem, d_max = task.problem, task.bounds.d_max
    z, law = problem.z, problem.law
    kind, rise, gap_min, gap_max = _kind_of_sample(task, walk, j, w_start, w_end)
    _, source, touches, _, _, count, size = walk
    if kind == NEVER_TOUCHES:
        # Store it in advance; it is listed only if an undecided sample ends the gap soon.
        if source - j < MIN_GAP_SAMPLES and source < z.size:
            weight = lagged_slope_at(problem.slope, law.lag, j)
            slot = size + source - 1 - j
            _collect(task.collected, slot, z[j], d_max, weight, w_start, w_end)
        return LineWalk(kind, source, touches, gap_min, gap_max, count, size)
    weight = lagged_slope_at(problem.slope, law.lag, j)
    if kind == ALWAYS_TOUCHES:
        add_sample(task.level - rise, weight, task.tally)
    else:
        count, size = _extend_runs(task.runs, walk, j, z.size)
        _collect(task.collected, size, z[j], d_max, weight, w_start, w_end)
        size += 1
    return LineWalk(kind, j, gap_max == 0.0, gap_min, gap_max, count, size)


@inlined_kernel
def _kind_of_sample(task, walk, j, w_start, w_end):
    """Return the SampleKind of sample j. w_start, w_end : free displacements at v1 and v2."""
    problem, bounds, levels = task.problem, task.bounds, task.levels
    z, law = problem.z, problem.law
    near, far = (w_start, w_end) if levels.near_is_start else (w_end, w_start)
    if not z[j] - near < bounds.d_max + levels.near_slack:
        return SampleKind(NEVER_TOUCHES, 0.0, 0.0, UNKNOWN_GAP)
    rise = line_rise(law, z[j], z[j + 1 if j + 1 < z.size else 0])
    least, most = gap_bounds(law, bounds, levels, z[j], rise, near, far, walk.gap_min, walk.gap_max)
    initial = z[j] - w_start - problem.start.d
    least, most = min(least, initial), max(most, initial)
    gap_min, gap_max = max(least, 0.0), max(most, 0.0)
    forced = j == 0 and task.first == FORCED_UNDECIDED
    kind = contact_kind(forced, walk.gap_max == 0.0 and gap_max == 0.0, least, most)
    return SampleKind(kind, rise, gap_min, gap_max)


@inlined_kernel
def _extend_runs(runs, walk, j, n):
    """Add sample j to the last run or to a new one; return (number of runs, slot of the sample)."""
    source, count = walk.source, walk.run_count
    near = source - j <= MIN_GAP_SAMPLES and source < n
    short_gap = walk.kind == NEVER_TOUCHES and near
    continues = short_gap and count > 0 and runs.trailing[count - 1] == source
    if walk.kind != UNDECIDED and not continues:
        runs.leading[count] = source - 1 if short_gap else j
        runs.distance[count] = source - runs.leading[count]
        runs.source_touches[count] = walk.source_touches
        count += 1
    runs.trailing[count - 1] = j
    return count, walk.listed_count + (source - 1 - j if short_gap else 0)


@refcount_free_kernel
def _collect(collected, slot, z, d_max, weight, w_start, w_end):
    """Store a sample. w_start, w_end : free displacements at v1 and v2."""
    # A sample above d_max cannot touch; its height is limited to d_max to keep the digits of w.
    collected.z[slot] = min(z, d_max)
    collected.c[slot] = collected.z[slot] - w_start
    collected.c_end[slot] = z - w_end
    collected.weight[slot] = weight


@kernel
def gap_bounds(law, bounds, levels, z, rise, near, far, gap_min, gap_max):
    """Return (least, most): bounds of g_j in all steps to come.

    rise : a_j. near, far : displacements of both steady states (problem.py).
    gap_min, gap_max : bounds of max(g, 0) at the sample upstream.
    """
    least = max(
        rise - bounds.advance_max + law.decay * gap_min,
        z - near - levels.near_slack - bounds.d_max,
    )
    most = min(
        rise - bounds.advance_min + law.decay * gap_max,
        z - far + levels.far_slack - bounds.d_min,
    )
    return least, most


@kernel
def contact_kind(forced, touches, least, most):
    """Return the contact kind of a sample with gap bounds least, most.

    touches : whether the gaps of this sample and of the one upstream never exceed zero.
    """
    if forced:
        return UNDECIDED
    if touches and most < 0.0:
        return ALWAYS_TOUCHES
    return NEVER_TOUCHES if least >= 0.0 else UNDECIDED


@kernel
def listed_samples(runs, collected):
    """Return the ListedSamples of all Runs at the start of a march."""
    begin = np.zeros(runs.leading.size + 1, np.int64)
    for r in range(runs.leading.size):
        begin[r + 1] = begin[r] + runs.leading[r] - runs.trailing[r] + 1
    z, weight, c = np.empty(begin[-1]), np.empty(begin[-1]), np.empty(begin[-1])
    for r in range(runs.leading.size):
        k = begin[r + 1] - 1
        for i in range(begin[r], begin[r + 1]):
            z[k], weight[k], c[k] = collected.z[i], collected.weight[i], collected.c[i]
            k -= 1
    return ListedSamples(begin, z, weight, c)
