"""Friction over the pieces of contact of a steady state (steady/carry.py): eq. 5 by quadrature.

The same quadrature as friction.py has for any state, for the cost of the edges of contacts: a piece
that is all pressed is known by five sums, and those by the sums of its spans.
Source: Li et al. (2014), eqs. 3 to 5, doi:10.1038/srep05795.
"""

from typing import NamedTuple

import numpy as np

from kernels.friction import LEAST_COVERED
from kernels.jit import kernel
from kernels.steady.carry import LEAST_REACH, MOST_REACH
from kernels.steady.spans import SPAN

# A row of the table of pieces: sums over its touching samples, each as far as contact covers it,
# of 1, z - z0, z' - s0, (z - z0)(z' - s0), (z' - s0)^2; then z0, s0, height and slope of its bottom
# sample, which cost sums over few samples no digits; then the largest z - vbar z'.
WEIGHT, HEIGHT, SLOPE, WORK, SQUARE, FROM_HEIGHT, FROM_SLOPE, PRESS = range(8)
COLUMNS = 8


class Forces(NamedTuple):
    """Forces of all pieces at one instant, and what a correction needs of them."""

    normal: float
    tangential: float
    contact: float  # samples under pressure, as far as contact covers them
    elastic: float  # sum of (z - d - d') z' over them
    viscous: float  # sum of vbar z'^2 over those touching without pressure


@kernel
def covered(contacts, i):
    """Return how much of the top and of the bottom sample of a piece the contact covers.

    A piece of one sample is all top.
    """
    ahead, behind = contacts.edges[i, 0] - 0.5, contacts.edges[i, 1] - 0.5
    if contacts.ends[i, 0] == contacts.ends[i, 1]:
        return max(1.0 + ahead + behind, LEAST_COVERED), 0.0
    return max(1.0 + ahead, LEAST_COVERED), max(1.0 + behind, LEAST_COVERED)


@kernel
def sum_pieces(z, slope, spans, contacts, table):
    """Fill all columns of the table, shape (pieces, COLUMNS), but the last."""
    for i in range(table.shape[0]):
        top, bottom = contacts.ends[i, 0], contacts.ends[i, 1]
        at_top, at_bottom = covered(contacts, i)
        z0, s0 = z[bottom], slope[bottom]
        a, c = z[top] - z0, slope[top] - s0
        a0, a1, a2 = at_top + at_bottom, at_top * a, at_top * c
        a3, a4 = a1 * c, a2 * c
        j = bottom + 1
        while j < top:
            b = j // SPAN
            if j == b * SPAN and j + SPAN <= top:
                a, c = z[j] - z0, slope[j] - s0
                height, rise = spans.height[b] + SPAN * a, spans.slope[b] + SPAN * c
                a0 += SPAN
                a1 += height
                a2 += rise
                a3 += spans.work[b] + a * spans.slope[b] + c * height
                a4 += spans.square[b] + c * (spans.slope[b] + rise)
                j += SPAN
                continue
            stop = min(top, (b + 1) * SPAN)
            a0 += stop - j
            while j < stop:
                a, c = z[j] - z0, slope[j] - s0
                a1 += a
                a2 += c
                a3 += a * c
                a4 += c * c
                j += 1
        table[i, WEIGHT], table[i, HEIGHT], table[i, SLOPE] = a0, a1, a2
        table[i, WORK], table[i, SQUARE] = a3, a4
        table[i, FROM_HEIGHT], table[i, FROM_SLOPE] = z0, s0


