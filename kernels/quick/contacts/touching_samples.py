"""Touching samples of a steady state: whole spans inside contacts, and single samples."""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...model.friction import MIN_COVERAGE, weighted_sums
from ..steady.contact_pieces import (
    DEPTH_SUM,
    FREE_DISPLACEMENT,
    JOINED,
    LEADING,
    LEADING_REACH,
    TRAILING,
    TRAILING_REACH,
)
from ..steady.spans import SPAN


class TouchingSamples(NamedTuple):
    """The touching samples of a line."""

    weight: np.ndarray  # share of each single sample that the contact covers
    height: np.ndarray  # of each single sample, in h
    slope: np.ndarray  # of each single sample, in h/dx
    spans: np.ndarray  # indices of the spans that lie inside a piece of contact


@refcount_free_kernel
def covered_shares(contacts, i):
    """Return the shares of the leading and the trailing sample of piece i that contact covers.

    For a piece of one sample, the leading share includes both edges and the trailing one is zero.
    """
    ahead, behind = contacts.edges[i, LEADING_REACH] - 0.5, contacts.edges[i, TRAILING_REACH] - 0.5
    if contacts.ends[i, LEADING] == contacts.ends[i, TRAILING]:
        return max(1.0 + ahead + behind, MIN_COVERAGE), 0.0
    return max(1.0 + ahead, MIN_COVERAGE), max(1.0 + behind, MIN_COVERAGE)


@kernel
def allocate_touching(samples):
    """Return TouchingSamples with room for all samples of a line."""
    spans = np.empty(samples // SPAN + 1, np.int64)
    return TouchingSamples(np.empty(samples), np.empty(samples), np.empty(samples), spans)


@kernel
def list_touching(z, slope, contacts, room):
    """Return the TouchingSamples of a line of heights z and slopes, in the memory of ``room``."""
    weight, height, slopes, spans = room
    count = span_count = 0
    for i in range(contacts.ends.shape[0]):
        leading, j = contacts.ends[i, LEADING], contacts.ends[i, TRAILING]
        at_leading, at_trailing = covered_shares(contacts, i)
        begin = count
        while j <= leading:
            stop = min(leading + 1, j - j % SPAN + SPAN)
            if stop - j == SPAN and begin < count and stop <= leading:
                spans[span_count] = j // SPAN
                span_count += 1
                j = stop
            while j < stop:
                weight[count], height[count], slopes[count] = 1.0, z[j], slope[j]
                count += 1
                j += 1
        weight[begin] = at_trailing
        weight[count - 1] = at_leading  # last, as it alone counts for a piece of one sample
    return TouchingSamples(weight[:count], height[:count], slopes[:count], spans[:span_count])


@refcount_free_kernel
def largest_slope(spans, touching):
    """Return the largest |z'| among the touching samples."""
    largest = 0.0
    for b in touching.spans:
        largest = max(largest, spans.steepest[b])
    for slope in touching.slope:
        largest = max(largest, abs(slope))
    return largest


@kernel
def mean_rise(z, d, decay, contacts):
    """Return the force-weighted mean of the rise of the line per step, over its contacts."""
    threshold, rise, count = np.empty(z.size), np.empty(z.size), 0
    for i in range(contacts.ends.shape[0]):
        free = contacts.edges[i, FREE_DISPLACEMENT]
        for j in range(contacts.ends[i, LEADING], contacts.ends[i, TRAILING] - 1, -1):
            u = z[j] - d
            threshold[count], rise[count] = u - free, z[j + 1 if j + 1 < z.size else 0] - z[j]
            count += 1
            free = decay.sample * u
    forces, work, _ = weighted_sums(threshold[:count], None, rise[:count], 0.0)
    return work / forces


@kernel
def median_width(z, d, decay, contacts):
    """Return the load-weighted median width of patches, in samples, as body/patch_width.py does."""
    pieces = contacts.ends.shape[0]
    start = 0
    while start < pieces and contacts.ends[start, JOINED] == 1:
        start += 1
    if start == pieces:
        return float(z.size)
    width = np.zeros(pieces, np.int64)
    force = np.zeros(pieces)
    patches = 0
    for k in range(pieces):
        i = start + k if start + k < pieces else start + k - pieces
        patches += 1 - contacts.ends[i, JOINED]
        width[patches - 1] += contacts.ends[i, LEADING] - contacts.ends[i, TRAILING] + 1
        force[patches - 1] += _force_on_piece(z, d, decay, contacts, i)
    widest, half = 0, 0.0
    for p in range(patches):
        widest = max(widest, width[p])
    force_by_width = np.zeros(widest + 1)
    for p in range(patches):
        force_by_width[width[p]] += force[p]
        half += 0.5 * force[p]
    total = 0.0
    for samples in range(force_by_width.size):
        total += force_by_width[samples]
        if total >= half and total > 0.0:
            return float(samples)
    return float(force_by_width.size - 1)


@refcount_free_kernel
def _force_on_piece(z, d, decay, contacts, i):
    """Return sum (w - u) over piece i; inside it, w is E times the u of the sample upstream."""
    trailing = z[contacts.ends[i, TRAILING]] - d
    rest = (1.0 - decay.sample) * contacts.edges[i, DEPTH_SUM]
    return contacts.edges[i, FREE_DISPLACEMENT] - decay.sample * trailing + rest
