"""Steady sliding where part of a line touches, and jumps from it, between its samples.

At light load and high speed an element stays behind the line and only the front of the highest
peaks touches, over less than a sample; and the edges of wide contacts lie between samples too. The
line is a smooth function known by its heights and slopes, so that its contacts are followed between
the samples (events.py).
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...lines.polynomials import septic_coefficients, septic_height, septic_slope
from ..steady.sliding import power_step
from ..steady.spans import SPAN
from .events import AREA, BOTTOM, GROWTH, MOST_EVENTS, RISE, TOP, WIDTH, room_for_patches, turn
from .smooth_line import first_zero, pressure, products, span_of, squared

LEAST_STEPS = 4  # samples per spacing, eight in the shortest wave: mu to 1e-6
CLOSE = 5e-4  # of the load: an excess whose square is as good as none
JUMP_CLOSE = 5e-3  # the same of the pressures that a jump adds
MOST_TURNS = 40
LEAST_DEPTH = 1e-9  # of what the line rises beside its deepest point: a depth that is no rounding


class Columns(NamedTuple):
    """What is found of every load, each of shape (loads,)."""

    d: np.ndarray  # over the deepest sample, in h
    mu: np.ndarray  # in h/dx
    length: np.ndarray  # of contact, in dx
    median: np.ndarray  # width of patches, over the load, in dx
    events: np.ndarray  # patches that were come to in all turns; none where nothing is found


class Integrals(NamedTuple):
    """Integrals over a contact, x in dx."""

    length: float
    rise: float  # of z'
    square: float  # of z'^2


@kernel
def slide_between(line, speed, others, loads, guesses):
    """Return (table, jumps, rates) of steady sliding of a SmoothLine at a speed.

    others : speeds that are jumped to, vbar. loads : n Fbar. guesses : of d. A row of the table has
    the Columns of a load. jumps, rates : the change of mu at each jump, and d' just after it, shape
    (loads, others).
    """
    h, patches = line.spacing, room_for_patches(line.z.size)
    table, shape = np.zeros((loads.size, 5)), (loads.size, others.size)
    jumps, rates = np.zeros(shape), np.zeros(shape)
    for i in range(loads.size):
        load = h * loads[i]
        contact, turns = _balanced(line, speed, load, guesses[i], patches)
        if turns == 0:
            continue
        sums = _sums(line, contact, patches)
        change = (load - contact.force) / contact.rate  # of d, which is left to first order
        work = contact.work + speed * sums.square
        table[i, 0] = contact.d + change
        table[i, 1] = (work + change * (sums.rise + contact.turn)) / load
        table[i, 2] = sums.length
        table[i, 3] = _median_width(contact, speed, patches)
        table[i, 4] = turns * contact.patches
        for k in range(others.size):
            jump = _after_jump(line, (speed, others[k]), contact, sums, change, patches)
            jumps[i, k], rates[i, k] = (work + jump[0]) / load - table[i, 1], jump[1]
    return table, jumps, rates


@refcount_free_kernel
def _balanced(line, speed, load, guess, patches):
    """Return (Contact that carries the load, eq. 4, turns), by Newton's method; no turns: none.

    load : integral of p in dx. The force is an increasing, convex function of d (model/steady.py);
    the first step would be exact were it a power of the depth.
    """
    j, _, deepest = line.deepest
    least = LEAST_DEPTH * (max(line.z[j], line.z[j + 1 if j + 1 < line.z.size else 0]) - deepest)
    d, turns = guess, 0
    while True:
        contact = turn(line, speed, d, patches)
        excess, turns = contact.force - load, turns + 1
        if abs(excess) <= CLOSE * load:
            return contact, turns
        if turns == 1:
            d = deepest + power_step(d - deepest, contact.force, contact.rate, load)
        else:
            d -= excess / contact.rate
        if turns == MOST_TURNS or not d - deepest > least:
            return contact, 0


@refcount_free_kernel
def _interval(first, i, n):
    """Return which of n intervals is the i-th that elements come to, from ``first`` on."""
    return first - i if i <= first else first - i + n


@refcount_free_kernel
def _sums(line, contact, patches):
    """Return the Integrals over the patches of a contact."""
    z, slope, bend, h, each, spans, (first, _, _) = line
    after, at = patches
    length = rise = square = 0.0
    for k in range(contact.patches):
        length, rise = length + at[k, WIDTH], rise + at[k, RISE]
        i, last = after[k, TOP], after[k, BOTTOM]
        while i <= last:
            j = _interval(first, i, z.size)
            b = span_of(j, last - i) if i > after[k, TOP] else -1
            start = at[k, TOP] if i == after[k, TOP] else 0.0
            stop = at[k, BOTTOM] if i == last else 1.0
            if b >= 0:
                square += spans.square[b]
            elif stop - start == 1.0:
                square += each.square[j]
            else:
                square += squared(septic_coefficients(z, slope, bend, h, j), start, stop) / h
            i += SPAN if b >= 0 else 1
    return Integrals(length, rise, square)


@refcount_free_kernel
def _after_jump(line, speeds, contact, sums, left, patches):
    """Return by how much the integral of p z' changes as one speed jumps to another, and d'.

    What touches stays, and p changes by d' + (v2 - v1) z' where it stays positive (friction.py).
    Were all of it pressed, eq. 4 would give d', which falls where some is not.
    left : change of d by which the contact still misses its load, made up for to first order.
    """
    own, other = speeds
    more = other - own
    rate, close = -more * sums.rise / sums.length, JUMP_CLOSE * min(1.0, abs(more) / own)
    for _ in range(MOST_TURNS):
        lost = _unpressed(line, other, contact.d + rate, patches, contact.patches)
        excess = rate * sums.length + more * sums.rise - lost[0]
        change = excess / (sums.length - lost[2])
        if abs(excess) <= close * contact.force:
            break
        rate -= change
    force, work = _grown(line, other, contact.d + rate, left, patches, contact.patches)
    change += (force - contact.rate * left) / (sums.length - lost[2])
    grown = work - change * (sums.rise - lost[3])
    return rate * sums.rise + more * sums.square - lost[1] + grown, rate - change - left


@refcount_free_kernel
def _grown(line, speed, deep, left, patches, count):
    """Return integrals of p and p z' over what patches grow by once d rises by ``left``.

    deep : as of _unpressed.
    """
    z, slope, bend, h, _, _, (first, _, _) = line
    after, at = patches
    force = work = 0.0
    for k in range(count):
        for end in (TOP, BOTTOM):
            i, t = after[k, end], at[k, end]
            c = septic_coefficients(z, slope, bend, h, _interval(first, i, z.size))
            along = -septic_slope(c, t) / h
            some = max(deep - septic_height(c, t) + speed * along, 0.0) * at[k, GROWTH + end] * left
            force, work = force + some, work + some * along
    return force, work


@refcount_free_kernel
def _unpressed(line, speed, deep, patches, count):
    """Return integrals of p, p z', 1 and z' over what of a contact would have a pressure p < 0.

    deep : d + d', with p = d + d' - z + vbar z'.
    """
    z, slope, bend, h, each, spans, (first, _, _) = line
    after, at = patches
    force = work = length = rise = 0.0
    for k in range(count):
        following = after[k, TOP]
        while following <= after[k, BOTTOM]:
            i = following
            j = _interval(first, i, z.size)
            b = span_of(j, after[k, BOTTOM] - i + 1)
            if b >= 0 and deep + speed * spans.flat[b] > spans.high[b]:
                following = i + SPAN
                continue
            following = i + 1
            if deep + speed * each.flat[j] > each.high[j]:
                continue
            t = at[k, TOP] if i == after[k, TOP] else 0.0
            stop = at[k, BOTTOM] if i == after[k, BOTTOM] else 1.0
            c = septic_coefficients(z, slope, bend, h, j)
            p = pressure(c, deep, speed / h)
            pull = (-p[0], -p[1], -p[2], -p[3], -p[4], -p[5], -p[6], -p[7])
            pressed, fresh = septic_height(p, t) > 0.0, True
            for _ in range(MOST_EVENTS):
                zero = first_zero(p if pressed else pull, 0.0, 0.0, t, stop, fresh)
                end = min(zero, stop)
                if not pressed:
                    some, along = products(p, c, t, end)
                    force, work = force + h * some, work - along
                    length, rise = (
                        length + h * (end - t),
                        rise + septic_height(c, t) - septic_height(c, end),
                    )
                if zero > stop:
                    break
                t, pressed, fresh = end, not pressed, False
    return force, work, length, rise


@kernel
def _median_width(contact, speed, patches):
    """Return the median over the load of the width of patches, in dx."""
    count, last = contact.patches, contact.patches - 1
    width = patches.at[:count, WIDTH].copy()
    force = patches.at[:count, AREA] + speed * patches.at[:count, RISE]
    if last > 0:
        width[0], force[0] = width[0] + width[last], force[0] + force[last]
        width, force = width[:last], force[:last]
    half, total = 0.5 * force.sum(), 0.0
    for k in np.argsort(width, kind="mergesort"):
        total += force[k]
        if total >= half:
            return width[k]
    return width.max()
