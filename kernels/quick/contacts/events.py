"""Steady sliding of Kelvin elements on a smooth line, from event to event.

Against the motion an element lands where the line comes down to its free displacement, and leaves
where its pressure d - z + vbar z' (eq. 3) vanishes. Between these events forces and friction (eqs.
4 and 5) are integrals in closed form: what is found is that of the line, whatever its samples.

Where an element leaves, its pressure is zero, and where it lands, its displacement is continuous.
So the force has the derivative with respect to d that it would have if the events stayed in place.
"""

import math
from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...lines.polynomials import septic_coefficients, septic_height, septic_slope
from ...rheology.law import MIN_MAGNITUDE
from ..steady.spans import SPAN
from .smooth_line import first_zero, integral, pressure, span_of

MOST_EVENTS = 4  # in an interval: more are rounding
LEAST = 1e-9  # of h: pressures so small count as this, or an end would move without bounds
TOP, BOTTOM = 0, 1  # ends of a patch: where elements land and where they leave
AREA, WIDTH, RISE, GROWTH = 2, 3, 4, 5  # GROWTH + TOP and GROWTH + BOTTOM


class Patches(NamedTuple):
    """The patches of a contact, in the order in which elements come to them."""

    after: np.ndarray  # shape (most, 2): the intervals of TOP and BOTTOM, counted from the deepest
    # Shape (most, 7): t in them; integral of d - z, width in dx, z_TOP - z_BOTTOM, and by how much
    # each of both ends moves outwards, in dx, for each dd.
    at: np.ndarray


class Contact(NamedTuple):
    """What one turn round the line at constant indentation gives; integrals are over x in dx."""

    d: float  # indentation, in h
    force: float  # integral of -u
    rate: float  # its derivative with respect to d
    work: float  # integral of (d - z) z' over the contact
    turn: float  # by how much z' weighed with p changes at leading edges, for each dd
    patches: int  # the last one, which comes to the deepest point, goes on with the first


@kernel
def room_for_patches(n):
    """Return Patches with room for as many as there can be on n intervals."""
    most = n * MOST_EVENTS // 2 + 2  # pages that are never written take no memory
    return Patches(np.empty((most, 2), np.int64), np.empty((most, 7)))


@refcount_free_kernel
def turn(line, speed, d, patches):
    """Return the Contact at the indentation d; fill in the patches.

    d lies over the deepest point, where the turn begins, in contact, and ends. An interval has
    events only where bounds of its heights and slopes leave room for them.
    """
    z, slope, bend, h, each, spans, (start, begin, deepest) = line
    after, at = patches
    n, a, i, j, t, count = z.size, h / speed, 0, start, begin, 0
    once, span = math.exp(-a), math.exp(-a * SPAN)
    force = rate = work = turning = area = width = u = left = since = 0.0
    held, top = True, deepest - d
    after[0, TOP], at[0, TOP], at[0, GROWTH + TOP] = 0, begin, 0.0
    while i <= n:
        if t == 0.0 and held:
            while i < n:
                b = span_of(j, n - i)
                if b >= 0 and d + speed * spans.flat[b] > spans.high[b]:
                    area, width = area + (SPAN * h * d - spans.area[b]), width + SPAN * h
                    i, j = i + SPAN, b * SPAN - 1 if b > 0 else n - 1
                elif d + speed * each.flat[j] > each.high[j]:
                    area, width = area + (h * d - each.area[j]), width + h
                    i, j = i + 1, j - 1 if j > 0 else n - 1
                else:
                    break
        elif t == 0.0:
            while i < n:
                b = span_of(j, n - i)
                if b >= 0 and spans.low[b] - d >= span * u:
                    u = span * u if u < -MIN_MAGNITUDE else 0.0
                    i, j = i + SPAN, b * SPAN - 1 if b > 0 else n - 1
                elif each.low[j] - d >= once * u:
                    u = once * u if u < -MIN_MAGNITUDE else 0.0
                    i, j = i + 1, j - 1 if j > 0 else n - 1
                else:
                    break
        c, stop, fresh = septic_coefficients(z, slope, bend, h, j), 1.0 if i < n else begin, True
        over = (c[0] - d, c[1], c[2], c[3], c[4], c[5], c[6], c[7])
        for _ in range(MOST_EVENTS):
            if held:
                p = pressure(c, d, speed / h)
                zero = first_zero(p, 0.0, 0.0, t, stop, True)
                end = min(zero, stop)
                area, width = area - h * integral(over, t, end), width + h * (end - t)
                if zero > stop:
                    break
                t, held, fresh, u = zero, False, False, septic_height(over, zero)
                left, since = u, i + t
                after[count, BOTTOM], at[count, BOTTOM] = i, t
                at[count, GROWTH + BOTTOM] = -h / min(septic_slope(p, t), -LEAST)
                at[count, AREA], at[count, WIDTH], at[count, RISE] = area, width, top - u
                force, rate, count = force + area, rate + width, count + 1
                area = width = 0.0
            else:
                zero = first_zero(over, u, a, t, stop, fresh)
                if zero > stop and i < n:
                    u = u * math.exp(-a * (stop - t)) if u < -MIN_MAGNITUDE else 0.0
                    break
                t, held = min(zero, stop), True
                top = septic_height(over, t)
                lost = -math.expm1(-a * (i + t - since))
                force, rate = force - speed * lost * left, rate + speed * lost
                work += 0.5 * left * left * lost * (2.0 - lost)
                along = -septic_slope(c, t) / h
                turning += speed * lost * along
                after[count, TOP], at[count, TOP] = i, t
                at[count, GROWTH + TOP] = speed * lost / max(speed * along - top, LEAST)
        i, j, t = i + 1, j - 1 if j > 0 else n - 1, 0.0
    if not held:  # rounding let it leave just before the deepest point, which is in contact
        after[count, TOP], at[count, TOP], at[count, GROWTH + TOP] = n, begin, 0.0
        top = deepest - d
    after[count, BOTTOM], at[count, BOTTOM], at[count, GROWTH + BOTTOM] = n, begin, 0.0
    at[count, AREA], at[count, WIDTH], at[count, RISE] = area, width, top - (deepest - d)
    force, rate, count = force + area, rate + width, count + 1
    return Contact(d, force, rate, work, turning, count)
