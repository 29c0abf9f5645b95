"""Steady sliding on lines of as many samples, all in one call from Python."""

import numpy as np

from ...compile.jit import kernel
from ..steady.carry import decay_of
from ..steady.spans import SPAN
from ..steady.stack import spans_in
from ..steady.thresholds import presses_at, thresholds_of
from .loads import Found, Speeds, slide


@kernel
def slide_on(law, stack, at_speeds, loads, how):
    """Return (largest thresholds of contact of the spans, the Decay, Found).

    law : for steps of one sample. at_speeds : own and others, vbar. loads : as of slide. The
    thresholds are those of Thresholds, shape (lines, spans).
    """
    speed, others = at_speeds
    lines, n = stack.z.shape
    decay = decay_of(law)
    found, stay = _room(lines, n, loads, others), np.empty((lines, n // SPAN))
    for k in range(lines):
        z, slope = stack.z[k], stack.slope[k]
        own = thresholds_of(z, slope, speed, law.stiffness)
        speeds = Speeds(speed, own, others, presses_at(z, slope, others))
        into = _of_line(found, k)
        slide(decay, z, slope, spans_in(stack, k), speeds, loads, how, into)
        for b in range(own.stay.size):
            stay[k, b] = own.stay[b]
    return stay, decay, found


@kernel
def _room(lines, samples, loads, others):
    """Return Found of so many lines, empty."""
    shape = lines, loads.size, others.size
    return Found(
        np.empty((lines, loads.size, 7)),
        np.empty(shape),
        np.empty(shape),
        np.empty((lines, loads.size, samples // SPAN + 1)),
    )


@kernel
def _of_line(found, k):
    """Return what is found of line k: rows of all."""
    return Found(found.table[k], found.jumps[k], found.rates[k], found.entered[k])
