"""The balance of one step: listed samples and those in sums carry the load together."""

import numpy as np

from ...compile.jit import by_type, kernel
from ...control.printed_eq3 import PrintedForce
from ...model.contact import overlap, weighted_overlap
from ...model.force import ConstantForce
from .setting import advance, rise

STRIP = 32  # samples, and partial sums
NEARER, FARTHER = 0.1, 1.2  # of d, and of what its rate after the jump foretells of the first step
MOST_PASSES = 100  # a few do; what takes more is left to the plain march


@by_type
def foresee(control, setting):
    """Return d after the first step, or a little beyond."""


@by_type
def note(control, lists, arrivals, d):
    """Return what ``settle`` and ``amend`` need to know of the step before, or None."""


@by_type
def settle(control, law, lists, arrivals, noted, sums, others, d, guess):
    """Return (d, push, passes): the new indentation, D of the samples in sums, passes over c.

    noted : before the shift. others : how many samples are landings, and their overlap were d to
    stay. d : the old indentation. guess : of the new one.
    d is NaN where no balance was found. c is left consistent with the new d.
    """


@by_type
def lands(control):
    """Return whether an element that always lands does so by the past of d alone (landings.py)."""


@by_type
def amend(control, noted, flights, d):
    """Correct what elements that left contact one step ago arrive with, now that d is known."""


@foresee.of(ConstantForce)
def _foresee(control, setting):
    # d follows d' as an element in contact does, by 1 - E = 1 / K in a step. Under next to no load
    # the rate is rounding, but one element could carry all of it.
    law, d = setting.law, setting.start.d
    new = max(d + FARTHER * setting.rate / law.stiffness, NEARER * d)
    return min(new, law.decay * d + control.load / law.stiffness)


@note.of(ConstantForce)
def _note(control, lists, arrivals, d):
    return None


@settle.of(ConstantForce)
def _settle(control, law, lists, arrivals, noted, sums, others, d, guess):
    """Solve n (D - level) + sum (level - a) + sum max(0, d - c) = load / K."""
    target = control.load / law.stiffness - others[1]
    slope = sums.samples + others[0]
    new, passes = _root(law, lists.c, None, sums, slope, target, d, guess)
    return new, advance(law, new, d), passes


@lands.of(ConstantForce)
def _lands(control):
    return True


@lands.of(PrintedForce)
def _lands_otherwise(control):
    return False  # what left contact is corrected by amend


@amend.of(ConstantForce)
def _amend(control, noted, flights, d):
    return None


@foresee.of(PrintedForce)
def _foresee_end(control, setting):
    # The rate of d costs no force: d goes to its end at once, and beyond (measured: by as much).
    return setting.end.d + 1.5 * (setting.end.d - setting.start.d)


@note.of(PrintedForce)
def _held(control, lists, arrivals, d):
    """Return which listed samples an element reaches straight from contact, and which flights."""
    c, (neighbours, flights) = lists.c, arrivals
    held, left = np.zeros(c.size, np.bool_), np.ones(flights.at.size, np.bool_)
    for i in range(c.size - 1):
        held[i] = c[i + 1] < d
    held[neighbours.at] = True
    for f in range(flights.at.size):
        if flights.source[f] >= 0:
            left[f] = c[flights.source[f]] < d
        held[flights.at[f]] = left[f] and flights.begin[f + 1] - flights.begin[f] == 1
    return held, left


@settle.of(PrintedForce)
def _balance(control, law, lists, arrivals, noted, sums, others, d, guess):
    """Balance the load where held elements move with the line but not with the indentation.

    As in printed_eq3.py: their last displacement counts as z - d with the new d, and so D is
    d / K for them. c is left consistent with it.
    """
    held, _ = noted
    c, z = lists.c, lists.z
    steep = np.empty(c.size)
    for i in range(c.size - 1):
        steep[i] = rise(law, z[i], z[i + 1])
    neighbours, flights = arrivals
    steep[neighbours.at] = neighbours.rise
    for f in range(flights.at.size):
        steep[flights.at[f]] = rise(law, z[flights.at[f]], flights.height[f])
    threshold, weight = c.copy(), np.ones(c.size)
    for i in range(c.size):
        if held[i]:
            threshold[i], weight[i] = steep[i] * law.stiffness, 1.0 / law.stiffness
    target, slope = control.load / law.stiffness, sums.samples / law.stiffness
    new, passes = _root(law, threshold, weight, sums, slope, target, d, guess)
    for i in range(c.size):
        if held[i]:
            c[i] = steep[i] + law.decay * new
    return new, new / law.stiffness, passes


@amend.of(PrintedForce)
def _amend_held(control, noted, flights, d):
    _, left = noted
    for f in range(flights.at.size):
        if flights.round[f] and left[f]:
            begin, place = flights.begin[f], flights.place[f]
            before = (place if place > begin else flights.begin[f + 1]) - 1
            flights.values[before] = flights.crossing[f] * (flights.height[f] - d)


@kernel
def _root(law, c, weight, sums, slope, target, d, guess):
    """Return (new, passes), the root of the balance by Newton's method.

    The left side is increasing and convex in d, and linear but for the listed samples: right of
    the root every pass has fewer of them touching, or is the last (contact.py).
    slope : how the part of the samples in sums grows with d. weight : as of solve_indentation.
    """
    base = sums.samples * (d / law.stiffness - sums.level) + sums.depth - target  # were d to stay
    now, before, fallen = guess, -1.0, c.size == 0
    for passes in range(1, MOST_PASSES):
        if weight is None:
            force, count = overlap_of(c, now)
            steep = count + slope
        else:
            force, listed, count = weighted_overlap(c, weight, now)
            steep = listed + slope
        if steep == 0.0:  # below every threshold: one element that carries all is above the root
            if fallen:
                break
            lowest = np.argmin(c)
            now, fallen = c[lowest] + (target if weight is None else target / weight[lowest]), True
        else:
            new = now - (force + slope * (now - d) + base) / steep
            if passes > 1 and (count == before or not new < now):
                return new, passes
            now = new
        before = count
    return np.nan, MOST_PASSES


@kernel
def overlap_of(c, d):
    """Return (sum of d - c_i, number) over the touching elements c_i < d, as overlap does.

    That one is faster for few elements.
    """
    if c.size < 4 * STRIP:
        return overlap(c, d)
    depth, count = np.zeros(STRIP), np.zeros(STRIP)
    strips = c.size // STRIP
    for s in range(strips):
        part = c[s * STRIP : (s + 1) * STRIP]
        for i in range(STRIP):
            p = d - part[i]
            depth[i] += p if p > 0.0 else 0.0
            count[i] += 1.0 if p > 0.0 else 0.0
    total, touching = overlap(c[strips * STRIP :], d)
    return total + in_order(depth), touching + in_order(count)


@kernel
def in_order(parts):
    """Return the sum of partial sums, from the first to the last."""
    total = 0.0
    for part in parts:
        total += part
    return total
