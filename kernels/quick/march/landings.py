"""Samples at which elements land that fly over a gap: sums, where they always do so.

Where an element comes from z_s, which always touches, q samples over a gap to sample j, and always
touches there, its overlap is

    d(t) - z_j + E^q (z_s - d(t - q)),

so that all such samples together need the past of d alone: one term for every distance q.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from .crossings import FORGOTTEN

SAME = 2e-15  # of d: displacements that differ by rounding


class Landings(NamedTuple):
    """Such samples together. More of them are added while the march goes on."""

    reference: float  # an indentation; overlaps at it are summed, which lose no digits near it
    tally: np.ndarray  # shape (4,): how many; sums of overlaps, lagged slopes, their products
    crossing: np.ndarray  # shape (2, most q + 1): sums of E^q, and times the lagged slopes
    distances: np.ndarray  # the distances q that there are, increasing
    past: np.ndarray  # d after the steps, from step 0 on, shape (steps + 1,): filled on the way


@kernel
def no_landings(reference, d, steps):
    """Return Landings without any. d : at the start. steps : of the march."""
    past = np.empty(steps + 1)
    past[0] = d
    return Landings(reference, np.zeros(4), np.zeros((2, steps + 1)), np.empty(0, np.int64), past)


@refcount_free_kernel
def land(law, landings, gap, behind, past, w, steps):
    """Return whether elements land behind a gap by the past of d alone; if so, add the sample.

    gap : as of left_contact. behind : height and lagged slope of the sample. past, w, steps : as
    of left_contact.
    """
    (height, _, q), (z, weight) = gap, behind
    crossing = left_contact(law, gap, past, w, steps)
    if crossing == 0.0:
        return False
    overlap = (landings.reference - z) + crossing * (height - landings.reference)
    landings.tally[0] += 1.0
    landings.tally[1] += overlap
    landings.tally[2] += weight
    landings.tally[3] += overlap * weight
    landings.crossing[0, q] += crossing
    landings.crossing[1, q] += crossing * weight
    return True


@kernel
def landed(landings):
    """Return the Landings with the distances that there are by now."""
    crossing = landings.crossing
    distances, count = np.empty(crossing.shape[1], np.int64), 0
    for q in range(crossing.shape[1]):
        distances[count] = q
        count += crossing[0, q] > 0.0
    some = distances[:count].copy()
    return Landings(landings.reference, landings.tally, crossing, some, landings.past)


@kernel
def copied(landings):
    """Return a copy for put_back, whose ``crossing`` has columns for its ``distances`` alone."""
    reference, tally, crossing, distances, past = landings
    sums = np.empty((2, distances.size))
    for i in range(distances.size):
        sums[:, i] = crossing[:, distances[i]]
    return Landings(reference, tally.copy(), sums, distances, past)


@kernel
def put_back(landings, before):
    """Return the Landings as they were when they were copied."""
    crossing = landings.crossing
    for q in landings.distances:
        crossing[:, q] = 0.0
    for i in range(before.distances.size):
        crossing[:, before.distances[i]] = before.crossing[:, i]
    return Landings(before.reference, before.tally, crossing, before.distances, before.past)


@refcount_free_kernel
def beside(landings, step, d, row):
    """Return (how many samples there are, the sum over them) at the indentation d in a step.

    Of their overlaps (row 0), or of those times lagged slopes (row 1).
    """
    reference, tally, crossing, distances, past = landings
    one = other = 0.0
    whole = distances.size - distances.size % 2
    for i in range(0, whole, 2):
        q, p = distances[i], distances[i + 1]
        one += crossing[row, q] * (past[step - q] - reference)
        other += crossing[row, p] * (past[step - p] - reference)
    if whole < distances.size:
        q = distances[whole]
        one += crossing[row, q] * (past[step - q] - reference)
    return tally[0], (tally[2 * row] * (d - reference) + tally[2 * row + 1]) - (one + other)


@refcount_free_kernel
def left_contact(law, gap, past, w, steps):
    """Return E^q if all elements in a gap left contact at its source, in the last steps, else 0.

    gap : height and number of the source, and q, the samples from there to the landing. past : d
    up to now. w : displacements of all samples now, of elements that arrive within so many steps.
    """
    height, source, q = gap
    if not 1 < q < past.size or q > steps:
        return 0.0
    crossing = 1.0
    for i in range(1, q):
        crossing *= law.decay
        j = source - i
        apart = w[j - w.size if j >= w.size else j] - crossing * (height - past[-1 - i])
        if not abs(apart) <= SAME * past[-1]:
            return 0.0
    return crossing * law.decay if crossing > FORGOTTEN else 0.0
