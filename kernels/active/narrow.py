"""Shorter lists in a long march: what is still open within narrower bounds, of what was listed.

What always touches goes on to, and so does what never does: nothing but the runs is looked at.
The recursion of gaps g is that of runs.py; as the elements on their way are known, displacements
u are bounded beside it.
"""

from typing import NamedTuple

import numpy as np

from kernels.active.flights import arriving
from kernels.active.lists import Lists, Sums
from kernels.active.marks import ALWAYS, FREE
from kernels.active.runs import LISTED, SHORT, UNKNOWN, Runs, class_of
from kernels.active.setting import rise
from kernels.jit import kernel


class Reach(NamedTuple):
    """Bounds at a sample, now and in all steps to come."""

    low: float  # of max(g, 0)
    high: float
    least: float  # of the displacement u
    most: float


@kernel
def narrowed(law, line, bounds, runs, lists, sums, flights, d, steps):
    """Return (runs, lists, sums) within narrower bounds, at the end of a step.

    line : heights of all samples. d : indentation now. steps : still to come.
    """
    n, size = line.size, lists.c.size
    top, bottom, distance, first, last = (
        np.empty(size, np.int64),
        np.empty(size, np.int64),
        np.empty(size, np.int64),
        np.empty(size, np.int64),
        np.empty(size, np.int64),
    )
    sure, parts = np.empty(size, np.bool_), np.zeros(4)
    count = flight = 0
    # Where elements come from to the first run is known at the end, if it was listed.
    source, from_sure, wraps = n, False, False
    reach = Reach(0.0, UNKNOWN, -bounds.high, 0.0)
    for r in range(runs.top.size):
        j, kind = runs.top[r], FREE
        if runs.sure[r]:
            source, from_sure = j + runs.distance[r], True
            height = line[source - n if source >= n else source]
            reach = Reach(0.0, 0.0, height - bounds.high, height - bounds.low)
        if runs.sure[r] and runs.distance[r] == 1:
            w = law.decay * reach.least, law.decay * reach.most
        else:
            w = arriving(flights, flight, reach.least, reach.most, steps)
            reach = Reach(0.0, UNKNOWN, reach.least, reach.most)
            flight += 1
        for i in range(lists.first[r + 1] - 1, lists.first[r] - 1, -1):
            was, held = kind, reach.high == 0.0
            steep = rise(law, line[j], line[j + 1 if j + 1 < n else 0])
            c = lists.c[i] + (line[j] - lists.z[i])
            least, most, reach = _reach(law, bounds, line[j], c, d, steep, reach, w)
            kind = class_of(False, held and reach.high == 0.0, least, most)
            if kind == ALWAYS:
                depth = sums.level - steep
                parts[0] += 1.0
                parts[1] += depth
                parts[2] += lists.weight[i]
                parts[3] += depth * lists.weight[i]
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
    return runs, _part(lists, first[:count], last[:count]), more


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
