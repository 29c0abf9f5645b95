"""Steady sliding by spans: elements carried round the line, and the indentation under a load.

The result is that of ``sweep`` in model/steady.py, but the force is given as -sum u. In steady
sliding an element ends a period with the displacement it began with, so its dashpot adds nothing
to the mean force. All terms of -sum u have one sign, so the sum is exact to rounding at any speed.

The force F(d) is increasing and convex (model/steady.py): Newton's method from the right stays
right of the root, and a step from the left leads to the right of it. Two steps of Halley's method
come first. They are exact where F is a power of the depth, so they need no good guess.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...model.contact import excess_at, solve_indentation
from ...model.steady import steady_indentation
from ...rheology.law import MIN_MAGNITUDE, free_displacement
from .spans import SPAN, Spans

HALLEY_STEPS = 2
APPROACH_STEPS = 3  # of Halley's and Newton's methods, before those that end the search
LOAD_TOLERANCE = 1e-13  # excess relative to the load, above the rounding of long sums
MAX_ELASTIC_SAMPLES = 512  # approximate size of the subset in elastic_guess


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
def sweep_spans(decay, z, spans, thresholds, d, entered, w):
    """Carry the elements once round the line, from its deepest sample against the motion.

    decay, spans : DecayFactors and Spans of the line z, shape (n,). thresholds : contact thresholds
    of the whole spans. d : indentation, above the deepest sample.
    entered : u of the elements that enter each span and the tail, shape (n // SPAN + 1,), and
    w : free displacements, shape (n,); both are filled unless None.
    Return (-sum u, its derivative with respect to d, number of touching samples).
    """
    n, deepest = z.size, spans.deepest
    u = z[deepest] - d
    rate = 1.0  # -du/dd: 1 in contact, decaying outside
    total, slope, touching = -u, 1.0, 1
    in_contact = True
    for first, last in ((deepest - 1, 0), (n - 1, deepest + 1)):
        j = first
        while j >= last:
            b = j // SPAN
            low = b * SPAN
            if entered is not None and j == min(low + SPAN, n) - 1:
                entered[b] = u
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
            state = u, rate, in_contact, total, slope, touching
            state = _sweep_samples(decay, z, d, j, stop, state, w)
            u, rate, in_contact, total, slope, touching = state
            j = stop - 1
    if entered is not None and (deepest % SPAN == SPAN - 1 or deepest == n - 1):
        entered[deepest // SPAN] = u
    if w is not None:
        w[deepest] = decay.sample * u if u < -MIN_MAGNITUDE else 0.0
    return total, slope, touching


@refcount_free_kernel
def _sweep_samples(decay, z, d, first, stop, state, w):
    """Return the state of a sweep after visiting each sample from ``first`` down to ``stop``."""
    u, rate, in_contact, total, slope, touching = state
    if u >= -MIN_MAGNITUDE:
        u = rate = 0.0
    for j in range(first, stop - 1, -1):
        free = decay.sample * u
        gap = z[np.uint64(j)] - d  # unsigned: no test for a negative index
        if w is not None:
            w[j] = free
        in_contact = gap < free
        if in_contact:
            u = gap
            rate = 1.0
            touching += 1
        else:
            u = free
            rate = decay.sample * rate
        total -= u
        slope += rate
    return u, rate, in_contact, total, slope, touching


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


@kernel
def elastic_guess(z, deepest, load):
    """Return an estimate of d in elastic contact (v -> 0), from some samples. load : n Fbar."""
    stride = max(1, z.size // MAX_ELASTIC_SAMPLES)
    first = deepest % stride
    subset = np.empty((z.size - first + stride - 1) // stride)
    for i in range(subset.size):
        subset[i] = z[first + i * stride]
    share = load / z.size * subset.size
    d, _ = solve_indentation(subset, share, z[deepest] + share / subset.size)
    return d


@refcount_free_kernel
def halley_step(depth, force, rate, load):
    """Return the depth after a step of Halley's method for force = load.

    rate : derivative of the force with respect to the depth. The step is exact where the force is
    a power of the depth, and never overshoots far elsewhere.
    """
    power = depth * rate / force
    up, down = power + 1.0, power - 1.0
    return depth * ((down * force + up * load) / (up * force + down * load))


@kernel
def approach_indentation(decay, z, spans, thresholds, load):
    """Return an estimate of d under the load n Fbar. Other arguments : see sweep_spans."""
    d = elastic_guess(z, spans.deepest, load)
    for step in range(APPROACH_STEPS):
        force, slope, _ = sweep_spans(decay, z, spans, thresholds, d, None, None)
        if step < HALLEY_STEPS:
            deepest = z[spans.deepest]
            d = deepest + halley_step(d - deepest, force, slope, load)
        else:
            d -= (force - load) / slope
    return d


class SpanSliding(NamedTuple):
    """A steadily sliding line swept by spans: arguments of sweep_spans."""

    decay: DecayFactors
    z: np.ndarray
    spans: Spans
    thresholds: np.ndarray
    entered: np.ndarray  # filled


@excess_at.register(SpanSliding)
def _excess_of_span_sliding(contact, load, d):
    decay, z, spans, thresholds, entered = contact
    force, slope, touching = sweep_spans(decay, z, spans, thresholds, d, entered, None)
    return force - load, slope, touching


@kernel
def span_indentation(decay, z, spans, thresholds, load, guess, entered):
    """Return (d, sweeps) of steady sliding under the load n Fbar.

    guess : d from approach_indentation. Other arguments : see sweep_spans.
    """
    sliding = SpanSliding(decay, z, spans, thresholds, entered)
    return steady_indentation(sliding, load, guess, False, z.size, LOAD_TOLERANCE)
