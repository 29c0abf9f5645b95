"""Steady sliding of lines at one speed under many loads: indentations, friction, jumps.

Full contact needs no search. If every element touches, -u = d - z everywhere, and the load
n Fbar = sum (d - z) gives d at any speed. Every element touches if this d lies above all thresholds
t_j of spans.py; in the limit of fine samples, above max (z - vbar z'). The sums of eqs. 4 and 5 are
then those of the whole line.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...model.contact import indentation_under
from ..steady.contact_pieces import (
    JOINED,
    LEADING,
    LEADING_REACH,
    TRAILING,
    TRAILING_REACH,
    allocate_pieces,
    first_pieces,
)
from ..steady.span_indentation import APPROACH_STEPS, approach_indentation, span_indentation
from ..steady.span_sweep import decay_factors
from ..steady.spans import SPAN
from ..steady.stack import spans_in
from ..steady.thresholds import Thresholds, pressure_thresholds_at, thresholds_of
from .pressed_samples import MovingLine, allocate_pressed, press_contact
from .pressure import contact_friction, elastic_part, whole_line_friction
from .touching_samples import (
    allocate_touching,
    largest_slope,
    list_touching,
    mean_rise,
    median_width,
)

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


class SpeedThresholds(NamedTuple):
    """Speeds of steady sliding and after jumps, with their thresholds."""

    speed: float  # vbar
    thresholds: Thresholds  # at ``speed``
    others: np.ndarray  # after the jumps, vbar, shape (others,)
    pressure: np.ndarray  # shape (others, spans + 1): pressure_thresholds at the other speeds


class LoadTable(NamedTuple):
    """Results for each load; those for several lines have a leading axis of lines."""

    table: np.ndarray  # shape (..., loads, LOAD_COLUMNS)
    jumps: np.ndarray  # shape (..., loads, others): change of mu at the jumps to other speeds
    rates: np.ndarray  # shape (..., loads, others): d' just after them
    entered: np.ndarray  # shape (..., loads, spans + 1), see ContactPieces


class FrictionOptions(NamedTuple):
    """Options of the quadrature of friction."""

    steps: float  # samples per spacing
    elastic_share: float  # share of the elastic part that is corrected
    band_limited: bool  # whether the line has no modes above q = pi/dx
    followed: bool  # whether to compute d alone in partial contacts, which are followed later


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
    entered = np.empty((lines, loads.size, n // SPAN + 1))
    for k in range(lines):
        z, slope, spans = stack.z[k], stack.slope[k], spans_in(stack, k)
        thresholds = thresholds_of(z, slope, speed, law.stiffness)
        after = pressure_thresholds_at(z, slope, others)
        speeds = SpeedThresholds(speed, thresholds, others, after)
        results = LoadTable(table[k], jumps[k], rates[k], entered[k])
        slide_under_loads(decay, z, slope, spans, speeds, loads, options, results)
        for b in range(thresholds.contact.size):
            contact[k, b] = thresholds.contact[b]
    return contact, decay, LoadTable(table, jumps, rates, entered)


@kernel
def slide_under_loads(decay, z, slope, spans, speeds, loads, options, results):
    """Fill ``results``, a LoadTable, for steady sliding of one line under all loads.

    decay, spans : DecayFactors of the law and Spans of the line. loads : n Fbar.
    """
    n, thresholds = z.size, speeds.thresholds
    contacts = allocate_pieces(slope, speeds.speed)
    rooms = allocate_touching(n), allocate_pressed(n)
    table, jumps, rates, entered = results
    for i in range(loads.size):
        load, pieces, sweeps = loads[i], 1, 0
        d = load / n + (z[0] + spans.line_sums[0] / n)
        full = d > thresholds.line_contact
        if full:
            _list_whole_line(z, d, contacts)
        else:
            near = approach_indentation(decay, z, spans, thresholds.contact, load)
            d, sweeps, pieces = span_indentation(
                decay, z, spans, thresholds.contact, load, near, contacts
            )
            sweeps += APPROACH_STEPS
        listed = first_pieces(contacts, pieces)
        for b in range(contacts.entered.size):
            entered[i, b] = contacts.entered[b]
        table[i, D_COLUMN], table[i, SWEEPS_COLUMN], table[i, FULL_COLUMN] = d, sweeps, full
        table[i, PRESSED_COLUMN] = False
        if options.followed and not full:
            continue
        line = MovingLine(z, slope, spans, speeds.speed, thresholds.pressure)
        mu, contact, least = _sampled_friction(
            line, speeds, listed, load, d, full, options, rooms, jumps[i], rates[i]
        )
        if options.band_limited and mu <= 0.0:
            # The true mu is positive: compute it from the work of the forces as the line rises.
            mu = options.steps * mean_rise(z, d, decay, listed)
        table[i, MU_COLUMN] = mu
        table[i, CONTACT_COLUMN] = min(contact / n, 1.0)  # edges of two contacts can overlap
        table[i, WIDTH_COLUMN] = median_width(z, d, decay, listed)
        table[i, PRESSED_COLUMN] = full and least == n


@kernel
def _sampled_friction(line, speeds, contacts, load, d, full, options, rooms, jumps, rates):
    """Return (mu, number of pressed samples, its minimum before and after all jumps) at d.

    Fill ``jumps`` and ``rates``.
    """
    touching = list_touching(line.z, line.slope, contacts, rooms[0])
    pressed = press_contact(line, touching, d, rooms[1])
    mu, contact, deep = _friction(pressed, full, speeds.thresholds.line_pressure, load, d)
    least = contact
    missing = 0.0
    if options.elastic_share > 0.0:
        missing = elastic_part(pressed, contacts, deep, options.steps)
    for k in range(speeds.others.size):
        after = MovingLine(line.z, line.slope, line.spans, speeds.others[k], speeds.pressure[k])
        pressed_after = press_contact(after, touching, deep, rooms[1])
        mu_after, count, deep_after = _friction(
            pressed_after, full, speeds.pressure[k, -1], load, deep
        )
        least = min(least, count)
        jumps[k], rates[k] = mu_after - mu, deep_after - deep  # errors of the elastic part cancel
    if options.elastic_share > 0.0:
        # mu is a mean of slopes, so the steepest bounds it if a contact is narrower than a sample.
        limit = largest_slope(line.spans, touching)
        mu = min(max(mu + options.elastic_share / load * missing, -limit), limit)
    return mu, contact, least


@refcount_free_kernel
def _list_whole_line(z, d, contacts):
    """Record the whole line as one piece of contact."""
    contacts.ends[0, LEADING], contacts.ends[0, TRAILING] = z.size - 1, 0
    contacts.ends[0, JOINED] = 1
    contacts.edges[0, LEADING_REACH] = contacts.edges[0, TRAILING_REACH] = 0.5
    for b in range(contacts.entered.size):
        upstream = (b + 1) * SPAN
        contacts.entered[b] = z[upstream if upstream < z.size else 0] - d


@refcount_free_kernel
def _friction(contact, full, line_threshold, load, guess):
    """Return (mu, number of pressed samples, d + d').

    line_threshold : largest pressure threshold of the line. guess : of d + d'.
    """
    if full:
        z, slope, spans, speed, _ = contact.line
        mu, deep = whole_line_friction(z, slope, spans, speed, load)
        if deep > line_threshold:
            return mu, float(z.size), deep
    deep, _ = indentation_under(contact, load, guess)
    mu, count = contact_friction(contact, deep)
    return mu, count, deep
