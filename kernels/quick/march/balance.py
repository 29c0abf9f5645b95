"""The balance of one step: listed samples and those in sums carry the load together."""

import numpy as np

from ...compile.jit import kernel
from ...model.contact import overlap
from .setting import advance

STRIP = 32  # samples, and partial sums
NEARER, FARTHER = 0.1, 1.2  # of d, and of what its rate after the jump foretells of the first step
MOST_PASSES = 100  # a few do; what takes more is left to the plain march


@kernel
def foresee(control, setting):
    """Return d after the first step, or a little beyond.

    d follows d' as an element in contact does, by 1 - E = 1 / K in a step. Under next to no load
    the rate is rounding, but one element could carry all of it.
    """
    law, d = setting.law, setting.start.d
    new = max(d + FARTHER * setting.rate / law.stiffness, NEARER * d)
    return min(new, law.decay * d + control.load / law.stiffness)


@kernel
def settle(control, law, lists, sums, others, d, guess):
    """Return (d, push, passes): the new indentation, D of the samples in sums, passes over c.

    Solves n (D - level) + sum (level - a) + sum max(0, d - c) = load / K.
    others : how many samples are landings, and their overlap were d to stay. d : the old
    indentation. guess : of the new one. d is NaN where no balance was found.
    """
    target = control.load / law.stiffness - others[1]
    slope = sums.samples + others[0]
    new, passes = _root(law, lists.c, sums, slope, target, d, guess)
    return new, advance(law, new, d), passes


@kernel
def _root(law, c, sums, slope, target, d, guess):
    """Return (new, passes), the root of the balance by Newton's method.

    The left side is increasing and convex in d, and linear but for the listed samples: right of
    the root every pass has fewer of them touching, or is the last (contact.py).
    slope : how the part of the samples in sums grows with d.
    """
    base = sums.samples * (d / law.stiffness - sums.level) + sums.depth - target  # were d to stay
    now, before, fallen = guess, -1.0, c.size == 0
    for passes in range(1, MOST_PASSES):
        force, count = overlap_of(c, now)
        steep = count + slope
        if steep == 0.0:  # below every threshold: one element that carries all is above the root
            if fallen:
                break
            now, fallen = c.min() + target, True
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
