"""Steady sliding in partial contact, and jumps from it, resolved between the samples of a line.

At light load and high speed elements lag behind the line, and only the leading sides of the deepest
asperities touch, over less than a sample. The edges of wide contacts lie between samples too. The
line is a smooth function, determined by its heights and slopes at the samples, so its contacts can
be followed between the samples (events.py).
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...lines.polynomials import septic_coefficients, septic_height, septic_slope
from ...root_search import new_search, next_guess
from ..steady.span_sliding import halley_step
from ..steady.spans import SPAN
from .events import (
    AREA,
    GROWTH,
    LEADING_END,
    MAX_EVENTS,
    RISE,
    TRAILING_END,
    WIDTH,
    allocate_patches,
    turn_line,
)
from .smooth_line import first_zero, pressure, products, slope_square, span_of

MIN_SMOOTH_STEPS = 4  # samples per spacing: eight in the shortest wave give mu to 1e-6
LINEAR_LOAD_ERROR = 5e-4  # largest relative load error corrected to first order
LINEAR_JUMP_ERROR = 5e-3  # the same after a jump, over min(1, |v2/v1 - 1|)
MIN_DEPTH = 1e-9  # relative to the rise of the line beside its deepest point; less is rounding


class FollowedColumns(NamedTuple):
    """Columns of the table that slide_between returns, each of shape (loads,)."""

    d: np.ndarray  # over the deepest sample, in h
    mu: np.ndarray  # in h/dx
    length: np.ndarray  # of contact, in dx
    median_width: np.ndarray  # load-weighted median width of patches, in dx
    events: np.ndarray  # number of turns times patches; 0 where no solution was found


class ContactIntegrals(NamedTuple):
    """Integrals over a contact, x in dx."""

    length: float
    rise: float  # of z'
    square: float  # of z'^2


class Unpressed(NamedTuple):
    """Integrals over the part of a contact where p would be negative."""

    force: float  # of p
    work: float  # of p z'
    length: float
    rise: float  # of z'


@kernel
def slide_between(line, speed, others, loads, guesses):
    """Return (table, jumps, rates) of steady sliding of a SmoothLine at a speed.

    others : speeds after a jump, vbar. loads : n Fbar. guesses : of d. table : one row per load,
    with the FollowedColumns. jumps : change of mu at each jump. rates : d' just after each jump.
    Both have the shape (loads, others).
    """
    h, patches = line.spacing, allocate_patches(line.z.size)
    table, shape = np.zeros((loads.size, 5)), (loads.size, others.size)
    jumps, rates = np.zeros(shape), np.zeros(shape)
    for i in range(loads.size):
        load = h * loads[i]
        contact, turns = _balance_load(line, speed, load, guesses[i], patches)
        if turns == 0:
            continue
        integrals = _integrals(line, contact, patches)
        change = (load - contact.force) / contact.rate  # remaining change of d, to first order
        work = contact.work + speed * integrals.square
        table[i, 0] = contact.d + change
        table[i, 1] = (work + change * (integrals.rise + contact.edge_rate)) / load
        table[i, 2] = integrals.length
        table[i, 3] = _median_width(contact, speed, patches)
        table[i, 4] = turns * contact.patches
        for k in range(others.size):
            jump = _after_jump(line, (speed, others[k]), contact, integrals, change, patches)
            jumps[i, k], rates[i, k] = (work + jump[0]) / load - table[i, 1], jump[1]
    return table, jumps, rates


@refcount_free_kernel
def _balance_load(line, speed, load, guess, patches):
    """Return (PatchedContact that carries the load (eq. 4), turns); 0 turns : no solution.

    load : integral of p over x in dx. The force is an increasing, convex function of d
    (model/steady.py). The first step is halley_step; Newton's method follows.
    """
    j, _, deepest = line.deepest
    min_depth = MIN_DEPTH * (max(line.z[j], line.z[j + 1 if j + 1 < line.z.size else 0]) - deepest)
    search, tolerance = new_search(guess, -np.inf, np.inf, np.inf), LINEAR_LOAD_ERROR * load
    while True:
        d = search.x
        contact = turn_line(line, speed, d, patches)
        excess, slope = contact.force - load, contact.rate
        if search.evaluations == 0:
            step = deepest + halley_step(d - deepest, contact.force, slope, load) - d
            slope = -excess / step if step != 0.0 else slope
        search = next_guess(search, d, excess, slope, 0.0, tolerance, 0.0)
        if search.ended or not search.x - deepest > min_depth:
            return contact, search.evaluations if abs(excess) <= tolerance else 0


@refcount_free_kernel
def _interval(first, i, n):
    """Return the interval that elements reach i intervals after ``first``; n : their number."""
    return first - i if i <= first else first - i + n


@refcount_free_kernel
def _integrals(line, contact, patches):
    """Return the ContactIntegrals over the patches of a contact."""
    z, slope, bend, h, intervals, spans, (first, _, _) = line
    interval, values = patches
    length = rise = square = 0.0
    for k in range(contact.patches):
        length, rise = length + values[k, WIDTH], rise + values[k, RISE]
        i, last = interval[k, LEADING_END], interval[k, TRAILING_END]
        while i <= last:
            j = _interval(first, i, z.size)
            b = span_of(j, last - i) if i > interval[k, LEADING_END] else -1
            start = values[k, LEADING_END] if i == interval[k, LEADING_END] else 0.0
            stop = values[k, TRAILING_END] if i == last else 1.0
            if b >= 0:
                square += spans.square[b]
            elif stop - start == 1.0:
                square += intervals.square[j]
            else:
                square += slope_square(septic_coefficients(z, slope, bend, h, j), start, stop) / h
            i += SPAN if b >= 0 else 1
    return ContactIntegrals(length, rise, square)


@refcount_free_kernel
def _after_jump(line, speeds, contact, integrals, shortfall, patches):
    """Return (change of the integral of p z', d') at a jump of speed. speeds : (v1, v2), vbar.

    The contact does not change, and p changes by d' + (v2 - v1) z' where it remains positive
    (model/friction.py). The initial guess of d' is exact if p remains positive everywhere.
    shortfall : change of d that the contact needs to carry its load, included to first order.
    """
    speed, other = speeds
    step = other - speed
    search = new_search(-step * integrals.rise / integrals.length, -np.inf, np.inf, np.inf)
    tolerance = LINEAR_JUMP_ERROR * min(1.0, abs(step) / speed) * contact.force
    while not search.ended:
        rate = search.x
        lost = _unpressed(line, other, contact.d + rate, patches, contact.patches)
        excess = rate * integrals.length + step * integrals.rise - lost.force
        length = integrals.length - lost.length
        search = next_guess(search, rate, excess, length, 0.0, tolerance, 0.0)
    force, work = _growth(line, other, contact.d + rate, shortfall, patches, contact.patches)
    change = (excess + force - contact.rate * shortfall) / length
    growth = work - change * (integrals.rise - lost.rise)
    pressed = rate * integrals.rise + step * integrals.square - lost.work
    return pressed + growth, rate - change - shortfall


@refcount_free_kernel
def _growth(line, speed, deep, shortfall, patches, count):
    """Return the integrals of p and p z' over the strips by which patches grow at their ends.

    shortfall : rise of d. deep : d + d'. count : number of patches.
    """
    z, slope, bend, h, _, _, (first, _, _) = line
    interval, values = patches
    force = work = 0.0
    for k in range(count):
        for end in (LEADING_END, TRAILING_END):
            i, t = interval[k, end], values[k, end]
            c = septic_coefficients(z, slope, bend, h, _interval(first, i, z.size))
            along = -septic_slope(c, t) / h
            p = max(deep - septic_height(c, t) + speed * along, 0.0)
            added = p * values[k, GROWTH + end] * shortfall
            force, work = force + added, work + added * along
    return force, work


@refcount_free_kernel
def _unpressed(line, speed, deep, patches, count):
    """Return the Unpressed part of a contact, where p = deep - z + vbar z' < 0, deep = d + d'."""
    z, slope, bend, h, intervals, spans, (first, _, _) = line
    interval, values = patches
    force = work = length = rise = 0.0
    for k in range(count):
        following = interval[k, LEADING_END]
        while following <= interval[k, TRAILING_END]:
            i = following
            j = _interval(first, i, z.size)
            b = span_of(j, interval[k, TRAILING_END] - i + 1)
            if b >= 0 and deep + speed * spans.min_slope[b] > spans.high[b]:
                following = i + SPAN
                continue
            following = i + 1
            if deep + speed * intervals.min_slope[j] > intervals.high[j]:
                continue
            t = values[k, LEADING_END] if i == interval[k, LEADING_END] else 0.0
            stop = values[k, TRAILING_END] if i == interval[k, TRAILING_END] else 1.0
            c = septic_coefficients(z, slope, bend, h, j)
            p = pressure(c, deep, speed / h)
            pull = (-p[0], -p[1], -p[2], -p[3], -p[4], -p[5], -p[6], -p[7])
            pressed, fresh = septic_height(p, t) > 0.0, True
            for _ in range(MAX_EVENTS):
                zero = first_zero(p if pressed else pull, 0.0, 0.0, t, stop, fresh)
                end = min(zero, stop)
                if not pressed:
                    pulled, along = products(p, c, t, end)
                    force, work = force + h * pulled, work - along
                    length += h * (end - t)
                    rise = rise + septic_height(c, t) - septic_height(c, end)
                if zero > stop:
                    break
                t, pressed, fresh = end, not pressed, False
    return Unpressed(force, work, length, rise)


@kernel
def _median_width(contact, speed, patches):
    """Return the load-weighted median width of patches, in dx."""
    count, last = contact.patches, contact.patches - 1
    width = patches.values[:count, WIDTH].copy()
    force = patches.values[:count, AREA] + speed * patches.values[:count, RISE]
    if last > 0:
        width[0], force[0] = width[0] + width[last], force[0] + force[last]
        width, force = width[:last], force[:last]
    half, total = 0.5 * force.sum(), 0.0
    for k in np.argsort(width, kind="mergesort"):
        total += force[k]
        if total >= half:
            return width[k]
    return width.max()
