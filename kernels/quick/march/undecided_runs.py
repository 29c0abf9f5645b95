"""Undecided runs, and sums over samples that always touch, from one pass over the line.

The gap g_j(t) = c_j(t) - d(t) above the element at sample j is negative where it touches. With
a_j and D of jump_problem.py

    g_j(t) = a_j - D(t) + E max(g_(j+1)(t - 1), 0),

so bounds of D give bounds of g_j from those of g_(j+1). The steady states give further bounds
(displacement_bounds.py). Spans that always touch or never touch are passed at once. In the few
others, the displacements of both steady states are recomputed sample by sample.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ..steady.spans import SPAN
from .displacement_bounds import (
    ALWAYS_TOUCHES,
    FORCED_UNDECIDED,
    NEVER_TOUCHES,
    UNDECIDED,
    decayed_displacement,
    displacement_bounds,
    kind_of_first,
    span_always_touches,
    span_never_touches,
)
from .jump_problem import line_rise
from .listed_samples import (
    CollectedSamples,
    SummedContact,
    add_sample,
    add_span,
    lagged_slope_at,
)

MIN_GAP_SAMPLES = 8  # a shorter gap is cheaper to list than to cross
UNKNOWN_GAP = 1e200  # an upper bound of gaps that excludes nothing


class Runs(NamedTuple):
    """Runs of listed samples, in the order of the walk: from the end of the line to z[0]."""

    leading: np.ndarray  # sample of each run that elements reach first; it has the highest number
    trailing: np.ndarray  # sample of each run that elements reach last
    distance: np.ndarray  # from the leading sample to its source, the next that may touch
    source_touches: np.ndarray  # whether the source always touches


@kernel
def undecided_runs(problem, bounds):
    """Return (Runs, CollectedSamples, SummedContact); all other samples never touch."""
    levels = displacement_bounds(problem, bounds)
    first = kind_of_first(problem, bounds, levels)
    # ALWAYS_TOUCHES requires the same upstream, round the period: assume it at z[0], then check.
    runs, collected, sums, gap_max = walk_line(problem, bounds, levels, first)
    if first == ALWAYS_TOUCHES and gap_max > 0.0:
        runs, collected, sums, _ = walk_line(problem, bounds, levels, FORCED_UNDECIDED)
    return runs, collected, sums


@kernel
def walk_line(problem, bounds, levels, first):
    """Return (Runs, CollectedSamples, SummedContact, upper bound of max(g, 0) at z[0]).

    first : assumed kind of z[0]; a bound > 0 refutes ALWAYS_TOUCHES. State of the walk
    between two samples : contact kind of the last sample; last sample that may touch, and whether
    it always touches; bounds of max(g, 0); number of runs; number of listed samples.
    """
    n, whole = problem.z.size, problem.spans.lowest.size
    level, tally = problem.end.d / problem.law.stiffness, np.zeros(4)
    runs = allocate_runs(n // 2 + 1)
    collected = CollectedSamples(np.empty(n), np.empty(n), np.empty(n), np.empty(n))
    # Elements reach the end of the line from z[0], or from beyond it if it never touches.
    kind, source, source_touches, gap_min = NEVER_TOUCHES, n, first == ALWAYS_TOUCHES, 0.0
    gap_max, count, size = 0.0 if source_touches else UNKNOWN_GAP, 0, 0
    for b in range(problem.start.entered.size - 1, -1, -1):
        if b < whole and (b > 0 or first != FORCED_UNDECIDED):
            if span_never_touches(problem, bounds, levels, b):
                kind, gap_min, gap_max = NEVER_TOUCHES, 0.0, UNKNOWN_GAP
                continue
            if gap_max == 0.0 and span_always_touches(problem, bounds, b):
                add_span(problem, level, b, tally)
                kind, source, source_touches = ALWAYS_TOUCHES, b * SPAN, True
                continue
        state = kind, source, source_touches, gap_min, gap_max, count, size
        state = _walk_span(problem, bounds, levels, first, b, state, runs, collected, level, tally)
        kind, source, source_touches, gap_min, gap_max, count, size = state
    if first == NEVER_TOUCHES and count > 0:
        runs.distance[0] = source + n - runs.leading[0]
        runs.source_touches[0] = source_touches
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


@kernel
def allocate_runs(most):
    """Return Runs with room for ``most`` of them."""
    leading, trailing = np.empty(most, np.int64), np.empty(most, np.int64)
    return Runs(leading, trailing, np.empty(most, np.int64), np.empty(most, np.bool_))


@refcount_free_kernel
def _walk_span(problem, bounds, levels, first, b, state, runs, collected, level, tally):
    """Return the state of the walk after the samples of a span, visited one by one."""
    z, slope, law, start, end = problem.z, problem.slope, problem.law, problem.start, problem.end
    kind, source, source_touches, gap_min, gap_max, count, size = state
    u_start, u_end = start.entered[b], end.entered[b]
    for j in range(min((b + 1) * SPAN, z.size) - 1, b * SPAN - 1, -1):
        w_start = decayed_displacement(start.decay, u_start)
        w_end = decayed_displacement(end.decay, u_end)
        u_start, u_end = min(w_start, z[j] - start.d), min(w_end, z[j] - end.d)
        near, far = (w_start, w_end) if levels.near_is_start else (w_end, w_start)
        previous, upstream_touches = kind, gap_max == 0.0
        kind, rise = NEVER_TOUCHES, 0.0
        if z[j] - near < bounds.d_max + levels.near_slack:
            rise = line_rise(law, z[j], z[j + 1 if j + 1 < z.size else 0])
            least, most = gap_bounds(law, bounds, levels, z[j], rise, near, far, gap_min, gap_max)
            initial = z[j] - w_start - start.d
            least, most = min(least, initial), max(most, initial)
            gap_min, gap_max = max(least, 0.0), max(most, 0.0)
            forced = j == 0 and first == FORCED_UNDECIDED
            kind = contact_kind(forced, upstream_touches and gap_max == 0.0, least, most)
        else:
            gap_min, gap_max = 0.0, UNKNOWN_GAP
        if kind == NEVER_TOUCHES:
            # Store it in advance; it is listed only if an undecided sample ends the gap soon.
            if source - j < MIN_GAP_SAMPLES and source < z.size:
                weight, slot = lagged_slope_at(slope, law.lag, j), size + source - 1 - j
                _collect(collected, slot, z[j], bounds.d_max, weight, w_start, w_end)
            continue
        weight = lagged_slope_at(slope, law.lag, j)
        if kind == ALWAYS_TOUCHES:
            add_sample(level - rise, weight, tally)
        else:
            near = source - j <= MIN_GAP_SAMPLES and source < z.size
            short_gap = previous == NEVER_TOUCHES and near
            continues = short_gap and count > 0 and runs.trailing[count - 1] == source
            if previous != UNDECIDED and not continues:
                runs.leading[count] = source - 1 if short_gap else j
                runs.distance[count] = source - runs.leading[count]
                runs.source_touches[count] = source_touches
                count += 1
            runs.trailing[count - 1] = j
            size += source - 1 - j if short_gap else 0
            _collect(collected, size, z[j], bounds.d_max, weight, w_start, w_end)
            size += 1
        source, source_touches = j, gap_max == 0.0
    return kind, source, source_touches, gap_min, gap_max, count, size


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

    rise : a_j. near, far : displacements of both steady states (displacement_bounds.py).
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
