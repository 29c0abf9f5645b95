"""Elements that cross gaps: those that enter runs, and those that certainly land behind a gap.

**Entries.** Elements enter a run from the neighbouring contact or across a gap. No sample of a gap
touches: an element leaves contact with displacement u and arrives q steps later with E^q u.
``arrivals`` holds these displacements, one place per step to come. If elements can cross the gap
within the march, the places form a ring: the element that leaves takes the place of the one that
arrives.

**Certain landings.** If an element leaves sample s, which always touches, crosses a gap, arrives q
samples farther at sample j, and always touches there, its overlap is

    d(t) - z_j + E^q (z_s - d(t - q)).

The sum over these samples depends on the past of d alone, with one term for every distance q.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import dispatch_refcount_free, kernel, refcount_free_kernel
from ...rheology.law import MIN_MAGNITUDE
from .problem import TALLY_DEPTH, TALLY_MOMENT, TALLY_SAMPLES, TALLY_WEIGHT, line_rise

NEGLIGIBLE_DECAY = 1e-30  # a displacement decayed by a smaller factor is zero relative to d
EQUAL_DISPLACEMENT = 2e-15  # largest difference, relative to d, that counts as rounding


class DirectEntries(NamedTuple):
    """Runs that elements enter directly from a sample that always touches."""

    slot: np.ndarray  # of the leading sample of the run, where elements enter the lists
    rise: np.ndarray  # a_j of that sample


class GapCrossings(NamedTuple):
    """Runs that elements enter across a gap, or from a listed sample at the other end of the line.

    Crossing f has its arrivals in arrivals[begin[f] : begin[f + 1]].
    """

    slot: np.ndarray  # where elements enter the lists
    begin: np.ndarray  # shape (crossings + 1,)
    next: np.ndarray  # place of the next arrival; advances at every step
    is_ring: np.ndarray  # whether the places form a ring; if not, all arrivals after the last are 0
    arrivals: np.ndarray  # displacements at arrival
    source: np.ndarray  # slot from which elements leave; -1 for a sample that always touches
    source_z: np.ndarray  # height of the sample that they leave
    decay: np.ndarray  # E^q


class Entries(NamedTuple):
    """Entries of elements into all runs."""

    direct: DirectEntries
    crossings: GapCrossings


class SteadyFlight(NamedTuple):
    """Free elements in steady sliding at v1; displacements decay from the last contact on."""

    decay: float  # factor of a displacement over one sample
    d: float  # indentation


@dispatch_refcount_free
def fill_arrivals(flight, arrivals, powers, line, leading, distance, u):
    """Fill ``arrivals`` for the elements now between a leading sample and its source.

    flight : present displacements, a State of all samples or SteadyFlight. distance : to the
    source that elements come from. u : displacement there.
    """


@kernel
def decay_powers(decay, steps):
    """Return E^k for k = 0, 1, ... ``steps``, cut at the first negligible power, set to 0."""
    powers = np.empty(steps + 1)
    powers[0] = 1.0
    for k in range(1, steps + 1):
        powers[k] = powers[k - 1] * decay
        if powers[k] < NEGLIGIBLE_DECAY:
            powers[k] = 0.0
            return powers[: k + 1]
    return powers


@kernel
def run_entries(law, listed, runs, flight, line, steps):
    """Return the Entries into all runs.

    line : heights of all samples. flight : present displacements and indentation, SteadyFlight or
    a State of all samples. steps : number of steps to come.
    """
    powers = decay_powers(law.decay, steps)
    direct, crossing = np.empty(runs.leading.size, np.int64), np.empty(runs.leading.size, np.int64)
    a = f = 0
    for r in range(runs.leading.size):
        if runs.source_touches[r] and runs.distance[r] == 1:
            direct[a] = r
            a += 1
        else:
            crossing[f] = r
            f += 1
    slot, rise = np.empty(a, np.int64), np.empty(a)
    for i in range(a):
        slot[i] = listed.begin[direct[i] + 1] - 1
        upstream = runs.leading[direct[i]] + 1
        rise[i] = line_rise(law, listed.z[slot[i]], line[upstream if upstream < line.size else 0])
    crossings = _gap_crossings(listed, runs, crossing[:f], flight, line, powers)
    return Entries(DirectEntries(slot, rise), crossings)


@kernel
def _gap_crossings(listed, runs, crossing, flight, line, powers):
    """Return the GapCrossings of the runs ``crossing``."""
    reach, size = powers.size - 1, crossing.size
    slot, place = np.empty(size, np.int64), np.empty(size, np.int64)
    source, begin = np.empty(size, np.int64), np.zeros(size + 1, np.int64)
    source_z, decay, is_ring = np.empty(size), np.empty(size), np.empty(size, np.bool_)
    for f in range(size):
        r = crossing[f]
        q = runs.distance[r]
        slot[f], place[f], is_ring[f] = listed.begin[r + 1] - 1, begin[f], q <= reach
        begin[f + 1] = begin[f] + (q if is_ring[f] else reach + 1)
        decay[f] = powers[q] if is_ring[f] else 0.0
        if runs.source_touches[r]:
            upstream = runs.leading[r] + q
            upstream = upstream - line.size if upstream >= line.size else upstream
            source[f], source_z[f] = -1, line[upstream]
        else:
            source[f] = listed.begin[r - 1 if r > 0 else runs.leading.size - 1]
            source_z[f] = listed.z[source[f]]
    arrivals = np.empty(begin[-1])
    for f in range(size):
        r, of_run = crossing[f], arrivals[begin[f] : begin[f + 1]]
        u = source_z[f] - (flight.d if source[f] < 0 else max(listed.c[source[f]], flight.d))
        fill_arrivals(flight, of_run, powers, line, runs.leading[r], runs.distance[r], u)
        if not is_ring[f]:
            of_run[-1] = 0.0  # all later arrivals are negligible
        elif source[f] < 0:
            of_run[-1] = decay[f] * u
    return GapCrossings(slot, begin, place, is_ring, arrivals, source, source_z, decay)


@fill_arrivals.register(SteadyFlight)
def _fill_steady_arrivals(flight, arrivals, powers, line, leading, distance, u):
    count = min(arrivals.size, powers.size - 1)
    u *= flight.decay ** float(distance - count)
    for k in range(count - 1, -1, -1):
        u = u if u < -MIN_MAGNITUDE else 0.0
        arrivals[k] = powers[k + 1] * u
        u *= flight.decay


@refcount_free_kernel
def enter_runs(law, listed, entries, d):
    """Set the thresholds of elements that enter the lists. d : indentation before the step."""
    direct, crossings = entries
    for i in range(direct.slot.size):
        listed.c[direct.slot[i]] = direct.rise[i] + law.decay * d
    for f in range(crossings.slot.size):
        i = crossings.slot[f]
        listed.c[i] = listed.z[i] - crossings.arrivals[crossings.next[f]]


@refcount_free_kernel
def leave_runs(listed, crossings, d):
    """Send elements into the gaps at the end of a step, and advance to the next arrivals."""
    for f in range(crossings.slot.size):
        place = crossings.next[f]
        if crossings.is_ring[f]:
            i = crossings.source[f]
            u = crossings.source_z[f] - (d if i < 0 else max(listed.c[i], d))
            crossings.arrivals[place] = crossings.decay[f] * u
        place += 1
        if place == crossings.begin[f + 1]:
            place = crossings.begin[f] if crossings.is_ring[f] else place - 1
        crossings.next[f] = place


class Gap(NamedTuple):
    """A gap that ends at a landing sample."""

    source_z: float  # height of the source, the sample that elements come from
    source: int  # number of the source
    distance: int  # q, from the source to the landing sample


class Landings(NamedTuple):
    """All certain landings of a march; ``add_landing`` adds more of them on the way."""

    reference: float  # indentation at which overlaps are summed, so that sums lose no digits
    tally: np.ndarray  # shape (4,), see kinds.py
    crossing: np.ndarray  # shape (2, largest q + 1), by q: sums of E^q, of E^q times lagged slope
    distances: np.ndarray  # the distances q in use, increasing
    past: np.ndarray  # d after each step, from step 0 on, shape (steps + 1,); filled on the way


@kernel
def no_landings(reference, d, steps):
    """Return empty Landings. d : initial indentation. steps : number of steps of the march."""
    past = np.empty(steps + 1)
    past[0] = d
    return Landings(reference, np.zeros(4), np.zeros((2, steps + 1)), np.empty(0, np.int64), past)


@refcount_free_kernel
def add_landing(law, landings, gap, z, weight, past, w, steps):
    """Add a landing sample if the past of d determines its arrivals; return whether it was added.

    z, weight : height and lagged slope of the sample. gap, past, w, steps : see crossing_decay.
    """
    crossing = crossing_decay(law, gap, past, w, steps)
    if crossing == 0.0:
        return False
    overlap = (landings.reference - z) + crossing * (gap.source_z - landings.reference)
    landings.tally[TALLY_SAMPLES] += 1.0
    landings.tally[TALLY_DEPTH] += overlap
    landings.tally[TALLY_WEIGHT] += weight
    landings.tally[TALLY_MOMENT] += overlap * weight
    landings.crossing[0, gap.distance] += crossing
    landings.crossing[1, gap.distance] += crossing * weight
    return True


@kernel
def update_distances(landings):
    """Return the Landings with ``distances`` of all landings added so far."""
    crossing = landings.crossing
    distances, count = np.empty(crossing.shape[1], np.int64), 0
    for q in range(crossing.shape[1]):
        distances[count] = q
        count += crossing[0, q] > 0.0
    in_use = distances[:count].copy()
    return Landings(landings.reference, landings.tally, crossing, in_use, landings.past)


@kernel
def saved_landings(landings):
    """Return a copy for restored_landings; its ``crossing`` has a column per distance in use."""
    reference, tally, crossing, distances, past = landings
    columns = np.empty((2, distances.size))
    for i in range(distances.size):
        columns[:, i] = crossing[:, distances[i]]
    return Landings(reference, tally.copy(), columns, distances, past)


@kernel
def restored_landings(landings, saved):
    """Return the Landings as they were when ``saved`` was made."""
    crossing = landings.crossing
    for q in landings.distances:
        crossing[:, q] = 0.0
    for i in range(saved.distances.size):
        crossing[:, saved.distances[i]] = saved.crossing[:, i]
    return Landings(saved.reference, saved.tally, crossing, saved.distances, saved.past)


@refcount_free_kernel
def landing_sums(landings, step, d, row):
    """Return (number of landing samples, sum over them in a step at indentation d).

    row : 0 for the sum of overlaps, 1 for the sum of overlaps times lagged slopes.
    """
    reference, tally, crossing, distances, past = landings
    even = odd = 0.0  # two partial sums, for speed
    whole = distances.size - distances.size % 2
    for i in range(0, whole, 2):
        q, p = distances[i], distances[i + 1]
        even += crossing[row, q] * (past[step - q] - reference)
        odd += crossing[row, p] * (past[step - p] - reference)
    if whole < distances.size:
        q = distances[whole]
        even += crossing[row, q] * (past[step - q] - reference)
    now = tally[2 * row] * (d - reference) + tally[2 * row + 1]
    return tally[TALLY_SAMPLES], now - (even + odd)


@refcount_free_kernel
def crossing_decay(law, gap, past, w, steps):
    """Return E^q if all elements in a gap left its source during the march, else 0.

    A negligible E^q counts as 0. past : d up to now. w : present displacements, valid for
    elements that arrive within ``steps``.
    """
    source_z, source, q = gap
    if not 1 < q < past.size or q > steps:
        return 0.0
    crossing = 1.0
    for i in range(1, q):
        crossing *= law.decay
        j = source - i
        difference = w[j - w.size if j >= w.size else j] - crossing * (source_z - past[-1 - i])
        if not abs(difference) <= EQUAL_DISPLACEMENT * past[-1]:
            return 0.0
    return crossing * law.decay if crossing > NEGLIGIBLE_DECAY else 0.0
