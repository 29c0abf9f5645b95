"""Sums over samples that always touch and lie behind a gap that begins at such a sample.

If an element leaves sample s, which always touches, crosses a gap, arrives q samples farther at
sample j, and always touches there, its overlap is

    d(t) - z_j + E^q (z_s - d(t - q)).

The sum over these samples depends on the past of d alone, with one term for every distance q.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from .gap_crossings import NEGLIGIBLE_DECAY
from .listed_samples import TALLY_DEPTH, TALLY_MOMENT, TALLY_SAMPLES, TALLY_WEIGHT

EQUAL_DISPLACEMENT = 2e-15  # largest difference, relative to d, that counts as rounding


class Gap(NamedTuple):
    """A gap that ends at a landing sample."""

    source_z: float  # height of the source, the sample that elements come from
    source: int  # number of the source
    distance: int  # q, from the source to the landing sample


class Landings(NamedTuple):
    """All certain landings of a march; ``add_landing`` adds more of them on the way."""

    reference: float  # indentation at which overlaps are summed, so that sums lose no digits
    tally: np.ndarray  # shape (4,), see listed_samples.py
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
