"""One sweep of steady sliding by spans: elements carried round the line at constant indentation.

The result is that of ``sweep`` in model/steady.py, but the force is given as -sum u. In steady
sliding an element ends a period with the displacement it began with, so its dashpot adds nothing
to the mean force. All terms of -sum u have one sign, so the sum is exact to rounding at any speed.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...rheology.law import MIN_MAGNITUDE, free_displacement
from .contact_pieces import (
    begin_depth_sum,
    close_piece,
    end_depth_sum,
    join_pieces,
    open_piece,
    record_entry,
)
from .spans import SPAN


class DecayFactors(NamedTuple):
    """Factors by which a free displacement decays on the way downstream."""

    sample: float  # over one sample, E
    span: float  # over a span
    span_sum: float  # sum of the factors at the samples of a span


@kernel
def decay_factors(law):
    """Return the DecayFactors of a law whose elements remember only u."""
    sample = free_displacement(law, 1.0)
    span, span_sum = 1.0, 0.0
    for _ in range(SPAN):
        span *= sample if span > MIN_MAGNITUDE else 0.0
        span_sum += span
    return DecayFactors(sample, span, span_sum)


@refcount_free_kernel
def sweep_spans(decay, z, spans, thresholds, d, contacts, w):
    """Carry the elements once round the line, from its deepest sample against the motion.

    decay, spans : DecayFactors and Spans of the line z, shape (n,). thresholds : contact thresholds
    of the whole spans (thresholds.py). d : indentation, above the deepest sample.
    contacts : ContactPieces to fill, or None. w : free displacements to fill, shape (n,), or None.
    Return (-sum u, its derivative with respect to d, touching samples, pieces of contact).
    """
    n, deepest = z.size, spans.deepest
    u = z[deepest] - d
    rate = 1.0  # -du/dd: 1 in contact, decaying outside
    total, slope, touching, pieces = -u, 1.0, 1, 1
    in_contact = True
    begin_depth_sum(contacts, 0, 0.0)
    for first, last in ((deepest - 1, 0), (n - 1, deepest + 1)):
        j = first
        if j == n - 1 and in_contact:
            pieces = _cut_at_array_end(contacts, pieces, z, d, j, last, decay.sample * u, total)
        while j >= last:
            b = j // SPAN
            low = b * SPAN
            if j == min(low + SPAN, n) - 1:
                record_entry(contacts, b, u)
            if j == low + SPAN - 1 and low >= last:
                left = decay.span * u if u < -MIN_MAGNITUDE else 0.0
                if in_contact and d > thresholds[b]:
                    _fill_touching_span(decay, z, d, u, w, low)
                    u = spans.first_height[b] - d
                    total -= SPAN * u + spans.height_sum[b]
                    slope += SPAN
                    touching += SPAN
                    j -= SPAN
                    continue
                if not in_contact and spans.lowest[b] - d >= left:
                    _fill_free_span(decay, u, w, low)
                    total -= decay.span_sum * u
                    slope += decay.span_sum * rate
                    rate = decay.span * rate if u < -MIN_MAGNITUDE else 0.0
                    u = left
                    j -= SPAN
                    continue
            stop = max(low, last)
            state = u, rate, in_contact, total, slope, touching, pieces
            state = _sweep_samples(decay, z, d, j, stop, state, contacts, w)
            u, rate, in_contact, total, slope, touching, pieces = state
            j = stop - 1
    if in_contact:
        end_depth_sum(contacts, pieces - 1, total)
    _close_period(decay, z, d, spans.deepest, u, in_contact, pieces, contacts, w)
    return total, slope, touching, pieces


@refcount_free_kernel
def _sweep_samples(decay, z, d, first, stop, state, contacts, w):
    """Return the state of a sweep after visiting each sample from ``first`` down to ``stop``."""
    u, rate, in_contact, total, slope, touching, pieces = state
    if u >= -MIN_MAGNITUDE:
        u = rate = 0.0
    for j in range(first, stop - 1, -1):
        free = decay.sample * u
        gap = z[np.uint64(j)] - d  # unsigned: no test for a negative index
        if w is not None:
            w[j] = free
        if gap < free:
            if not in_contact:
                open_piece(contacts, pieces, z, d, j, free, u)
                begin_depth_sum(contacts, pieces, total)
                pieces += 1
                in_contact = True
            u = gap
            rate = 1.0
            touching += 1
        else:
            if in_contact:
                close_piece(contacts, pieces - 1, z, d, j)
                end_depth_sum(contacts, pieces - 1, total)
                in_contact = False
            u = free
            rate = decay.sample * rate
        total -= u
        slope += rate
    return u, rate, in_contact, total, slope, touching, pieces


@refcount_free_kernel
def _cut_at_array_end(contacts, pieces, z, d, j, last, free, total):
    """Cut a patch that continues across the end of the array; return the number of pieces."""
    if last <= j and z[j] - d < free:
        join_pieces(contacts, pieces - 1, pieces, 0, j, free)
        end_depth_sum(contacts, pieces - 1, total)
        begin_depth_sum(contacts, pieces, total)
        return pieces + 1
    return pieces


@refcount_free_kernel
def _close_period(decay, z, d, deepest, u, in_contact, pieces, contacts, w):
    """End the sweep at the deepest sample, where the first piece begins."""
    if deepest % SPAN == SPAN - 1 or deepest == z.size - 1:
        record_entry(contacts, deepest // SPAN, u)
    free = decay.sample * u if u < -MIN_MAGNITUDE else 0.0
    if w is not None:
        w[deepest] = free
    if in_contact:
        upstream = deepest + 1 if deepest + 1 < z.size else 0
        join_pieces(contacts, pieces - 1, 0, upstream, deepest, free)
    else:
        open_piece(contacts, 0, z, d, deepest, free, u)


@refcount_free_kernel
def _fill_touching_span(decay, z, d, u, w, low):
    """Fill w, unless it is None, over a span that touches everywhere and is entered with u."""
    if w is not None:
        for j in range(low, low + SPAN - 1):
            w[j] = decay.sample * (z[j + 1] - d)
        w[low + SPAN - 1] = decay.sample * u


@refcount_free_kernel
def _fill_free_span(decay, u, w, low):
    """Fill w, unless it is None, over a span that touches nowhere and is entered with u."""
    if w is not None:
        for j in range(low + SPAN - 1, low - 1, -1):
            u = decay.sample * u if u < -MIN_MAGNITUDE else 0.0
            w[j] = u
