"""Shorter lists in a long march: what is still open within narrower bounds, of what was listed.

It is worth several times the steps of long marches in which d moves far (docs/speed.md).
What always touches goes on to, and so does what never does: nothing but the runs is looked at.
Where elements always land that have left contact, they are summed (landings.py).
The recursion of gaps g is that of runs.py; as the elements on their way are known, displacements
u are bounded beside it.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...rheology.law import State
from .bounds import Bounds, are_within, bounds_of
from .crossings import arrivals_of, launch, powers_of
from .given import a_of
from .landings import copied, land, landed, no_landings, put_back
from .lists import Lists, Sums, add_sample
from .runs import LISTED, SHORT, UNKNOWN, Runs, class_of
from .span_kinds import ALWAYS, FREE
from .stepping import march_on

# Margin of bounds that follow d towards its end, of its spread: at first, then twice as much each
# time that it was too little.
CLOSER = 0.6
LEAST_SAVED = 0.25  # of the spread of D
FIRST_DUE = 6  # step after which lists may be shortened; then after half as many again
SUMMED = 5  # a class: it always touches, and elements always land there


class Reach(NamedTuple):
    """Bounds at a sample, now and in all steps to come."""

    low: float  # of max(g, 0)
    high: float
    least: float  # of the displacement u
    most: float


@kernel
def march_shortening(march, control, where, bounds, stand, last, into, worth):
    """March on as march_on does. Shorter lists are made where what they save exceeds what it costs.

    Where d leaves their bounds, the march goes back to the last step at which it left longer lists
    whose bounds hold, and goes on with those; the next shorter ones leave more room.
    where : runs, lists, sums and arrivals. worth : by which what they save is multiplied.
    """
    law, margin = march.law, CLOSER
    runs, lists, sums, arrivals = where
    known = runs, lists, sums, arrivals, no_landings(march.end.d, stand.d, last)
    longer = [(known, bounds, stand)]
    longer.pop()  # nothing yet, of a type that is known
    work, due, w = 0, FIRST_DUE, np.empty(march.z.size)
    while True:
        runs, lists, sums, arrivals, landings = known
        inside, now, seen, used = march_on(
            march, control, known, bounds, stand, min(due, last), into
        )
        work += used
        if not inside:
            while len(longer) > 0 and not are_within(longer[-1][1], now.d, now.advanced):
                longer.pop()
            if len(longer) == 0:
                return False, now, seen, work
            (runs, lists, sums, arrivals, before), bounds, stand = longer.pop()
            known = runs, lists, sums, arrivals, put_back(landings, before)
            due, margin = now.step, 2.0 * margin
            continue
        stand, left, d = now, last - now.step, now.d
        if left == 0:
            return True, stand, seen, work
        closer = closer_bounds(law, bounds, seen, march.end.d, margin)
        if worth * gain(bounds, closer, lists, arrivals[1], left) > 1.0:
            longer.append(((runs, lists, sums, arrivals, copied(landings)), bounds, stand))
            elements_aloft(law, lists, runs, arrivals[1], d, w, left)
            past = landings.past[: stand.step + 1]
            runs, lists, sums, landings = narrowed(law, march.z, closer, known, past, w, left)
            arrivals = arrivals_of(law, lists, runs, State(w, d), march.z, left)
            known = runs, lists, sums, arrivals, landings
            bounds = closer
            work += lists.c.size + arrivals[1].values.size
        due += due // 2


@refcount_free_kernel
def gain(bounds, closer, lists, crossings, steps):
    """Return what shorter lists save over what it costs to make them, by numbers alone."""
    saved = 1.0 - (closer.most - closer.least) / (bounds.most - bounds.least)
    each = 2.0 * lists.c.size + 16.0 * crossings.at.size
    cost = 30.0 * crossings.values.size + 100.0 * lists.c.size
    return steps * each * saved / cost if saved > LEAST_SAVED and cost > 0.0 else 0.0


@kernel
def closer_bounds(law, bounds, seen, end, margin):
    """Return Bounds, none beyond ``bounds``, for d between what was seen of it and ``end``.

    margin : by which they are farther out, relative to the spread of d and of D.
    """
    lowest, highest = min(seen.low, end), max(seen.high, end)
    new = bounds_of(law, lowest, highest, seen.least, seen.most, margin)
    low, high = max(new.low, bounds.low), min(new.high, bounds.high)
    return Bounds(low, high, max(new.least, bounds.least), min(new.most, bounds.most))


@kernel
def narrowed(law, line, bounds, where, past, aloft, steps):
    """Return (runs, lists, sums, landings) within narrower bounds, at the end of a step.

    line : heights of all samples. where : runs, lists, sums, arrivals and landings up to now. past
    : d from the start to the end of this step. aloft : displacements, as elements_aloft leaves
    them. steps : still to come.
    """
    runs, lists, sums, (_, crossings), landings = where
    n, size, d = line.size, lists.c.size, past[-1]
    top, bottom, distance, first, last = (
        np.empty(size, np.int64),
        np.empty(size, np.int64),
        np.empty(size, np.int64),
        np.empty(size, np.int64),
        np.empty(size, np.int64),
    )
    sure, parts = np.empty(size, np.bool_), np.zeros(4)
    count = crossing = 0
    # Where elements come from to the first run is known at the end, if it was listed.
    source, from_sure, wraps = n, False, False
    reach = Reach(0.0, UNKNOWN, -bounds.high, 0.0)
    for r in range(runs.top.size):
        j, kind = runs.top[r], FREE
        if runs.sure[r]:
            source, from_sure = j + runs.distance[r], True
        w, reach = _entering(law, line, bounds, runs, r, (crossings, crossing, steps), reach)
        crossing += not (runs.sure[r] and runs.distance[r] == 1)
        for i in range(lists.first[r + 1] - 1, lists.first[r] - 1, -1):
            was, held = kind, reach.high == 0.0
            steep = a_of(law, line[j], _at(line, j + 1))
            c = lists.c[i] + (line[j] - lists.z[i])
            least, most, reach = _reach(law, bounds, line[j], c, d, steep, reach, w)
            kind = class_of(False, held and reach.high == 0.0, least, most)
            gap, behind = (_at(line, source), source, source - j), (line[j], lists.weight[i])
            always = kind == LISTED and was == FREE and from_sure and reach.high == 0.0
            if always and land(law, landings, gap, behind, past, aloft, steps):
                kind = SUMMED
            if kind == ALWAYS:
                add_sample(sums.level - steep, lists.weight[i], parts)
            elif kind == LISTED:
                near = was == FREE and source - j <= SHORT and source <= runs.top[r]
                if was != LISTED and not (near and count > 0 and bottom[count - 1] == source):
                    wraps = wraps or (count == 0 and source == n and not from_sure)
                    ahead = source - 1 - j if near and from_sure else 0
                    top[count], last[count] = j + ahead, i + ahead
                    distance[count], sure[count] = source - top[count], from_sure
                    count += 1
                bottom[count - 1], first[count - 1] = j, i
            if kind != FREE:
                source, from_sure = j, reach.high == 0.0
            w = law.decay * reach.least, law.decay * reach.most
            j -= 1
    if wraps:
        distance[0], sure[0] = source + n - top[0], from_sure
    runs = Runs(top[:count], bottom[:count], distance[:count], sure[:count])
    more = Sums(
        sums.level,
        sums.samples + parts[0],
        sums.depth + parts[1],
        sums.weight + parts[2],
        sums.moment + parts[3],
    )
    return runs, _part(lists, first[:count], last[:count]), more, landed(landings)


@refcount_free_kernel
def _entering(law, line, bounds, runs, r, over, above):
    """Return bounds of the displacements with which elements come to run r, and the Reach ahead.

    over : crossings, the next of them, and the steps to come. above : the Reach of the run before.
    """
    if runs.sure[r]:
        height = _at(line, runs.top[r] + runs.distance[r])
        above = Reach(0.0, 0.0, height - bounds.high, height - bounds.low)
        if runs.distance[r] == 1:
            return (law.decay * above.least, law.decay * above.most), above
    crossings, crossing, steps = over
    w = arriving(crossings, crossing, above.least, above.most, steps)
    return w, Reach(0.0, UNKNOWN, above.least, above.most)


@refcount_free_kernel
def _at(line, j):
    """Return the height of sample j, counted on round the period."""
    return line[j - line.size if j >= line.size else j]


@kernel
def _reach(law, bounds, z, c, d, steep, above, w):
    """Return (least, most, reach): bounds of g of a sample, and its Reach.

    c, d : threshold and indentation now. steep : a_j. above : the Reach of the sample upstream.
    w : bounds of the displacement with which elements arrive.
    """
    least = max(steep - bounds.most + law.decay * above.low, z - w[1] - bounds.high)
    most = min(steep - bounds.least + law.decay * above.high, z - w[0] - bounds.low)
    least, most = min(least, c - d), max(most, c - d)
    now = z - max(c, d)
    deepest, highest = min(w[0], z - bounds.high), min(w[1], z - bounds.low)
    reach = Reach(max(least, 0.0), max(most, 0.0), min(now, deepest), max(now, highest))
    return least, most, reach


@kernel
def _part(lists, first, last):
    """Return the Lists of slots first[r] ... last[r]."""
    begin = np.zeros(first.size + 1, np.int64)
    for r in range(first.size):
        begin[r + 1] = begin[r] + last[r] - first[r] + 1
    size = begin[-1]
    z, weight, c = np.empty(size), np.empty(size), np.empty(size)
    for r in range(first.size):
        for i in range(first[r], last[r] + 1):
            k = begin[r] + i - first[r]
            z[k], weight[k], c[k] = lists.z[i], lists.weight[i], lists.c[i]
    return Lists(begin, z, weight, c)


@kernel
def elements_aloft(law, lists, runs, crossings, d, w, steps):
    """Fill in w, shape (n,), the displacements of all elements in runs and on their way to them.

    d : indentation now. steps : still to come; who would arrive later is left out.
    """
    powers = powers_of(law.decay, steps)
    f = 0
    for r in range(runs.top.size):
        if not (runs.sure[r] and runs.distance[r] == 1):
            begin, end, place = crossings.begin[f], crossings.begin[f + 1], crossings.place[f]
            for k in range(1, min(runs.distance[r], powers.size - 1) + 1):
                j = runs.top[r] + k
                arrival = crossings.values[place]
                w[j - w.size if j >= w.size else j] = arrival / powers[k] if arrival else 0.0
                place += 1
                if place == end:
                    place = begin if crossings.round[f] else end - 1
            f += 1
    for r in range(runs.top.size):
        for i in range(lists.first[r], lists.first[r + 1]):
            w[runs.bottom[r] + i - lists.first[r]] = lists.z[i] - max(lists.c[i], d)


@refcount_free_kernel
def arriving(crossings, f, least, most, steps):
    """Return bounds of the displacements with which elements arrive in the steps to come.

    least, most : bounds of the displacement where they leave.
    """
    begin, end = crossings.begin[f], crossings.begin[f + 1]
    if crossings.round[f]:
        low, high = crossings.left[f] * least, crossings.left[f] * most
    else:
        begin, end = crossings.place[f], end - 1
        forgotten = end - begin < steps
        low, high = (0.0, 0.0) if forgotten else (np.inf, -np.inf)
    for slot in range(begin, end):
        low, high = min(low, crossings.values[slot]), max(high, crossings.values[slot])
    return low, high


@launch.register(State)
def _launch(aloft, values, begin, end, powers, line, top, distance, u):
    w, d = aloft
    count = min(end - begin, powers.size - 1)
    wrap = min(line.size - top - 1, count)
    for k in range(wrap):
        j = top + 1 + k
        values[begin + k] = powers[k + 1] * min(w[j], line[j] - d)
    for k in range(wrap, count):
        j = k - wrap
        values[begin + k] = powers[k + 1] * min(w[j], line[j] - d)
