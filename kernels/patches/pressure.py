"""Pressures in the contacts of a steady state: eqs. 3 to 5 by quadrature.

The quadrature of friction.py, which any state has, for a state whose touching samples are listed
(touching.py): a span that is all pressed is known by its sums.
Source: Li et al. (2014), doi:10.1038/srep05795.
"""

from typing import NamedTuple

import numpy as np

from kernels.jit import kernel
from kernels.patches.touching import Touching, covered
from kernels.steady.contacts import AHEAD, BEHIND, LEAST_REACH, MOST_REACH
from kernels.steady.spans import SPAN, Spans


class Pressed(NamedTuple):
    """What touches, and at which speed it is asked how hard."""

    z: np.ndarray  # in h, shape (n,)
    slope: np.ndarray  # in h/dx, shape (n,)
    spans: Spans
    touching: Touching
    speed: float  # vbar
    press: np.ndarray  # largest z - vbar z' of the spans (spans.py)
    threshold: np.ndarray  # z - vbar z' of the listed samples


@kernel
def pressed(z, slope, spans, touching, speed, press, memory):
    """Return Pressed; its thresholds lie in ``memory``."""
    threshold = memory[: touching.at.size]
    for i in range(threshold.size):
        j = touching.at[i]
        threshold[i] = z[j] - speed * slope[j]
    return Pressed(z, slope, spans, touching, speed, press, threshold)


@kernel
def balance(contact, load, guess):
    """Return d + d' so that the pressures (d + d') - z + vbar z' > 0 carry the load (eq. 4).

    As solve_indentation (contact.py), by Newton's method from the right, from any guess.
    """
    deep, before = guess, -1.0
    passes, fallen = 0, False
    while True:
        force, weight = _carried(contact, deep)
        passes += 1
        if weight == 0.0:  # the guess was too low: one sample that carries all is an upper bound
            least = np.inf
            for i in range(contact.threshold.size):
                least = min(least, contact.threshold[i] + load / contact.touching.weight[i])
            if fallen or not least > deep:
                return deep
            deep, fallen = least, True
            continue
        new = deep - (force - load) / weight
        if passes > 1 and (weight == before or not new < deep):
            return new
        before, deep = weight, new


@kernel
def _carried(contact, deep):
    """Return (force, samples) under pressure. Four partial sums in a fixed order."""
    threshold, weight = contact.threshold, contact.touching.weight
    f0 = f1 = f2 = f3 = 0.0
    w0 = w1 = w2 = w3 = 0.0
    whole = threshold.size - threshold.size % 4
    for i in range(0, whole, 4):
        p0, p1 = deep - threshold[i], deep - threshold[i + 1]
        p2, p3 = deep - threshold[i + 2], deep - threshold[i + 3]
        a0, a1 = (weight[i] if p0 > 0.0 else 0.0), (weight[i + 1] if p1 > 0.0 else 0.0)
        a2, a3 = (weight[i + 2] if p2 > 0.0 else 0.0), (weight[i + 3] if p3 > 0.0 else 0.0)
        f0, f1, f2, f3 = f0 + a0 * p0, f1 + a1 * p1, f2 + a2 * p2, f3 + a3 * p3
        w0, w1, w2, w3 = w0 + a0, w1 + a1, w2 + a2, w3 + a3
    for i in range(whole, threshold.size):
        p0 = deep - threshold[i]
        if p0 > 0.0:
            f0 += weight[i] * p0
            w0 += weight[i]
    force, count = (f0 + f1) + (f2 + f3), (w0 + w1) + (w2 + w3)
    z, slope, spans, speed = contact.z, contact.slope, contact.spans, contact.speed
    for b in contact.touching.spans:
        j = b * SPAN
        if deep > contact.press[b]:
            p0 = deep - (z[j] - speed * slope[j])
            force += SPAN * p0 - (spans.height[b] - speed * spans.slope[b])
            count += SPAN
            continue
        for k in range(j, j + SPAN):
            p0 = deep - (z[k] - speed * slope[k])
            if p0 > 0.0:
                force += p0
                count += 1.0
    return force, count


@kernel
def friction(contact, deep):
    """Return (mu, samples under pressure): eq. 5, in h/dx, with pressures as of balance."""
    z, slope, spans, speed = contact.z, contact.slope, contact.spans, contact.speed
    at, weight, numbers = contact.touching
    normal = tangential = count = 0.0
    for i in range(at.size):
        p = deep - contact.threshold[i]
        force = weight[i] * p if p > 0.0 else 0.0
        normal += force
        tangential += force * slope[at[i]]
        count += weight[i] if p > 0.0 else 0.0
    for b in numbers:
        j = b * SPAN
        if deep > contact.press[b]:
            p = deep - (z[j] - speed * slope[j])
            force = SPAN * p - (spans.height[b] - speed * spans.slope[b])
            normal += force
            uneven = p * spans.slope[b] - (spans.work[b] - speed * spans.square[b])
            tangential += force * slope[j] + uneven
            count += SPAN
            continue
        for k in range(j, j + SPAN):
            p = deep - (z[k] - speed * slope[k])
            if p > 0.0:
                normal += p
                tangential += p * slope[k]
                count += 1.0
    return tangential / normal, count


@kernel
def friction_everywhere(z, slope, spans, speed, load):
    """Return (mu, d + d') where the whole line touches and is pressed: its sums are known.

    The mean of the pressures p = (d + d') - z + vbar z' is load / n.
    """
    height, rise, work, square = spans.whole
    excess = (height - speed * rise) / z.size
    p = load / z.size + excess  # at the first sample, which the sums are taken from
    uneven = p * rise - (work - speed * square)
    return slope[0] + uneven / load, p + (z[0] - speed * slope[0])


@kernel
def elastic_part(contact, contacts, deep, steps):
    """Return what sum p z' misses of the friction of steady sliding (friction.py).

    Cell by cell the exact part is a telescoping sum: its ends are the edges of the contact. A
    sample at a trailing edge that is not resolved is left as it is. steps : samples per spacing.
    """
    z, slope, speed = contact.z, contact.slope, contact.speed
    missing = _elastic_sum(contact, deep)
    for i in range(contacts.ends.shape[0]):
        top, bottom = contacts.ends[i, 0], contacts.ends[i, 1]
        ahead, behind = contacts.edges[i, AHEAD], contacts.edges[i, BEHIND]
        left = z[bottom] + behind * (z[bottom - 1] - z[bottom])  # z[-1] is the last sample
        if not LEAST_REACH < behind < MOST_REACH:
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


@kernel
def _elastic_sum(contact, deep):
    """Return the sum of (z - d - d') z' under pressure and of vbar z'^2 over what else touches."""
    z, slope, spans, speed = contact.z, contact.slope, contact.spans, contact.speed
    at, weight, numbers = contact.touching
    total = 0.0
    for i in range(at.size):
        s = slope[at[i]]
        on = contact.threshold[i] < deep
        total += weight[i] * s * ((z[at[i]] - deep) if on else speed * s)
    for b in numbers:
        j = b * SPAN
        if deep > contact.press[b]:
            lift = deep - z[j]
            total -= (SPAN * lift - spans.height[b]) * slope[j]
            total -= lift * spans.slope[b] - spans.work[b]
            continue
        for k in range(j, j + SPAN):
            on = z[k] - speed * slope[k] < deep
            total += slope[k] * ((z[k] - deep) if on else speed * slope[k])
    return total
