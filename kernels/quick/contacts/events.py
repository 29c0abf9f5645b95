"""Steady sliding of Kelvin elements on a smooth line, from event to event.

An element passes the line against the motion. It lands where z - d falls to its free displacement,
and leaves where its pressure d - z + vbar z' (eq. 3) vanishes. Between these events, force and
friction (eqs. 4 and 5) are integrals of polynomials or exponentials. The result is that of the
continuous line, whatever its samples.

The pressure is zero where an element leaves, and its displacement is continuous where it lands.
The derivative of the force with respect to d is therefore that at fixed positions of the events.
"""

import math
from typing import NamedTuple

import numpy as np

from ...compile.jit import inlined_kernel, kernel, refcount_free_kernel
from ...lines.polynomials import septic_coefficients, septic_height, septic_slope
from ...rheology.law import MIN_MAGNITUDE
from ..steady.spans import SPAN
from .smooth_line import SmoothLine, first_zero, integral, pressure, span_of

MAX_EVENTS = 4  # per interval; more would be due to rounding
MIN_EDGE_PRESSURE = 1e-9  # in h: least pressure used as a divisor in GROWTH
LEADING_END, TRAILING_END = 0, 1  # of a patch: where elements land and where they leave
AREA, WIDTH, RISE, GROWTH = 2, 3, 4, 5  # columns of Patches.values; GROWTH + end for each end


class Patches(NamedTuple):
    """The patches of a contact, in the order in which elements reach them."""

    interval: np.ndarray  # shape (most, 2): intervals of both ends, counted from the deepest point
    values: np.ndarray  # shape (most, 7): t of both ends in their intervals, AREA (integral of
    # d - z), WIDTH in dx, RISE (z at the leading end minus z at the trailing end), and GROWTH of
    # both ends: their outward motion, in dx, per change of d


class PatchedContact(NamedTuple):
    """A contact at constant indentation, from one turn round the line; integrals over x in dx."""

    d: float  # indentation, in h
    force: float  # integral of -u
    rate: float  # its derivative with respect to d
    work: float  # integral of (d - z) z' over the contact
    edge_rate: float  # change of the integral of p z' at leading edges per change of d
    patches: int  # their number; the last one continues as the first, across the deepest point


class Turn(NamedTuple):
    """Constants of a turn round the line."""

    line: SmoothLine
    speed: float
    d: float  # indentation
    decay: float  # exponent of the decay of a free displacement over one interval


class TurningElement(NamedTuple):
    """The element between two events, and the present patch up to it."""

    in_contact: bool
    t: float  # position in the present interval
    u: float  # displacement if it is free
    landing: float  # d - z where it last landed
    left_u: float  # displacement where it last left
    left_at: float  # position there, in intervals from the deepest one on
    area: float  # integral of d - z over the present patch so far
    width: float  # of the present patch so far, in dx


class TurnSums(NamedTuple):
    """The fields of PatchedContact, summed over the patches that the element has left."""

    force: float
    rate: float
    work: float
    edge_rate: float
    patches: int


@kernel
def allocate_patches(n):
    """Return Patches with room for as many patches as n intervals can have."""
    most = n * MAX_EVENTS // 2 + 2  # pages that are never written take no memory
    return Patches(np.empty((most, 2), np.int64), np.empty((most, 7)))


@refcount_free_kernel
def turn_line(line, speed, d, patches):
    """Carry an element once round the line at the indentation d; return the PatchedContact.

    Fill ``patches``. The turn begins and ends in contact, at the deepest point, which lies below d.
    Only intervals whose bounds of heights and slopes admit an event are searched for events.
    """
    n, (deepest_interval, deepest_t, deepest) = line.z.size, line.deepest
    turn = Turn(line, speed, d, line.spacing / speed)
    decays = math.exp(-turn.decay), math.exp(-turn.decay * SPAN)
    # i : intervals passed since the deepest one. j : index of the present one.
    i, j, sums = 0, deepest_interval, TurnSums(0.0, 0.0, 0.0, 0.0, 0)
    element = TurningElement(True, deepest_t, 0.0, deepest - d, 0.0, 0.0, 0.0, 0.0)
    begin_patch(patches, 0, 0, deepest_t, 0.0)
    while i <= n:
        in_contact, t, u, landing, left_u, left_at, area, width = element
        if t == 0.0 and in_contact:
            i, j, area, width = _skip_touching(line, speed, d, i, j, area, width)
        elif t == 0.0:
            i, j, u = _skip_free(line, d, decays, i, j, u)
        element = TurningElement(in_contact, t, u, landing, left_u, left_at, area, width)
        element, sums = _pass_interval(turn, i, j, element, sums, patches)
        i, j = i + 1, j - 1 if j > 0 else n - 1
    count, landing = sums.patches, element.landing
    if not element.in_contact:  # by rounding, the element left just before the deepest point
        begin_patch(patches, count, n, deepest_t, 0.0)
        landing = deepest - d
    area, width, rise = element.area, element.width, landing - (deepest - d)
    end_patch(patches, count, n, deepest_t, 0.0, area, width, rise)
    force, rate = sums.force + area, sums.rate + width
    return PatchedContact(d, force, rate, sums.work, sums.edge_rate, count + 1)


