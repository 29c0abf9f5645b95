"""Runs of samples of which it is open whether they touch, and sums of those that do: one walk.

The gap g_j(t) = c_j(t) - d(t) above the element at sample j is negative where it touches. With
a_j and D of given.py

    g_j(t) = a_j - D(t) + E max(g_(j+1)(t - 1), 0),

so the bounds of D bound g from sample to sample against the motion; others are in span_kinds.py.
Spans that always touch or never do are passed at once; in the others, which are few, the
displacements of both steady states are found again.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ..steady.spans import SPAN
from .given import a_of
from .lists import Met, Sums, add_sample, add_span, lagged
from .span_kinds import ALWAYS, FORCED, FREE, always, kind_of_first, levels_of, never, reached

LISTED = 2  # at times it touches, at times it does not, for all that the bounds tell
SHORT = 8  # samples: what is never touched but this near is cheaper to list than to fly over
UNKNOWN = 1e200  # a bound of gaps that says nothing


class Runs(NamedTuple):
    """Runs of listed samples, in the order of the walk: from the end of the line to z[0]."""

    top: np.ndarray  # the first sample of each, with the highest number
    bottom: np.ndarray  # the last one
    distance: np.ndarray  # from the top to the sample upstream from which elements come
    sure: np.ndarray  # whether that sample always touches


@kernel
def classes_of(march, bounds):
    """Return (Runs, Met, Sums) of a line; every other sample never touches within the bounds."""
    levels = levels_of(march, bounds)
    first = kind_of_first(march, bounds, levels)
    # All round the line samples may hold each other in contact: supposed first, then seen.
    runs, met, sums, high = walk(march, bounds, levels, first)
    if first == ALWAYS and high > 0.0:
        runs, met, sums, _ = walk(march, bounds, levels, FORCED)
    return runs, met, sums


@kernel
def walk(march, bounds, levels, first):
    """Return (Runs, Met, Sums, high), ``high`` the upper bound of max(g, 0) at z[0].

    first : the kind of z[0]. Where it is ALWAYS it is taken to be in contact, which ``high`` then
    tells.
    """
    n, whole = march.z.size, march.spans.lowest.size
    level, tally = march.end.d / march.law.stiffness, np.zeros(4)
    runs, met = _room(n)
    # Elements come to the end of the line from z[0], or from beyond it if it never touches.
    kind, source, from_sure = FREE, n, first == ALWAYS
    low, high = 0.0, (0.0 if from_sure else UNKNOWN)  # bounds of max(g, 0) one sample before
    count = size = 0  # of runs, and of listed samples
    for b in range(march.start.entered.size - 1, -1, -1):
        if b < whole and (b > 0 or first != FORCED):
            if never(march, bounds, levels, b):
                kind, low, high = FREE, 0.0, UNKNOWN
                continue
            if high == 0.0 and always(march, bounds, b):
                add_span(march, level, b, tally)
                kind, source, from_sure = ALWAYS, b * SPAN, True
                continue
        at = kind, source, from_sure, low, high, count, size
        at = _visit(march, bounds, levels, first, b, at, runs, met, level, tally)
        kind, source, from_sure, low, high, count, size = at
    if first == FREE and count > 0:
        runs.distance[0], runs.sure[0] = source + n - runs.top[0], from_sure
    runs = Runs(runs.top[:count], runs.bottom[:count], runs.distance[:count], runs.sure[:count])
    met = Met(met.z[:size], met.weight[:size], met.c[:size], met.after[:size])
    return runs, met, Sums(level, tally[0], tally[1], tally[2], tally[3]), high


@kernel
def _room(n):
    """Return Runs and Met with room for all that a line can have."""
    most = n // 2 + 1
    whole = np.empty(most, np.int64), np.empty(most, np.int64), np.empty(most, np.int64)
    runs = Runs(whole[0], whole[1], whole[2], np.empty(most, np.bool_))
    return runs, Met(np.empty(n), np.empty(n), np.empty(n), np.empty(n))


@refcount_free_kernel
def _visit(march, bounds, levels, first, b, at, runs, met, level, tally):
    """Walk through the samples of a span one by one; ``at`` is what walk knows, and comes back."""
    z, slope, law, (start, end) = (
        march.z,
        march.slope,
        march.law,
        (march.start, march.end),
    )
    kind, source, from_sure, low, high, count, size = at
    u, v = start.entered[b], end.entered[b]
    for j in range(min((b + 1) * SPAN, z.size) - 1, b * SPAN - 1, -1):
        w, after, was, held = reached(start.decay, u), reached(end.decay, v), kind, high == 0.0
        u, v = min(w, z[j] - start.d), min(after, z[j] - end.d)
        near, far = (w, after) if levels.early else (after, w)
        kind, steep = FREE, 0.0
        if z[j] - near < bounds.high + levels.near_slack:
            steep = a_of(law, z[j], z[j + 1 if j + 1 < z.size else 0])
            least, most = gap(law, bounds, levels, z[j], steep, near, far, low, high)
            now = z[j] - w - start.d
            least, most = min(least, now), max(most, now)
            low, high = max(least, 0.0), max(most, 0.0)
            kind = class_of(j == 0 and first == FORCED, held and high == 0.0, least, most)
        else:
            low, high = 0.0, UNKNOWN
        if kind == FREE:
            if source - j < SHORT and source < z.size:  # listed, should a run begin behind it
                weight = lagged(slope, law.lag, j)
                _meet(met, size + source - 1 - j, z[j], bounds.high, weight, w, after)
            continue
        if kind == ALWAYS:
            add_sample(level - steep, lagged(slope, law.lag, j), tally)
        else:
            near_by = was == FREE and source - j <= SHORT and source < z.size
            if was != LISTED and not (near_by and count > 0 and runs.bottom[count - 1] == source):
                runs.top[count] = source - 1 if near_by else j
                runs.distance[count], runs.sure[count] = source - runs.top[count], from_sure
                count += 1
            runs.bottom[count - 1] = j
            size += source - 1 - j if near_by else 0
            _meet(met, size, z[j], bounds.high, lagged(slope, law.lag, j), w, after)
            size += 1
        source, from_sure = j, high == 0.0
    return kind, source, from_sure, low, high, count, size


@refcount_free_kernel
def _meet(met, i, z, highest, weight, w, after):
    """Note a sample in place i. w, after : displacements without force at v1 and v2."""
    # What lies higher cannot touch at any height: low, it costs w no digits.
    met.z[i] = min(z, highest)
    met.c[i] = met.z[i] - w
    met.after[i] = z - after
    met.weight[i] = weight


@kernel
def gap(law, bounds, levels, z, steep, near, far, low, high):
    """Return (least, most): bounds of g_j in all steps to come.

    steep : a_j. near, far : displacements of both steady states (span_kinds.py).
    low, high : bounds of max(g, 0) at the sample upstream.
    """
    least = max(steep - bounds.most + law.decay * low, z - near - levels.near_slack - bounds.high)
    most = min(steep - bounds.least + law.decay * high, z - far + levels.far_slack - bounds.low)
    return least, most


@kernel
def class_of(forced, held, least, most):
    """Return what becomes of a sample; ``held`` : whether it and the one upstream always touch."""
    if forced:
        return LISTED
    if held and most < 0.0:
        return ALWAYS
    return FREE if least >= 0.0 else LISTED
