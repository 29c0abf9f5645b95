"""Steady sliding of lines at one speed under many loads: indentations, friction, jumps.

Full contact needs no search. If every element touches, -u = d - z everywhere, and the load
n Fbar = sum (d - z) gives d at any speed. Every element touches if this d lies above all thresholds
t_j of spans.py; in the limit of fine samples, above max (z - vbar z'). The sums of eqs. 4 and 5 are
then those of the whole line.
"""

from typing import NamedTuple

import numpy as np

from ...body.patch_width import samples_per_contact
from ...compile.jit import kernel, refcount_free_kernel
from ...model.friction import (
    contact_samples,
    elastic_correction,
    pressed_friction,
    step_average,
)
from ..steady.span_sliding import (
    APPROACH_STEPS,
    DecayFactors,
    approach_indentation,
    decay_factors,
    span_indentation,
    sweep_spans,
)
from ..steady.spans import SPAN, Spans, Thresholds, pressure_threshold, spans_in, thresholds_of

# Columns of LoadTable.table: d over the deepest sample (h), mu (h/dx), share of the line in
# contact, samples per contact, sweeps, whether the whole line touches, and whether it remains
# pressed after all jumps.
LOAD_COLUMNS = 7
(
    D_COLUMN,
    MU_COLUMN,
    CONTACT_COLUMN,
    WIDTH_COLUMN,
    SWEEPS_COLUMN,
    FULL_COLUMN,
    PRESSED_COLUMN,
) = range(LOAD_COLUMNS)


class SlidingLine(NamedTuple):
    """A line that slides steadily, whose velocity jumps to other speeds."""

    decay: DecayFactors
    z: np.ndarray  # in h, shape (n,)
    slope: np.ndarray  # in h/dx, shape (n,)
    spans: Spans
    thresholds: Thresholds
    speed: float  # vbar
    others: np.ndarray  # speeds after the jumps, vbar, shape (others,)


class LoadTable(NamedTuple):
    """Results for each load; those for several lines have a leading axis of lines."""

    table: np.ndarray  # shape (..., loads, LOAD_COLUMNS)
    jumps: np.ndarray  # shape (..., loads, others): change of mu at the jumps to other speeds
    rates: np.ndarray  # shape (..., loads, others): d' just after them
    entered: np.ndarray  # shape (..., loads, spans + 1), u of elements that enter each span


class FrictionOptions(NamedTuple):
    """Options of the quadrature of friction."""

    steps: float  # samples per spacing
    elastic_share: float  # share of the elastic part that is corrected
    band_limited: bool  # whether the line has no modes above q = pi/dx
    followed: bool  # whether to compute d alone in partial contact, which is followed later