@inlined_kernel
def _pass_interval(turn, i, j, element, sums, patches):
    """Return the TurningElement at the start of the next interval, and the TurnSums.

    i : intervals passed since the deepest one. j : index of the present one.
    """
    line, d = turn.line, turn.d
    c = septic_coefficients(line.z, line.slope, line.bend, line.spacing, j)
    stop, fresh = 1.0 if i < line.z.size else line.deepest[1], True
    overlap = (c[0] - d, c[1], c[2], c[3], c[4], c[5], c[6], c[7])
    for _ in range(MAX_EVENTS):
        if element.in_contact:
            p = pressure(c, d, turn.speed / line.spacing)
            zero = first_zero(p, 0.0, 0.0, element.t, stop, True)
            element = _press(turn, overlap, min(zero, stop), element)
            if zero > stop:
                break
            element, sums = _leave(turn, overlap, p, i, zero, element, sums, patches)
            fresh = False
        else:
            zero = first_zero(overlap, element.u, turn.decay, element.t, stop, fresh)
            if zero > stop and i < line.z.size:
                element = _decay(turn, stop, element)
                break
            element, sums = _land(turn, overlap, c, i, min(zero, stop), element, sums, patches)
    in_contact, _, u, landing, left_u, left_at, area, width = element
    return TurningElement(in_contact, 0.0, u, landing, left_u, left_at, area, width), sums


@inlined_kernel
def _press(turn, overlap, end, element):
    """Return the TurningElement after contact up to t = ``end``, where t is not advanced."""
    in_contact, t, u, landing, left_u, left_at, area, width = element
    h = turn.line.spacing
    area, width = area - h * integral(overlap, t, end), width + h * (end - t)
    return TurningElement(in_contact, t, u, landing, left_u, left_at, area, width)


@inlined_kernel
def _decay(turn, stop, element):
    """Return the TurningElement after free decay up to t = ``stop``, where t is not advanced."""
    in_contact, t, u, landing, left_u, left_at, area, width = element
    u = u * math.exp(-turn.decay * (stop - t)) if u < -MIN_MAGNITUDE else 0.0
    return TurningElement(in_contact, t, u, landing, left_u, left_at, area, width)


@inlined_kernel
def _leave(turn, overlap, p, i, t, element, sums, patches):
    """End the patch where the pressure p vanishes, at t; return (TurningElement, TurnSums)."""
    _, _, _, landing, _, _, area, width = element
    u, count = septic_height(overlap, t), sums.patches
    growth = -turn.line.spacing / min(septic_slope(p, t), -MIN_EDGE_PRESSURE)
    end_patch(patches, count, i, t, growth, area, width, landing - u)
    force, rate = sums.force + area, sums.rate + width
    sums = TurnSums(force, rate, sums.work, sums.edge_rate, count + 1)
    return TurningElement(False, t, u, landing, u, i + t, 0.0, 0.0), sums


@inlined_kernel
def _land(turn, overlap, c, i, t, element, sums, patches):
    """Begin a patch where the free element lands, at t; return (TurningElement, TurnSums)."""
    _, _, u, _, left_u, left_at, area, width = element
    force, rate, work, edge_rate, count = sums
    speed, landing = turn.speed, septic_height(overlap, t)
    loss = -math.expm1(-turn.decay * (i + t - left_at))
    rise = -septic_slope(c, t) / turn.line.spacing
    force, rate = force - speed * loss * left_u, rate + speed * loss
    work += 0.5 * left_u * left_u * loss * (2.0 - loss)
    edge_rate += speed * loss * rise
    growth = speed * loss / max(speed * rise - landing, MIN_EDGE_PRESSURE)
    begin_patch(patches, count, i, t, growth)
    sums = TurnSums(force, rate, work, edge_rate, count)
    return TurningElement(True, t, u, landing, left_u, left_at, area, width), sums


@inlined_kernel
def _skip_touching(line, speed, d, i, j, area, width):
    """Return (i, j, area, width) after spans and intervals in which the element stays pressed."""
    n, h, intervals, spans = line.z.size, line.spacing, line.intervals, line.spans
    while i < n:
        b = span_of(j, n - i)
        if b >= 0 and d + speed * spans.min_slope[b] > spans.high[b]:
            area, width = area + (SPAN * h * d - spans.area[b]), width + SPAN * h
            i, j = i + SPAN, b * SPAN - 1 if b > 0 else n - 1
        elif d + speed * intervals.min_slope[j] > intervals.high[j]:
            area, width = area + (h * d - intervals.area[j]), width + h
            i, j = i + 1, j - 1 if j > 0 else n - 1
        else:
            break
    return i, j, area, width


@inlined_kernel
def _skip_free(line, d, decays, i, j, u):
    """Return (i, j, u) after spans and intervals in which the element stays free.

    decays : factors on a free displacement, over an interval and over a span.
    """
    n, intervals, spans = line.z.size, line.intervals, line.spans
    interval_decay, span_decay = decays
    while i < n:
        b = span_of(j, n - i)
        if b >= 0 and spans.low[b] - d >= span_decay * u:
            u = span_decay * u if u < -MIN_MAGNITUDE else 0.0
            i, j = i + SPAN, b * SPAN - 1 if b > 0 else n - 1
        elif intervals.low[j] - d >= interval_decay * u:
            u = interval_decay * u if u < -MIN_MAGNITUDE else 0.0
            i, j = i + 1, j - 1 if j > 0 else n - 1
        else:
            break
    return i, j, u


@inlined_kernel
def begin_patch(patches, k, interval, t, growth):
    """Record the leading end of patch k."""
    patches.interval[k, LEADING_END], patches.values[k, LEADING_END] = interval, t
    patches.values[k, GROWTH + LEADING_END] = growth


@inlined_kernel
def end_patch(patches, k, interval, t, growth, area, width, rise):
    """Record the trailing end of patch k, and its integrals."""
    values = patches.values
    patches.interval[k, TRAILING_END], values[k, TRAILING_END] = interval, t
    values[k, GROWTH + TRAILING_END] = growth
    values[k, AREA], values[k, WIDTH], values[k, RISE] = area, width, rise
