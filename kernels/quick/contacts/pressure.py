"""Pressure and friction in the contacts of a steady state: eqs. 3 to 5 by quadrature.

The quadrature of model/friction.py works for any state. This version is for a state whose touching
samples are listed (touching_samples.py): a span that is pressed everywhere contributes its sums.
Eq. 5 is also summed in model/friction.py and, as the mean over a step, in march/active.py. Eq. 4
is solved by model/contact.py.
Source: Li et al. (2014), doi:10.1038/srep05795.
"""

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...model.contact import excess_at, lowest_threshold
from ...model.friction import MAX_EDGE_REACH, MIN_EDGE_REACH
from ..steady.contact_pieces import LEADING, LEADING_REACH, TRAILING, TRAILING_REACH
from ..steady.spans import FIRST_SLOPE, HEIGHT_SUM, SLOPE_SUM, SPAN, SQUARE_SUM, WORK_SUM
from .pressed_samples import PressedContact, pressure_sums, span_sums
from .touching_samples import covered_shares


@excess_at.register(PressedContact)
def _excess_of_pressed(contact, load, d):
    threshold, weight = contact.threshold, contact.touching.weight
    force, _, count = pressure_sums(threshold, weight, None, d)
    more, _, others = pressure_sums(contact.loose_threshold, None, None, d)
    force, count = force + more, count + others
    line = contact.line
    for i in range(contact.spans.size):
        b = contact.spans[i]
        if d > line.thresholds[b]:
            force += SPAN * (d - contact.first_threshold[i]) - contact.threshold_sum[i]
            count += SPAN
        else:
            more, _, others = span_sums(line, b, d)
            force, count = force + more, count + others
    return force - load, count, count


@lowest_threshold.register(PressedContact)
def _lowest_of_pressed(contact, load):
    lowest = bound = np.inf
    for i in range(contact.threshold.size):
        lowest = min(lowest, contact.threshold[i])
        bound = min(bound, contact.threshold[i] + load / contact.touching.weight[i])
    return lowest, bound


@refcount_free_kernel
def contact_friction(contact, deep):
    """Return (mu by eq. 5, in h/dx, number of pressed samples). deep : d + d'.

    The sums are those of ``weighted_sums`` (model/friction.py); spans that are pressed everywhere
    contribute stored sums.
    """
    touching, line = contact.touching, contact.line
    normal, tangential, count = pressure_sums(
        contact.threshold, touching.weight, touching.slope, deep
    )
    more, along, others = pressure_sums(contact.loose_threshold, None, contact.loose_slope, deep)
    normal, tangential, count = normal + more, tangential + along, count + others
    rows, speed = line.spans.rows, line.speed
    for i in range(contact.spans.size):
        b = contact.spans[i]
        if deep > line.thresholds[b]:
            p = deep - contact.first_threshold[i]
            more, others = SPAN * p - contact.threshold_sum[i], float(SPAN)
            row = rows[b, SLOPE_SUM], rows[b, WORK_SUM], rows[b, SQUARE_SUM]
            along = more * rows[b, FIRST_SLOPE] + _relative_work(p, row, speed)
        else:
            more, along, others = span_sums(line, b, deep)
        normal, tangential, count = normal + more, tangential + along, count + others
    return tangential / normal, count


@kernel
def _relative_work(p, sums, speed):
    """Return the sum of p (z' - s0) over samples that are all pressed; s0 : slope of the first.

    p : pressure at the first sample. sums : SLOPE_SUM, WORK_SUM and SQUARE_SUM (spans.py).
    """
    slope, work, square = sums
    return p * slope - (work - speed * square)


@refcount_free_kernel
def whole_line_friction(z, slope, spans, speed, load):
    """Return (mu, d + d') of a line that touches and is pressed everywhere, from its sums.

    The mean of the pressures p = (d + d') - z + vbar z' is load / n.
    """
    height, rise, work, square = spans.line_sums
    excess = (height - speed * rise) / z.size
    p = load / z.size + excess  # at the first sample, the reference of the sums
    relative = _relative_work(p, (rise, work, square), speed)
    return slope[0] + relative / load, p + (z[0] - speed * slope[0])


@refcount_free_kernel
def elastic_part(contact, contacts, deep, steps):
    """Return the correction of sum p z' in steady sliding; see elastic_correction (model/friction).

    Over the cells of a contact the exact elastic part telescopes: only its edges remain.
    A sample at an unresolved trailing edge is not corrected. steps : samples per spacing.
    """
    z, slope, speed = contact.line.z, contact.line.slope, contact.line.speed
    missing = _elastic_sum(contact, deep)
    for i in range(contacts.ends.shape[0]):
        leading, trailing = contacts.ends[i, LEADING], contacts.ends[i, TRAILING]
        ahead, behind = contacts.edges[i, LEADING_REACH], contacts.edges[i, TRAILING_REACH]
        left = z[trailing] + behind * (z[trailing - 1] - z[trailing])  # z[-1] is the last sample
        if not MIN_EDGE_REACH < behind < MAX_EDGE_REACH:
            at_leading, at_trailing = covered_shares(contacts, i)
            share = at_leading if leading == trailing else at_trailing
            s = slope[trailing]
            pressed = deep > z[trailing] - speed * s
            missing -= share * s * ((z[trailing] - deep) if pressed else speed * s)
            if leading == trailing:
                continue
            left = 0.5 * (z[trailing] + z[trailing + 1])
        right = z[leading] + ahead * (z[leading + 1 if leading + 1 < z.size else 0] - z[leading])
        missing += 0.5 * steps * (right - left) * ((deep - left) + (deep - right))
    return missing


@refcount_free_kernel
def _elastic_sum(contact, deep):
    """Return the sum of (z - deep) z' over pressed and vbar z'^2 over other touching samples.

    deep : d + d'.
    """
    (z, slope, spans, speed, thresholds), touching = contact.line, contact.touching
    total = 0.0
    for i in range(touching.slope.size):
        s = touching.slope[i]
        pressed = contact.threshold[i] < deep
        total += touching.weight[i] * s * ((touching.height[i] - deep) if pressed else speed * s)
    for b in touching.spans:
        j = b * SPAN
        if deep > thresholds[b]:
            depth = deep - z[j]
            total -= (SPAN * depth - spans.rows[b, HEIGHT_SUM]) * slope[j]
            total -= depth * spans.rows[b, SLOPE_SUM] - spans.rows[b, WORK_SUM]
            continue
        for k in range(j, j + SPAN):
            pressed = z[k] - speed * slope[k] < deep
            total += slope[k] * ((z[k] - deep) if pressed else speed * slope[k])
    return total
