"""What touches in a steady state: whole spans within contacts, and samples one by one."""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...model.friction import MIN_COVERAGE, weighted_sums
from ..steady.contacts import AHEAD, BEHIND, FREE, SUM
from ..steady.spans import SPAN


class Touching(NamedTuple):
    """The touching samples of a line: those of whole spans, and the others one by one."""

    weight: np.ndarray  # how much of each sample the contact covers
    height: np.ndarray  # of each, in h
    slope: np.ndarray  # of each, in h/dx
    spans: np.ndarray  # number of every span that is all within a piece of contact


@refcount_free_kernel
def covered(contacts, i):
    """Return how much of the top and of the bottom sample of a piece the contact covers.

    A piece of one sample is all top.
    """
    ahead, behind = contacts.edges[i, AHEAD] - 0.5, contacts.edges[i, BEHIND] - 0.5
    if contacts.ends[i, 0] == contacts.ends[i, 1]:
        return max(1.0 + ahead + behind, MIN_COVERAGE), 0.0
    return max(1.0 + ahead, MIN_COVERAGE), max(1.0 + behind, MIN_COVERAGE)


@kernel
def room_for_all(samples):
    """Return Touching with room for all samples of a line."""
    spans = np.empty(samples // SPAN + 1, np.int64)
    return Touching(np.empty(samples), np.empty(samples), np.empty(samples), spans)


@kernel
def list_touching(z, slope, contacts, room):
    """Return Touching of a line of heights z and slopes, in the memory of ``room``."""
    weight, height, steep, spans = room
    count = whole = 0
    for i in range(contacts.ends.shape[0]):
        top, j = contacts.ends[i, 0], contacts.ends[i, 1]
        at_top, at_bottom = covered(contacts, i)
        begin = count
        while j <= top:
            stop = min(top + 1, j - j % SPAN + SPAN)
            if stop - j == SPAN and begin < count and stop <= top:
                spans[whole] = j // SPAN
                whole += 1
                j = stop
            while j < stop:
                weight[count], height[count], steep[count] = 1.0, z[j], slope[j]
                count += 1
                j += 1
        weight[begin] = at_bottom
        weight[count - 1] = at_top  # of a piece of one sample, which is all top
    return Touching(weight[:count], height[:count], steep[:count], spans[:whole])


@refcount_free_kernel
def steepest(spans, touching):
    """Return the largest |z'| among the touching samples."""
    most = 0.0
    for b in touching.spans:
        most = max(most, spans.steepest[b])
    for steep in touching.slope:
        most = max(most, abs(steep))
    return most


@kernel
def mean_rise(z, d, decay, contacts):
    """Return by how much the line rises in a step over its contacts, a mean over their forces."""
    threshold, rise, count = np.empty(z.size), np.empty(z.size), 0
    for i in range(contacts.ends.shape[0]):
        free = contacts.edges[i, FREE]
        for j in range(contacts.ends[i, 0], contacts.ends[i, 1] - 1, -1):
            u = z[j] - d
            threshold[count], rise[count] = u - free, z[j + 1 if j + 1 < z.size else 0] - z[j]
            count += 1
            free = decay.once * u
    forces, work, _ = weighted_sums(threshold[:count], None, rise[:count], 0.0)
    return work / forces


@kernel
def median_width(z, d, decay, contacts):
    """Return the median over the load of the width of patches (samples.py), in samples."""
    pieces = contacts.ends.shape[0]
    start = 0
    while start < pieces and contacts.ends[start, 2] == 1:
        start += 1
    if start == pieces:
        return float(z.size)
    width = np.zeros(pieces, np.int64)
    carried = np.zeros(pieces)
    patches = 0
    for k in range(pieces):
        i = start + k if start + k < pieces else start + k - pieces
        patches += 1 - contacts.ends[i, 2]
        width[patches - 1] += contacts.ends[i, 0] - contacts.ends[i, 1] + 1
        carried[patches - 1] += _carried(z, d, decay, contacts, i)
    widest, half = 0, 0.0
    for p in range(patches):
        widest = max(widest, width[p])
    by_width = np.zeros(widest + 1)
    for p in range(patches):
        by_width[width[p]] += carried[p]
        half += 0.5 * carried[p]
    total = 0.0
    for wide in range(by_width.size):
        total += by_width[wide]
        if total >= half and total > 0.0:
            return float(wide)
    return float(by_width.size - 1)


@refcount_free_kernel
def _carried(z, d, decay, contacts, i):
    """Return sum (w - u) over a piece: inside it every w is E times the u ahead."""
    bottom = z[contacts.ends[i, 1]] - d
    rest = (1.0 - decay.once) * contacts.edges[i, SUM]
    return contacts.edges[i, FREE] - decay.once * bottom + rest
