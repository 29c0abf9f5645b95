"""One sweep of steady sliding by spans: elements carried round the line at constant indentation.

It does what sweep of model/steady.py does, and gives the force as -sum u: in steady sliding the
displacement of an element at the end of a period is that at its beginning, so its dashpot adds
nothing to the mean. That sum has terms of one sign: it is known to rounding, at any speed.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...rheology.law import MIN_MAGNITUDE, free_displacement
from .contacts import begin_sum, end_sum, enter_span, join_pieces, leave_piece, open_piece
from .spans import SPAN


class Decay(NamedTuple):
    """What is left of a displacement upstream."""

    once: float  # after one sample, E
    span: float  # after a span
    within: float  # the sum of what is left at the samples of a span


@kernel
def decay_of(law):
    """Return the Decay of a law whose elements remember u alone."""
    once = free_displacement(law, 1.0)
    span, within = 1.0, 0.0
    for _ in range(SPAN):
        span *= once if span > MIN_MAGNITUDE else 0.0
        within += span
    return Decay(once, span, within)


@refcount_free_kernel
def carry(decay, z, spans, stay, d, contacts, w):
    """Carry the elements once round the line, from its deepest sample against the motion.

    decay, spans, stay : Decay, Spans and largest thresholds (spans.py) of the line z, shape (n,).
    d : indentation, which reaches the deepest sample. contacts : filled, or None. w : free
    displacements, shape (n,), filled, or None.
    Return (-sum u, its derivative with respect to d, touching samples, pieces of contact).
    """
    n, deepest = z.size, spans.deepest
    u = z[deepest] - d
    du = 1.0  # -du/dd: 1 in contact, decaying outside
    total, slope, touching, pieces = -u, 1.0, 1, 1
    held = True
    begin_sum(contacts, 0, 0.0)
    for first, last in ((deepest - 1, 0), (n - 1, deepest + 1)):
        j = first
        if j == n - 1 and held:
            pieces = _cut(contacts, pieces, z, d, j, last, decay.once * u, total)
        while j >= last:
            b = j // SPAN
            low = b * SPAN
            if j == min(low + SPAN, n) - 1:
                enter_span(contacts, b, u)
            if j == low + SPAN - 1 and low >= last:
                left = decay.span * u if u < -MIN_MAGNITUDE else 0.0
                if held and d > stay[b]:
                    _hold(decay, z, d, u, w, low)
                    u = spans.first[b] - d
                    total -= SPAN * u + spans.height[b]
                    slope += SPAN
                    touching += SPAN
                    j -= SPAN
                    continue
                if not held and spans.lowest[b] - d >= left:
                    _release(decay, u, w, low)
                    total -= decay.within * u
                    slope += decay.within * du
                    du = decay.span * du if u < -MIN_MAGNITUDE else 0.0
                    u = left
                    j -= SPAN
                    continue
            stop = max(low, last)
            element = u, du, held, total, slope, touching, pieces
            element = _samples(decay, z, d, j, stop, element, contacts, w)
            u, du, held, total, slope, touching, pieces = element
            j = stop - 1
    if held:
        end_sum(contacts, pieces - 1, total)
    _arrive(decay, z, d, spans.deepest, u, held, pieces, contacts, w)
    return total, slope, touching, pieces


@refcount_free_kernel
def _samples(decay, z, d, first, stop, element, contacts, w):
    """Carry elements from sample ``first`` down to ``stop``, one by one, as carry does."""
    u, du, held, total, slope, touching, pieces = element
    if u >= -MIN_MAGNITUDE:
        u = du = 0.0
    for j in range(first, stop - 1, -1):
        free = decay.once * u
        gap = z[np.uint64(j)] - d  # an index that is never counted from the end
        if w is not None:
            w[j] = free
        if gap < free:
            if not held:
                open_piece(contacts, pieces, z, d, j, free, u)
                begin_sum(contacts, pieces, total)
                pieces += 1
                held = True
            u = gap
            du = 1.0
            touching += 1
        else:
            if held:
                leave_piece(contacts, pieces - 1, z, d, j)
                end_sum(contacts, pieces - 1, total)
                held = False
            u = free
            du = decay.once * du
        total -= u
        slope += du
    return u, du, held, total, slope, touching, pieces


@refcount_free_kernel
def _cut(contacts, pieces, z, d, j, last, free, total):
    """Cut a patch that goes on at the end of the array; return the number of pieces."""
    if last <= j and z[j] - d < free:
        join_pieces(contacts, pieces - 1, pieces, 0, j, free)
        end_sum(contacts, pieces - 1, total)
        begin_sum(contacts, pieces, total)
        return pieces + 1
    return pieces


@refcount_free_kernel
def _arrive(decay, z, d, deepest, u, held, pieces, contacts, w):
    """Come back to the deepest sample, with which the first piece begins."""
    if deepest % SPAN == SPAN - 1 or deepest == z.size - 1:
        enter_span(contacts, deepest // SPAN, u)
    free = decay.once * u if u < -MIN_MAGNITUDE else 0.0
    if w is not None:
        w[deepest] = free
    if held:
        above = deepest + 1 if deepest + 1 < z.size else 0
        join_pieces(contacts, pieces - 1, 0, above, deepest, free)
    else:
        open_piece(contacts, 0, z, d, deepest, free, u)


@refcount_free_kernel
def _hold(decay, z, d, u, w, low):
    """Fill w, if it is given, over a span that is all in contact, entered with u."""
    if w is not None:
        for j in range(low, low + SPAN - 1):
            w[j] = decay.once * (z[j + 1] - d)
        w[low + SPAN - 1] = decay.once * u


@refcount_free_kernel
def _release(decay, u, w, low):
    """Fill w, if it is given, over a span that is all free, entered with u."""
    if w is not None:
        for j in range(low + SPAN - 1, low - 1, -1):
            u = decay.once * u if u < -MIN_MAGNITUDE else 0.0
            w[j] = u
