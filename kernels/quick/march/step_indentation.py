"""Load balance of one step: listed and summed samples carry the load together."""

from typing import NamedTuple

import numpy as np

from ...compile.jit import refcount_free_kernel
from ...model.contact import excess_at, indentation_under, lowest_threshold, overlap
from ..contacts.pressed_samples import pressure_sums
from .jump_problem import indentation_advance

MAX_SHORT_LIST = 128  # number of samples below which ``overlap`` is faster than ``pressure_sums``
MIN_D_SHARE = 0.1  # smallest predicted d after the first step, over the old d
RATE_FACTOR = 1.2  # predicted change of d, over the change at the rate d' just after the jump


@refcount_free_kernel
def predict_first_indentation(control, problem):
    """Return an estimate of d after the first step that tends to overestimate its change.

    In a step d changes by about d' (1 - E) = d' / K. At almost zero load d' is mere rounding
    error, so the estimate is limited to the d at which a single element carries the load.
    """
    law, d = problem.law, problem.start.d
    new = max(d + RATE_FACTOR * problem.rate / law.stiffness, MIN_D_SHARE * d)
    return min(new, law.decay * d + control.load / law.stiffness)


class PartlyListed(NamedTuple):
    """The contact in a step: thresholds of listed samples, and sums over all others.

    Forces are divided by the stiffness of the law.
    """

    c: np.ndarray  # thresholds of the listed samples
    d_old: float  # indentation before the step
    carried: float  # force of summed samples at ``d_old``
    samples: float  # number of the others


@excess_at.register(PartlyListed)
def _excess_of_partly_listed(contact, load, d):
    if contact.c.size < MAX_SHORT_LIST:
        force, count = overlap(contact.c, d)
    else:
        force, _, count = pressure_sums(contact.c, None, None, d)
    more = contact.samples * (d - contact.d_old)
    slope = count + contact.samples
    return force + more + (contact.carried - load), slope, slope


@lowest_threshold.register(PartlyListed)
def _lowest_of_partly_listed(contact, load):
    lowest = contact.c.min() if contact.c.size > 0 else np.inf
    return lowest, lowest + load


@refcount_free_kernel
def next_indentation(control, law, listed, sums, landings, d, guess):
    """Return (d, D, number of passes over the listed samples) of a step.

    Solves n (D - level) + sum (level - a) + landings + sum max(0, d - c) = load / K (eq. 4).
    landings : number of certain landings, and their overlap at the old d (certain_landings.py).
    d, guess : old d, guess of the new d. The new d is inf if nothing can carry the load.
    """
    load = control.load / law.stiffness - landings[1]
    carried = sums.samples * (d / law.stiffness - sums.level) + sums.depth
    contact = PartlyListed(listed.c, d, carried, sums.samples + landings[0])
    new, passes = indentation_under(contact, load, guess)
    return new, indentation_advance(law, new, d), passes