@kernel
def slide_on_lines(law, stack, speed, others, loads, options):
    """Return (contact thresholds of the spans, DecayFactors, LoadTable) of a Stack of lines.

    law : for steps of one sample. speed, others : of sliding and after jumps, vbar. loads : n Fbar.
    The thresholds have the shape (lines, spans).
    """
    (lines, n), decay = stack.z.shape, decay_factors(law)
    table, contact = np.empty((lines, loads.size, LOAD_COLUMNS)), np.empty((lines, n // SPAN))
    shape = lines, loads.size, others.size
    jumps, rates = np.empty(shape), np.empty(shape)
    entered = np.zeros((lines, loads.size, n // SPAN + 1))  # the last stays 0 without a tail
    for k in range(lines):
        z, slope, spans = stack.z[k], stack.slope[k], spans_in(stack, k)
        thresholds = thresholds_of(z, law.stiffness)
        line = SlidingLine(decay, z, slope, spans, thresholds, speed, others)
        results = LoadTable(table[k], jumps[k], rates[k], entered[k])
        slide_under_loads(line, loads, options, results)
        for b in range(thresholds.contact.size):
            contact[k, b] = thresholds.contact[b]
    return contact, decay, LoadTable(table, jumps, rates, entered)


@kernel
def slide_under_loads(line, loads, options, results):
    """Fill ``results``, a LoadTable, for a SlidingLine under all loads, n Fbar."""
    decay, z, _, spans, thresholds, _, _ = line
    n, w, table = z.size, np.empty(z.size), results.table
    for i in range(loads.size):
        load, entered, sweeps = loads[i], results.entered[i], 0
        d = load / n + (z[0] + spans.line_sums[0] / n)
        full = d > thresholds.line_contact
        if not full:
            contact = thresholds.contact
            near = approach_indentation(decay, z, spans, contact, load)
            d, sweeps = span_indentation(decay, z, spans, contact, load, near, entered)
            sweeps += APPROACH_STEPS
        row, jumps, rates, pressed = table[i], results.jumps[i], results.rates[i], False
        if full:
            _enter_touching(z, d, entered)
            pressed = _press_whole_line(line, load, options, row, jumps, rates)
        row[D_COLUMN], row[SWEEPS_COLUMN] = d, sweeps
        row[FULL_COLUMN], row[PRESSED_COLUMN] = full, pressed
        if (options.followed and not pressed) or (pressed and not _misses_sign(options, row)):
            continue
        sweep_spans(decay, z, spans, thresholds.contact, d, None, w)
        if not pressed:
            _press_contact(line, w, d, load, options, row, jumps, rates)
        if _misses_sign(options, row):
            row[MU_COLUMN] = options.steps * _mean_rise(z, w, d)


@refcount_free_kernel
def _misses_sign(options, row):
    """Return whether rounding or coarse samples hide the sign of mu, which is positive."""
    return options.band_limited and row[MU_COLUMN] <= 0.0


@refcount_free_kernel
def _enter_touching(z, d, entered):
    """Fill ``entered`` for a line that touches everywhere."""
    for b in range(entered.size):
        upstream = (b + 1) * SPAN
        entered[b] = z[upstream if upstream < z.size else 0] - d


@kernel
def _press_whole_line(line, load, options, row, jumps, rates):
    """Fill the results under a load if the line is pressed everywhere, also after all jumps.

    Return whether it is. The mean of the pressures p = (d + d') - z + vbar z' is load / n.
    """
    z, slope, speed = line.z, line.slope, line.speed
    mu, elastic, deep = _whole_line_friction(line, speed, load)
    pressed = deep > pressure_threshold(z, slope, speed)
    for k in range(line.others.size):
        mu_after, _, deep_after = _whole_line_friction(line, line.others[k], load)
        pressed = pressed and deep_after > pressure_threshold(z, slope, line.others[k])
        jumps[k], rates[k] = mu_after - mu, deep_after - deep
    if pressed:
        # The exact elastic part vanishes over a whole period.
        row[MU_COLUMN] = mu - options.elastic_share / load * elastic
        row[CONTACT_COLUMN], row[WIDTH_COLUMN] = 1.0, z.size
    return pressed


@refcount_free_kernel
def _whole_line_friction(line, speed, load):
    """Return (mu, elastic part of the sum of p z', d + d') of a line pressed everywhere.

    The elastic part is the sum of (d + d' - z) z'.
    """
    z, slope = line.z[0], line.slope[0]  # the reference of the sums
    height, rise, work, square = line.spans.line_sums
    n = line.z.size
    p = load / n + (height - speed * rise) / n
    mu = slope + (p * rise - (work - speed * square)) / load
    depth = p - speed * slope  # d + d' over the first sample
    elastic = depth * rise - work + slope * (n * depth - height)
    return mu, elastic, p + (z - speed * slope)


@kernel
def _press_contact(line, w, d, load, options, row, jumps, rates):
    """Fill the results of the steady state (w, d) under a load by the quadrature of its samples."""
    z, slope, speed, n = line.z, line.slope, line.speed, line.z.size
    touching = contact_samples(z, slope, w, d, speed)
    mu, rate, count = pressed_friction(touching, speed, load)
    for k in range(line.others.size):
        mu_after, rate_after, _ = pressed_friction(touching, line.others[k], load)
        jumps[k], rates[k] = mu_after - mu, rate_after - rate  # errors of the elastic part cancel
    if options.elastic_share > 0.0:
        missing = elastic_correction(z, slope, w, d, speed, rate, options.steps)
        # mu is a mean of slopes, so the steepest bounds it if a contact is narrower than a sample.
        steepest = 0.0
        for s in touching.slope:
            steepest = max(steepest, abs(s))
        mu = min(max(mu + options.elastic_share / load * missing, -steepest), steepest)
    row[MU_COLUMN], row[CONTACT_COLUMN] = mu, min(count / n, 1.0)  # two edges can overlap
    overlap = np.empty(n)
    for j in range(n):
        overlap[j] = d - (z[j] - w[j])
    row[WIDTH_COLUMN] = samples_per_contact(overlap)


@kernel
def _mean_rise(z, w, d):
    """Return the force-weighted mean of the rise of the line per step, over its contacts.

    It gives mu from the work of the forces as the line rises. w : free displacements.
    """
    rise, c = np.empty(z.size), np.empty(z.size)
    for j in range(z.size):
        rise[j], c[j] = z[j + 1 if j + 1 < z.size else 0] - z[j], z[j] - w[j]
    return step_average(rise, c, d)
