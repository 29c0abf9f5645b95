"""Pressures in the contacts of a steady state: eqs. 3 to 5 by quadrature.

The quadrature of model/friction.py, which any state has, for a state whose touching samples are
listed (touching.py): a span that is all pressed is known by its sums. Eq. 5 is summed there, here
and, as the mean over a step, in march/stepping.py; eq. 4 is solved by model/contact.py.
Source: Li et al. (2014), doi:10.1038/srep05795.
"""

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...model.contact import excess_at, lowest_threshold
from ...model.friction import MAX_EDGE_REACH, MIN_EDGE_REACH
from ..steady.contacts import AHEAD, BEHIND
from ..steady.spans import HEIGHT, SLOPE, SPAN, SQUARE, STEEP, WORK
from .pressed import Pressed, span_under, weighed_side_by_side
from .touching import covered


@excess_at.register(Pressed)
def _excess_of_pressed(contact, load, d):
    threshold, weight = contact.threshold, contact.touching.weight
    force, _, count = weighed_side_by_side(threshold, weight, None, d)
    more, _, others = weighed_side_by_side(contact.loose, None, None, d)
    force, count = force + more, count + others
    line = contact.line
    for i in range(contact.spans.size):
        b = contact.spans[i]
        if d > line.press[b]:
            force += SPAN * (d - contact.first[i]) - contact.sums[i]
            count += SPAN
        else:
            more, _, others = span_under(line, b, d)
            force, count = force + more, count + others
    return force - load, count, count


@lowest_threshold.register(Pressed)
def _lowest_of_pressed(contact, load):
    lowest = bound = np.inf
    for i in range(contact.threshold.size):
        lowest = min(lowest, contact.threshold[i])
        bound = min(bound, contact.threshold[i] + load / contact.touching.weight[i])
    return lowest, bound


@refcount_free_kernel
def friction(contact, deep):
    """Return (mu, samples under pressure): eq. 5, in h/dx. deep : d + d'.

    As weighted_sums (model/friction.py), with the sums of spans that are all pressed.
    """
    touching, line = contact.touching, contact.line
    normal, tangential, count = weighed_side_by_side(
        contact.threshold, touching.weight, touching.slope, deep
    )
    more, along, others = weighed_side_by_side(contact.loose, None, contact.slope, deep)
    normal, tangential, count = normal + more, tangential + along, count + others
    rows, speed = line.spans.rows, line.speed
    for i in range(contact.spans.size):
        b = contact.spans[i]
        if deep > line.press[b]:
            p = deep - contact.first[i]
            more, others = SPAN * p - contact.sums[i], float(SPAN)
            row = rows[b, SLOPE], rows[b, WORK], rows[b, SQUARE]
            along = more * rows[b, STEEP] + _uneven(p, row, speed)
        else:
            more, along, others = span_under(line, b, deep)
        normal, tangential, count = normal + more, tangential + along, count + others
    return tangential / normal, count


@kernel
def _uneven(p, sums, speed):
    """Return the sum of p times z' over samples all pressed, beyond that with z' of the first.

    p : at the first sample. sums : SLOPE, WORK and SQUARE (spans.py).
    """
    slope, work, square = sums
    return p * slope - (work - speed * square)


@refcount_free_kernel
def friction_everywhere(z, slope, spans, speed, load):
    """Return (mu, d + d') where the whole line touches and is pressed: its sums are known.

    The mean of the pressures p = (d + d') - z + vbar z' is load / n.
    """
    height, rise, work, square = spans.whole
    excess = (height - speed * rise) / z.size
    p = load / z.size + excess  # at the first sample, which the sums are taken from
    uneven = _uneven(p, (rise, work, square), speed)
    return slope[0] + uneven / load, p + (z[0] - speed * slope[0])


@refcount_free_kernel
def elastic_part(contact, contacts, deep, steps):
    """Return what sum p z' misses of the friction of steady sliding (friction.py).

    Cell by cell the exact part is a telescoping sum: its ends are the edges of the contact. A
    sample at a trailing edge that is not resolved is left as it is. steps : samples per spacing.
    """
    z, slope, speed = contact.line.z, contact.line.slope, contact.line.speed
    missing = _elastic_sum(contact, deep)
    for i in range(contacts.ends.shape[0]):
        top, bottom = contacts.ends[i, 0], contacts.ends[i, 1]
        ahead, behind = contacts.edges[i, AHEAD], contacts.edges[i, BEHIND]
        left = z[bottom] + behind * (z[bottom - 1] - z[bottom])  # z[-1] is the last sample
        if not MIN_EDGE_REACH < behind < MAX_EDGE_REACH:
            at_top, at_bottom = covered(contacts, i)
            whole = at_top if top == bottom else at_bottom
            s = slope[bottom]
            on = deep > z[bottom] - speed * s
            missing -= whole * s * ((z[bottom] - deep) if on else speed * s)
            if top == bottom:
                continue
            left = 0.5 * (z[bottom] + z[bottom + 1])
        right = z[top] + ahead * (z[top + 1 if top + 1 < z.size else 0] - z[top])
        missing += 0.5 * steps * (right - left) * ((deep - left) + (deep - right))
    return missing


@refcount_free_kernel
def _elastic_sum(contact, deep):
    """Return the sum of (z - d - d') z' under pressure and of vbar z'^2 over what else touches."""
    (z, slope, spans, speed, press), touching = contact.line, contact.touching
    total = 0.0
    for i in range(touching.slope.size):
        s = touching.slope[i]
        on = contact.threshold[i] < deep
        total += touching.weight[i] * s * ((touching.height[i] - deep) if on else speed * s)
    for b in touching.spans:
        j = b * SPAN
        if deep > press[b]:
            lift = deep - z[j]
            total -= (SPAN * lift - spans.rows[b, HEIGHT]) * slope[j]
            total -= lift * spans.rows[b, SLOPE] - spans.rows[b, WORK]
            continue
        for k in range(j, j + SPAN):
            on = z[k] - speed * slope[k] < deep
            total += slope[k] * ((z[k] - deep) if on else speed * slope[k])
    return total
