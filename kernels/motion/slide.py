"""Sliding by whole samples: with an element at every sample, nothing is interpolated.

A step moves each element to the next sample of the line, against the motion. State and thresholds
are stored at the samples of the stretches that can touch (stretches.py). In the gaps between
stretches, elements only decay; one ring buffer per gap carries them from one stretch to the next.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..rheology.law import MIN_MAGNITUDE, free_displacement
from .stretches import piece_bounds


class Rings(NamedTuple):
    """Displacements of the elements that cross the gaps.

    Ring s covers the gap above stretch s. The element that arrives in step t is in slot
    t % (gap + 1), with its displacement at the arrival.
    """

    slots: np.ndarray  # slots of all rings, in h
    at: np.ndarray  # index of the first slot of each ring, and the end of the last ring
    crossing: np.ndarray  # decay factor over each gap


@kernel
def start_rings(law, z, state, start, stop):
    """Return the initial Rings: elements in gaps decay from their present displacements."""
    n = z.size
    lengths = np.empty(start.size, np.int64)
    for s in range(start.size):
        lengths[s] = (start[s + 1] if s + 1 < start.size else start[0] + n) - stop[s] + 1
    at = piece_bounds(lengths)
    slots = np.empty(at[-1])
    crossing = np.ones(start.size)
    for s in range(start.size):
        for t in range(1, lengths[s] + 1):
            crossing[s] = free_displacement(law, crossing[s])
            if crossing[s] < MIN_MAGNITUDE:
                crossing[s] = 0.0
            j = (stop[s] - 1 + t) % n
            slots[at[s] + t % lengths[s]] = crossing[s] * min(state.w[j], z[j] - state.d)
    return Rings(slots, at, crossing)


@kernel
def shift(law, z, c, d, first, rings, step):
    """Move every element to the next sample, and fill c with the thresholds before contact.

    z : line, c : thresholds of the step before, both at the samples of the stretches; stretch s
    begins at first[s]. d : indentation at the end of the step before. step : number, from 1 on.
    """
    if step > 1:  # initial rings include the elements that left before
        _depart(z, c, d, first, rings, step - 1)
    for s in range(first.size - 1):
        for i in range(first[s], first[s + 1] - 1):
            c[i] = z[i] - free_displacement(law, z[i + 1] - max(c[i + 1], d))
        last = first[s + 1] - 1
        c[last] = z[last] - rings.slots[_slot(rings, s, step)]


@kernel
def _depart(z, c, d, first, rings, step):
    """Put the elements that leave their stretches at the end of a step into the rings."""
    for s in range(first.size - 1):
        below = s - 1 if s > 0 else first.size - 2
        leaving = z[first[s]] - max(c[first[s]], d)
        rings.slots[_slot(rings, below, step)] = rings.crossing[below] * leaving


@kernel
def _slot(rings, s, step):
    """Return the slot of ring s whose element arrives in this step."""
    return rings.at[s] + step % (rings.at[s + 1] - rings.at[s])
