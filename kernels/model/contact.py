"""The contact step: the piecewise-linear load balance, solved exactly.

An element touches if its free displacement w exceeds z - d, i.e. if its threshold c = z - w lies
below d. The load balance of eq. 4 (Li et al. 2014) then reads

    sum_i max(0, d - c_i) = target.

The sum is increasing, convex and piecewise linear in the indentation d. Newton's method from the
right passes through nested sets of touching elements. When a set repeats, the root is exact; no
tolerance is needed.

There are at most 2 n + 3 passes over n elements: after the first pass d lies right of the root, and
every later pass has a smaller d and fewer touching elements, or is the last. If rounding carries d
below every threshold, the method restarts once, from the d at which one element carries the load.

A contact is a NamedTuple: springs, or a type that sums over many elements at once (quick/).
Its force at d is dispatched on its type. Eq. 4 is also solved for steady sliding in model/steady.py
and, for internal variables, in branches/steady_memory.py.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import dispatch_on_type, dispatch_refcount_free, kernel, refcount_free_kernel


@dispatch_refcount_free
def excess_at(contact, load, d):
    """Return (excess of the force at d over the load, its derivative with respect to d, count).

    count : number of touching elements, possibly fractional.
    """


@dispatch_on_type
def lowest_threshold(contact, load):
    """Return (lowest threshold, a d at which one element alone would carry the load)."""


@refcount_free_kernel
def indentation_under(contact, load, guess):
    """Return (d at which a contact carries the load > 0 (eq. 4), passes), from any ``guess``.

    d is NaN if the load or the guess is. passes : number of calls of excess_at, 2 to 4 if the
    guess is good.
    """
    d = guess
    fallen = False  # whether d has been below every threshold
    previous = 0.0
    passes = 0
    while True:
        excess, slope, count = excess_at(contact, load, d)
        passes += 1
        if count == 0.0:
            # The d at which one element carries the load is an upper bound.
            lowest, new = lowest_threshold(contact, load)
            if fallen or not new > d:  # the load is below rounding, or not a number
                return np.nextafter(lowest, np.inf) if d <= lowest else d, passes
            fallen = True
        else:
            new = d - excess / slope
            if passes > 1 and (count == previous or not new < d):
                return new, passes
        previous = count
        d = new


class Springs(NamedTuple):
    """Elements of stiffness 1."""

    c: np.ndarray  # contact thresholds z_i - w_i, shape (n,), n > 0, in h


class UnlikeSprings(NamedTuple):
    """Elements with different stiffnesses."""

    c: np.ndarray  # as in Springs
    stiffness: np.ndarray  # s_i > 0, shape (n,)


@excess_at.register(Springs)
def _excess_of_springs(contact, load, d):
    force, count = overlap(contact.c, d)
    return force - load, count, count


@excess_at.register(UnlikeSprings)
def _excess_of_unlike_springs(contact, load, d):
    force, slope, count = weighted_overlap(contact.c, contact.stiffness, d)
    return force - load, slope, count


@lowest_threshold.register(Springs)
def _lowest_of_springs(contact, load):
    lowest = contact.c.min()
    return lowest, lowest + load


@lowest_threshold.register(UnlikeSprings)
def _lowest_of_unlike_springs(contact, load):
    at = np.argmin(contact.c)
    return contact.c[at], contact.c[at] + load / contact.stiffness[at]


@kernel
def solve_indentation(c, load, guess, stiffness=None):
    """Return (d, passes) with sum_i s_i max(0, d - c_i) = load > 0, from any ``guess``.

    c, stiffness : as in UnlikeSprings; stiffness is None if all s_i are 1.
    """
    if stiffness is None:
        return indentation_under(Springs(c), load, guess)
    return indentation_under(UnlikeSprings(c, stiffness), load, guess)


@kernel
def overlap(c, d):
    """Return (sum of d - c_i, count) over the touching elements c_i < d.

    Eight partial sums in a fixed order: fast, and the same bits on every machine.
    """
    s0 = s1 = s2 = s3 = s4 = s5 = s6 = s7 = 0.0
    n0 = n1 = n2 = n3 = n4 = n5 = n6 = n7 = 0.0
    whole = c.size - c.size % 8
    for i in range(0, whole, 8):
        p0, p1, p2, p3 = d - c[i], d - c[i + 1], d - c[i + 2], d - c[i + 3]
        p4, p5, p6, p7 = d - c[i + 4], d - c[i + 5], d - c[i + 6], d - c[i + 7]
        s0 += p0 if p0 > 0.0 else 0.0
        s1 += p1 if p1 > 0.0 else 0.0
        s2 += p2 if p2 > 0.0 else 0.0
        s3 += p3 if p3 > 0.0 else 0.0
        s4 += p4 if p4 > 0.0 else 0.0
        s5 += p5 if p5 > 0.0 else 0.0
        s6 += p6 if p6 > 0.0 else 0.0
        s7 += p7 if p7 > 0.0 else 0.0
        n0 += 1.0 if p0 > 0.0 else 0.0
        n1 += 1.0 if p1 > 0.0 else 0.0
        n2 += 1.0 if p2 > 0.0 else 0.0
        n3 += 1.0 if p3 > 0.0 else 0.0
        n4 += 1.0 if p4 > 0.0 else 0.0
        n5 += 1.0 if p5 > 0.0 else 0.0
        n6 += 1.0 if p6 > 0.0 else 0.0
        n7 += 1.0 if p7 > 0.0 else 0.0
    for i in range(whole, c.size):
        p = d - c[i]
        if p > 0.0:
            s0 += p
            n0 += 1.0
    total = ((s0 + s4) + (s1 + s5)) + ((s2 + s6) + (s3 + s7))
    count = ((n0 + n4) + (n1 + n5)) + ((n2 + n6) + (n3 + n7))
    return total, count


@kernel
def weighted_overlap(c, stiffness, d):
    """Return (sum of s_i (d - c_i), sum of s_i, count) over the touching elements c_i < d."""
    force = 0.0
    slope = 0.0
    count = 0.0
    for i in range(c.size):
        if c[i] < d:
            force += stiffness[i] * (d - c[i])
            slope += stiffness[i]
            count += 1.0
    return force, slope, count
