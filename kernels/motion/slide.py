"""Sliding by whole samples: with an element at every sample, nothing is interpolated.

A step moves each element to the next sample of the line, against the motion. State and thresholds
are stored only for stretches of samples below a cap that exceeds all indentations; higher samples
cannot touch. In the gaps between stretches, elements only decay; one ring buffer per gap carries
them from one stretch to the next.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..rheology.law import MIN_MAGNITUDE, free_displacement

SHORT_GAP = 16  # gaps up to this many samples are cheaper to carry along than to skip


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

    z : line, c : thresholds of the previous step, both at the samples of the stretches; stretch
    s begins at first[s]. d : indentation at the end of the previous step. step : number, from 1 on.
    """
    if step > 1:  # initial rings include earlier departures
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


@kernel
def touchable(z, cap):
    """Return (start, stop) of the stretches where z < cap, in line order, both int64 arrays.

    z : heights, shape (n,); z[0] must not be below cap unless all of z is.
    """
    start = np.empty(z.size // 2 + 1, np.int64)
    stop = np.empty(z.size // 2 + 1, np.int64)
    count = 0
    for j in range(z.size):
        if z[j] < cap:
            if count > 0 and j - stop[count - 1] <= SHORT_GAP:
                stop[count - 1] = j + 1
            else:
                start[count] = j
                stop[count] = j + 1
                count += 1
    return start[:count].copy(), stop[:count].copy()


@kernel
def gather(values, start, stop):
    """Return the values of all stretches [start, stop), concatenated."""
    size = 0
    for s in range(start.size):
        size += stop[s] - start[s]
    out = np.empty(size)
    i = 0
    for s in range(start.size):
        for j in range(start[s], stop[s]):
            out[i] = values[j]
            i += 1
    return out


@kernel
def piece_bounds(lengths):
    """Return the first index of each consecutive piece, and the end of the last."""
    out = np.zeros(lengths.size + 1, np.int64)
    for s in range(lengths.size):
        out[s + 1] = out[s] + lengths[s]
    return out
