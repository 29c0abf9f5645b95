"""Elements on their way to the runs: they come from contact next to one, or across a gap.

In a gap no sample is touched: an element leaves the sample above it with u and arrives q steps
later with E^q u. Slots hold the displacements of arrival, one for each step to come; where a gap
is crossed within the march they go round, and the element that leaves takes the slot of the one
that arrives.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import dispatch_on_type, kernel, refcount_free_kernel
from ...rheology.law import MIN_MAGNITUDE
from .given import a_of

FORGOTTEN = 1e-30  # what decays below this, beside d, is zero


class Neighbours(NamedTuple):
    """Runs that elements enter straight from a sample that always touches."""

    at: np.ndarray  # where they enter the lists: the last sample of the run
    a: np.ndarray  # a_j there


class Crossings(NamedTuple):
    """Runs that elements enter across a gap, or from a listed sample at the other end of the line.

    Crossing f has its slots in values[begin[f] : begin[f + 1]].
    """

    at: np.ndarray  # where they enter the lists
    begin: np.ndarray  # shape (crossings + 1,)
    place: np.ndarray  # the slot of the next arrival; changes
    round: np.ndarray  # whether slots go round, or the last one, zero, stays
    values: np.ndarray
    source: np.ndarray  # where elements leave the lists; -1 for a sample that always touches
    height: np.ndarray  # z of the sample they leave
    left: np.ndarray  # E^q


class Steady(NamedTuple):
    """Elements in steady sliding at v1: between runs they decay from where they left."""

    once: float  # what is left of a displacement after one sample
    d: float  # indentation


@dispatch_on_type.refcount_free
def launch(aloft, values, begin, end, powers, line, top, distance, u):
    """Fill in the displacements, at their arrival, of the elements now upstream of sample top.

    aloft : displacements of now, a State of all samples or Steady. distance, u : of the sample
    that elements come from, and the displacement there.
    """


@kernel
def powers_of(decay, steps):
    """Return E^k for k = 0 ... up to steps or to the first one that is as good as zero."""
    powers = np.empty(steps + 1)
    powers[0] = 1.0
    for k in range(1, steps + 1):
        powers[k] = powers[k - 1] * decay
        if powers[k] < FORGOTTEN:
            powers[k] = 0.0
            return powers[: k + 1]
    return powers


@kernel
def arrivals_of(law, lists, runs, aloft, line, steps):
    """Return (Neighbours, Crossings) of all runs.

    line : heights of all samples. aloft : displacements without force and indentation of now,
    Steady, or a State of all samples that elements fly over. steps : still to come.
    """
    powers = powers_of(law.decay, steps)
    near, far = np.empty(runs.top.size, np.int64), np.empty(runs.top.size, np.int64)
    a = f = 0
    for r in range(runs.top.size):
        if runs.sure[r] and runs.distance[r] == 1:
            near[a] = r
            a += 1
        else:
            far[f] = r
            f += 1
    at, steep = np.empty(a, np.int64), np.empty(a)
    for i in range(a):
        at[i] = lists.first[near[i] + 1] - 1
        above = runs.top[near[i]] + 1
        steep[i] = a_of(law, lists.z[at[i]], line[above if above < line.size else 0])
    neighbours = Neighbours(at, steep)
    return neighbours, _crossings(lists, runs, far[:f], aloft, line, powers)


@kernel
def _crossings(lists, runs, far, aloft, line, powers):
    """Return the Crossings of the runs ``far``."""
    reach, size = powers.size - 1, far.size
    at, begin, place = (
        np.empty(size, np.int64),
        np.zeros(size + 1, np.int64),
        np.empty(size, np.int64),
    )
    source, height, left = np.empty(size, np.int64), np.empty(size), np.empty(size)
    goes = np.empty(size, np.bool_)
    for f in range(size):
        r = far[f]
        q = runs.distance[r]
        at[f], place[f], goes[f] = lists.first[r + 1] - 1, begin[f], q <= reach
        begin[f + 1] = begin[f] + (q if goes[f] else reach + 1)
        left[f] = powers[q] if goes[f] else 0.0
        if runs.sure[r]:
            above = runs.top[r] + q
            source[f], height[f] = -1, line[above - line.size if above >= line.size else above]
        else:
            source[f] = lists.first[r - 1 if r > 0 else runs.top.size - 1]
            height[f] = lists.z[source[f]]
    values = np.empty(begin[-1])
    for f in range(size):
        r = far[f]
        u = height[f] - (aloft.d if source[f] < 0 else max(lists.c[source[f]], aloft.d))
        launch(
            aloft, values, begin[f], begin[f + 1], powers, line, runs.top[r], runs.distance[r], u
        )
        if not goes[f]:
            values[begin[f + 1] - 1] = 0.0  # all that comes later has been forgotten
        elif source[f] < 0:
            values[begin[f + 1] - 1] = left[f] * u
    return Crossings(at, begin, place, goes, values, source, height, left)


@launch.register(Steady)
def _launch_at_first(aloft, values, begin, end, powers, line, top, distance, u):
    count = min(end - begin, powers.size - 1)
    u *= aloft.once ** float(distance - count)
    for k in range(count - 1, -1, -1):
        u = u if u < -MIN_MAGNITUDE else 0.0
        values[begin + k] = powers[k + 1] * u
        u *= aloft.once


@refcount_free_kernel
def arrive(law, lists, arrivals, d):
    """Set the thresholds where elements enter the lists. d : indentation before the step."""
    neighbours, crossings = arrivals
    for i in range(neighbours.at.size):
        lists.c[neighbours.at[i]] = neighbours.a[i] + law.decay * d
    for f in range(crossings.at.size):
        i = crossings.at[f]
        lists.c[i] = lists.z[i] - crossings.values[crossings.place[f]]


@refcount_free_kernel
def depart(lists, crossings, d):
    """Send elements across the gaps at the end of a step, and go on to the next slots."""
    for f in range(crossings.at.size):
        place = crossings.place[f]
        if crossings.round[f]:
            i = crossings.source[f]
            u = crossings.height[f] - (d if i < 0 else max(lists.c[i], d))
            crossings.values[place] = crossings.left[f] * u
        place += 1
        if place == crossings.begin[f + 1]:
            place = crossings.begin[f] if crossings.round[f] else place - 1
        crossings.place[f] = place