@kernel
def press_pieces(z, slope, press, contacts, speed, table):
    """Fill the last column of the table for ``speed`` (vbar), whose thresholds are ``press``."""
    for i in range(table.shape[0]):
        j, top = contacts.ends[i, 1], contacts.ends[i, 0]
        most = -np.inf
        while j <= top:
            if j % SPAN == 0 and j + SPAN - 1 <= top:
                most = max(most, press[j // SPAN])
                j += SPAN
            else:
                most = max(most, z[j] - speed * slope[j])
                j += 1
        table[i, PRESS] = most


@kernel
def balance(z, slope, contacts, table, speed, load):
    """Return (deep, forces), deep = d + d' so that sum p = load over p > 0 (eq. 4).

    The pressure of a touching sample is p = deep - z + vbar z'. From all samples pressed down to
    fewer: Newton's method on a convex sum, from the right.
    """
    weight = excess = 0.0
    for i in range(table.shape[0]):
        weight += table[i, WEIGHT]
        excess += _threshold(table, i, speed)
    deep = (load + excess) / weight
    while True:
        pressed = excess = 0.0
        for i in range(table.shape[0]):
            if deep > table[i, PRESS]:
                pressed += table[i, WEIGHT]
                excess += _threshold(table, i, speed)
            else:
                some = _pressed(z, slope, contacts, table, i, speed, deep)
                pressed += some[0]
                excess += some[1]
        new = (load + excess) / pressed
        if not (pressed < weight and new < deep):
            return deep
        weight, deep = pressed, new


@kernel
def forces(z, slope, contacts, table, speed, deep):
    """Return the Forces of all pieces (eqs. 3 and 5)."""
    normal = tangential = contact = elastic = viscous = 0.0
    for i in range(table.shape[0]):
        if deep > table[i, PRESS]:
            height, rise = table[i, HEIGHT], table[i, SLOPE]
            z0, s0 = table[i, FROM_HEIGHT], table[i, FROM_SLOPE]
            spread = table[i, WORK] - speed * table[i, SQUARE]
            p0 = deep - (z0 - speed * s0)
            own = p0 * table[i, WEIGHT] - (height - speed * rise)
            normal += own
            tangential += own * s0 + (p0 * rise - spread)
            contact += table[i, WEIGHT]
            lift = (deep - z0) * table[i, WEIGHT] - height
            elastic -= lift * s0 + ((deep - z0) * rise - table[i, WORK])
        else:
            some = _pressed(z, slope, contacts, table, i, speed, deep)
            contact += some[0]
            normal += some[2]
            tangential += some[3]
            elastic += some[4]
            viscous += some[5]
    return Forces(normal, tangential, contact, elastic, viscous)


@kernel
def elastic_part(z, slope, contacts, found, deep, speed, steps):
    """Return what sum p z' misses of the friction of steady sliding (friction.py).

    Cell by cell the exact part is a telescoping sum: its ends are the edges of the contact. A
    sample at a trailing edge that is not resolved is left as it is. steps : samples per spacing.
    """
    missing = found.elastic + found.viscous
    for i in range(contacts.ends.shape[0]):
        top, bottom = contacts.ends[i, 0], contacts.ends[i, 1]
        ahead, behind = contacts.edges[i, 0], contacts.edges[i, 1]
        left = z[bottom] + behind * (z[bottom - 1] - z[bottom])  # z[-1] is the last sample
        if not LEAST_REACH < behind < MOST_REACH:
            at_top, at_bottom = covered(contacts, i)
            whole = at_top if top == bottom else at_bottom
            s = slope[bottom]
            pressed = deep > z[bottom] - speed * s
            missing -= whole * s * ((z[bottom] - deep) if pressed else speed * s)
            if top == bottom:
                continue
            left = 0.5 * (z[bottom] + z[bottom + 1])
        right = z[top] + ahead * (z[top + 1 if top + 1 < z.size else 0] - z[top])
        missing += 0.5 * steps * (right - left) * ((deep - left) + (deep - right))
    return missing


@kernel
def steepest(slope, spans, contacts):
    """Return the largest |z'| among the touching samples."""
    most = 0.0
    for i in range(contacts.ends.shape[0]):
        j, top = contacts.ends[i, 1], contacts.ends[i, 0]
        while j <= top:
            if j % SPAN == 0 and j + SPAN - 1 <= top:
                most = max(most, spans.steepest[j // SPAN])
                j += SPAN
            else:
                most = max(most, abs(slope[j]))
                j += 1
    return most


@kernel
def median_width(z, d, decay, contacts, table):
    """Return the median over the load of the width of patches (patches/samples.py), in samples."""
    pieces = table.shape[0]
    start = 0
    while start < pieces and contacts.ends[start, 2] == 1:
        start += 1
    if start == pieces:
        return float(z.size)
    width = np.zeros(pieces, np.int64)
    carried = np.zeros(pieces)
    patches = 0
    for k in range(pieces):
        i = (start + k) % pieces
        patches += 1 - contacts.ends[i, 2]
        width[patches - 1] += contacts.ends[i, 0] - contacts.ends[i, 1] + 1
        carried[patches - 1] += _carried(z, d, decay, contacts, table, i)
    most = 0
    half = 0.0
    for p in range(patches):
        most = max(most, width[p])
        half += 0.5 * carried[p]
    by_width = np.zeros(most + 1)
    for p in range(patches):
        by_width[width[p]] += carried[p]
    total = 0.0
    for wide in range(most + 1):
        total += by_width[wide]
        if total >= half and total > 0.0:
            return float(wide)
    return float(most)


@kernel
def _carried(z, d, decay, contacts, table, i):
    """Return sum (w - u) over a piece: inside it every w is E times the u ahead."""
    top, bottom = contacts.ends[i, 0], contacts.ends[i, 1]
    at_top, _ = covered(contacts, i)
    z0 = z[bottom]
    height = table[i, HEIGHT] - (at_top - 1.0) * (z[top] - z0)
    sum_u = height - (top - bottom + 1) * (d - z0)
    return contacts.edges[i, 2] - decay.once * (z0 - d) - (1.0 - decay.once) * sum_u


@kernel
def _threshold(table, i, speed):
    """Return the sum of z - vbar z' over a piece."""
    at = table[i, FROM_HEIGHT] - speed * table[i, FROM_SLOPE]
    return table[i, WEIGHT] * at + (table[i, HEIGHT] - speed * table[i, SLOPE])


@kernel
def _pressed(z, slope, contacts, table, i, speed, deep):
    """Return sums over a piece that is not all pressed, sample by sample.

    Over samples with z - vbar z' < deep: of 1, z - vbar z', p, p z', (z - deep) z'; over the
    others: of vbar z'^2.
    """
    top, bottom = contacts.ends[i, 0], contacts.ends[i, 1]
    at_top, at_bottom = covered(contacts, i)
    a0 = a1 = a2 = a3 = a4 = a5 = 0.0
    for j in range(bottom, top + 1):
        weight = at_top if j == top else (at_bottom if j == bottom else 1.0)
        threshold = z[j] - speed * slope[j]
        if threshold < deep:
            a0 += weight
            a1 += weight * threshold
            a2 += weight * (deep - threshold)
            a3 += weight * (deep - threshold) * slope[j]
            a4 += weight * (z[j] - deep) * slope[j]
        else:
            a5 += weight * speed * slope[j] ** 2
    return a0, a1, a2, a3, a4, a5
