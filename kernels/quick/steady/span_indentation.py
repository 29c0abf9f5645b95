"""Indentation of steady sliding under a load, found with sweeps by spans.

The force F(d) is increasing and convex (model/steady.py): Newton's method from the right stays
right of the root, and a step from the left leads to the right of it. Two steps of Halley's method
come first. They are exact where F is a power of the depth, so they need no good guess. The final
sweeps list the contacts.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...model.contact import excess_at, solve_indentation
from ...model.steady import steady_indentation
from .contact_pieces import ContactPieces
from .span_sweep import DecayFactors, sweep_spans
from .spans import Spans

HALLEY_STEPS = 2
APPROACH_STEPS = 3  # of Halley's and Newton's methods, before contacts are listed
LOAD_TOLERANCE = 1e-13  # excess relative to the load, above the rounding of long sums
MAX_ELASTIC_SAMPLES = 512  # approximate size of the subset in elastic_guess


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
        force, slope, _, _ = sweep_spans(decay, z, spans, thresholds, d, None, None)
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
    contacts: ContactPieces  # filled
    pieces: np.ndarray  # number of pieces of contact, shape (1,): filled


@excess_at.register(SpanSliding)
def _excess_of_span_sliding(contact, load, d):
    decay, z, spans, thresholds, contacts, pieces = contact
    force, slope, touching, pieces[0] = sweep_spans(decay, z, spans, thresholds, d, contacts, None)
    return force - load, slope, touching


@kernel
def span_indentation(decay, z, spans, thresholds, load, guess, contacts):
    """Return (d, sweeps, pieces) of steady sliding under the load n Fbar.

    guess : d from approach_indentation. contacts : ContactPieces; the first ``pieces`` are filled.
    Other arguments : see sweep_spans.
    """
    sliding = SpanSliding(decay, z, spans, thresholds, contacts, np.zeros(1, np.int64))
    d, sweeps = steady_indentation(sliding, load, guess, False, z.size, LOAD_TOLERANCE)
    return d, sweeps, sliding.pieces[0]
