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
from .smooth_line import first_zero, integral, pressure, span_of

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
    z, slope, bend, h, _, _, (deepest_interval, deepest_t, deepest) = line
    # i : intervals passed since the deepest one. j : index of the present one. t : position in it.
    n, decay, i, j, t, count = z.size, h / speed, 0, deepest_interval, deepest_t, 0
    decays = math.exp(-decay), math.exp(-decay * SPAN)
    force = rate = work = edge_rate = 0.0
    area = width = u = left_u = left_at = 0.0
    in_contact, landing = True, deepest - d
    begin_patch(patches, 0, 0, deepest_t, 0.0)
    while i <= n:
        if t == 0.0 and in_contact:
            i, j, area, width = _skip_touching(line, speed, d, i, j, area, width)
        elif t == 0.0:
            i, j, u = _skip_free(line, d, decays, i, j, u)
        c = septic_coefficients(z, slope, bend, h, j)
        stop, fresh = 1.0 if i < n else deepest_t, True
        overlap = (c[0] - d, c[1], c[2], c[3], c[4], c[5], c[6], c[7])
        for _ in range(MAX_EVENTS):
            if in_contact:
                p = pressure(c, d, speed / h)
                zero = first_zero(p, 0.0, 0.0, t, stop, True)
                end = min(zero, stop)
                area, width = area - h * integral(overlap, t, end), width + h * (end - t)
                if zero > stop:
                    break
                t, in_contact, fresh, u = zero, False, False, septic_height(overlap, zero)
                left_u, left_at = u, i + t
                growth = -h / min(septic_slope(p, t), -MIN_EDGE_PRESSURE)
                end_patch(patches, count, i, t, growth, area, width, landing - u)
                force, rate, count = force + area, rate + width, count + 1
                area = width = 0.0
            else:
                zero = first_zero(overlap, u, decay, t, stop, fresh)
                if zero > stop and i < n:
                    u = u * math.exp(-decay * (stop - t)) if u < -MIN_MAGNITUDE else 0.0
                    break
                t, in_contact = min(zero, stop), True
                landing = septic_height(overlap, t)
                loss = -math.expm1(-decay * (i + t - left_at))
                rise = -septic_slope(c, t) / h
                force, rate = force - speed * loss * left_u, rate + speed * loss
                work += 0.5 * left_u * left_u * loss * (2.0 - loss)
                edge_rate += speed * loss * rise
                growth = speed * loss / max(speed * rise - landing, MIN_EDGE_PRESSURE)
                begin_patch(patches, count, i, t, growth)
        i, j, t = i + 1, j - 1 if j > 0 else n - 1, 0.0
    if not in_contact:  # by rounding, the element left just before the deepest point
        begin_patch(patches, count, n, deepest_t, 0.0)
        landing = deepest - d
    end_patch(patches, count, n, deepest_t, 0.0, area, width, landing - (deepest - d))
    return PatchedContact(d, force + area, rate + width, work, edge_rate, count + 1)


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
