"""Steady sliding on lines with equally many samples, in one call from Python."""

import numpy as np

from ...compile.jit import kernel
from ..steady.span_sweep import decay_factors
from ..steady.spans import SPAN
from ..steady.stack import spans_in
from ..steady.thresholds import pressure_thresholds_at, thresholds_of
from .loads import LOAD_COLUMNS, LoadTable, SpeedThresholds, slide_under_loads


@kernel
def slide_on_lines(law, stack, speed, others, loads, options):
    """Return (thresholds of contact of the spans, DecayFactors, LoadTable).

    law : for steps of one sample. speed, others : of sliding and after jumps, vbar. loads : n Fbar.
    The thresholds have the shape (lines, spans).
    """
    lines, n = stack.z.shape
    decay = decay_factors(law)
    results, contact = _allocate(lines, n, loads, others), np.empty((lines, n // SPAN))
    for k in range(lines):
        z, slope = stack.z[k], stack.slope[k]
        thresholds = thresholds_of(z, slope, speed, law.stiffness)
        speeds = SpeedThresholds(
            speed, thresholds, others, pressure_thresholds_at(z, slope, others)
        )
        slide_under_loads(
            decay, z, slope, spans_in(stack, k), speeds, loads, options, _of_line(results, k)
        )
        for b in range(thresholds.contact.size):
            contact[k, b] = thresholds.contact[b]
    return contact, decay, results


@kernel
def _allocate(lines, samples, loads, others):
    """Return an empty LoadTable of several lines."""
    shape = lines, loads.size, others.size
    return LoadTable(
        np.empty((lines, loads.size, LOAD_COLUMNS)),
        np.empty(shape),
        np.empty(shape),
        np.empty((lines, loads.size, samples // SPAN + 1)),
    )


@kernel
def _of_line(results, k):
    """Return the LoadTable of line k, as views."""
    return LoadTable(results.table[k], results.jumps[k], results.rates[k], results.entered[k])
