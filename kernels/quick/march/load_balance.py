"""The balance of one step: listed samples and those in sums carry the load together."""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...model.contact import excess_at, indentation_under, lowest_threshold, overlap
from ..contacts.pressed import weighed_side_by_side
from .given import advance

FEW = 128  # samples, below which overlap is quicker
NEARER, FARTHER = 0.1, 1.2  # of d, and of what its rate after the jump foretells of the first step


@refcount_free_kernel
def foresee(control, march):
    """Return d after the first step, or a little beyond.

    d follows d' as an element in contact does, by 1 - E = 1 / K in a step. Under next to no load
    the rate is rounding, but one element could carry all of it.
    """
    law, d = march.law, march.start.d
    new = max(d + FARTHER * march.rate / law.stiffness, NEARER * d)
    return min(new, law.decay * d + control.load / law.stiffness)


class PartlyListed(NamedTuple):
    """What touches in a step: listed samples one by one, the others by what they carry at ``old``.

    All in units of the stiffness of the law.
    """

    c: np.ndarray  # thresholds of the listed samples
    old: float  # an indentation
    carried: float  # at it, by the others
    samples: float  # how many these are


@excess_at.register(PartlyListed)
def _excess_of_partly_listed(contact, load, d):
    force, count = overlap_of(contact.c, d)
    more = contact.samples * (d - contact.old)
    slope = count + contact.samples
    return force + more + (contact.carried - load), slope, slope


@lowest_threshold.register(PartlyListed)
def _lowest_listed(contact, load):
    lowest = contact.c.min() if contact.c.size > 0 else np.inf
    return lowest, lowest + load


@refcount_free_kernel
def next_indentation(control, law, lists, sums, more, d, guess):
    """Return (d, advanced, passes): the new indentation, D of the samples in sums, passes over c.

    Solves n (D - level) + sum (level - a) + sum max(0, d - c) = load / K (eq. 4).
    more : how many samples touch beside both, and their overlap were d to stay (landings.py).
    d : the old indentation. guess : of the new one. d is infinite where nothing can carry the load.
    """
    load = control.load / law.stiffness - more[1]
    carried = sums.samples * (d / law.stiffness - sums.level) + sums.depth
    contact = PartlyListed(lists.c, d, carried, sums.samples + more[0])
    new, passes = indentation_under(contact, load, guess)
    return new, advance(law, new, d), passes


@kernel
def overlap_of(c, d):
    """Return (sum of d - c_i, number) over the touching elements c_i < d, as overlap does."""
    if c.size < FEW:
        return overlap(c, d)
    depth, _, touching = weighed_side_by_side(c, None, None, d)
    return depth, touching
