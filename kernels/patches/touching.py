"""What touches in a steady state: whole spans within contacts, and samples one by one."""

from typing import NamedTuple

import numpy as np

from kernels.friction import LEAST_COVERED
from kernels.jit import kernel
from kernels.steady.contacts import AHEAD, BEHIND, FREE
from kernels.steady.spans import SPAN


class Touching(NamedTuple):
    """The touching samples of a line: those of whole spans, and others."""

    at: np.ndarray  # samples that belong to no span of the list
    weight: np.ndarray  # how much of each the contact covers
    spans: np.ndarray  # number of every span that is all within a piece of contact


@kernel
def covered(contacts, i):
    """Return how much of the top and of the bottom sample of a piece the contact covers.

    A piece of one sample is all top.
    """
    ahead, behind = contacts.edges[i, AHEAD] - 0.5, contacts.edges[i, BEHIND] - 0.5
    if contacts.ends[i, 0] == contacts.ends[i, 1]:
        return max(1.0 + ahead + behind, LEAST_COVERED), 0.0
    return max(1.0 + ahead, LEAST_COVERED), max(1.0 + behind, LEAST_COVERED)


@kernel
def room_for_all(samples):
    """Return Touching with room for all samples of a line."""
    spans = np.empty(samples // SPAN + 1, np.int64)
    return Touching(np.empty(samples, np.int64), np.empty(samples), spans)


@kernel
def list_touching(contacts, room):
    """Return Touching, in the memory of ``room``."""
    at, weight, spans = room
    count = whole = 0
    for i in range(contacts.ends.shape[0]):
        top, j = contacts.ends[i, 0], contacts.ends[i, 1]
        at_top, at_bottom = covered(contacts, i)
        if j < top:
            at[count], weight[count] = j, at_bottom
            count += 1
            j += 1
        while j < top:
            stop = min(top, j - j % SPAN + SPAN)
            if stop - j == SPAN:
                spans[whole] = j // SPAN
                whole += 1
                j = stop
            while j < stop:
                at[count], weight[count] = j, 1.0
                count += 1
                j += 1
        at[count], weight[count] = top, at_top
        count += 1
    return Touching(at[:count], weight[:count], spans[:whole])


@kernel
def steepest(slope, spans, touching):
    """Return the largest |z'| among the touching samples."""
    most = 0.0
    for b in touching.spans:
        most = max(most, spans.steepest[b])
    for j in touching.at:
        most = max(most, abs(slope[j]))
    return most


@kernel
def mean_rise(z, d, decay, contacts):
    """Return by how much the line rises in a step over its contacts, a mean over their forces."""
    total = work = 0.0
    for i in range(contacts.ends.shape[0]):
        free = contacts.edges[i, FREE]
        for j in range(contacts.ends[i, 0], contacts.ends[i, 1] - 1, -1):
            u = z[j] - d
            total += free - u
            work += (free - u) * (z[j + 1 if j + 1 < z.size else 0] - z[j])
            free = decay.once * u
    return work / total


@kernel
def median_width(z, d, spans, decay, contacts):
    """Return the median over the load of the width of patches (patches/samples.py), in samples."""
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
        carried[patches - 1] += _carried(z, d, spans, decay, contacts, i)
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


@kernel
def _carried(z, d, spans, decay, contacts, i):
    """Return sum (w - u) over a piece: inside it every w is E times the u ahead."""
    top, j = contacts.ends[i, 0], contacts.ends[i, 1]
    sum_u = 0.0
    bottom = z[j] - d
    while j <= top:
        if j % SPAN == 0 and j + SPAN - 1 <= top:
            sum_u += SPAN * (z[j] - d) + spans.height[j // SPAN]
            j += SPAN
        else:
            sum_u += z[j] - d
            j += 1
    return contacts.edges[i, FREE] - decay.once * bottom - (1.0 - decay.once) * sum_u
