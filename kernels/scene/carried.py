"""Branches that a moving surface carries along from the start of a scene with start = "relaxed".

A relaxed contact imprints itself on every branch. On a periodic line or map, a branch that outlives
the time of one period would meet its imprint again every period, unlike on a real surface. It
therefore starts as the motion leaves it: a displacement D(x - X(t)) stretches the spring of
branch b in the wave q to

    e_b(q) = D(q) i omega t_b/(1 + i omega t_b),    omega = -q_x v,

where v is the mean velocity of the first leg. This is steady sliding of a material of these
branches alone; all others are relaxed. Nothing is carried along by a motion that covers no period,
or whose first leg is a hold or an oscillation about rest.
"""

import math
from typing import Any, NamedTuple

import numpy as np

from ..motion.extent import leg_mean_speed, programme_extent
from ..motion.legs import Programme
from ..rheology.law import displacement, rest_memory
from ..rheology.spectrum import Spectrum
from ..rheology.stretches import branch_stretches, stretch_branches

MAX_REMEMBERED = 0.01  # share of its first contact that a branch may hold for a period


class CarriedBranches(NamedTuple):
    """Branches that outlive a period, and the velocity at which they are carried along."""

    spectrum: Spectrum  # of these branches alone
    speed: float  # signed, in dx/tau


def carried_branches(
    start: str, spectrum: Spectrum, programme: Programme, elements: float
) -> CarriedBranches | None:
    """Return the branches that a scene carries along, or None; elements : per period."""
    if start != "relaxed" or programme_extent(programme)[0] <= elements:
        return None
    speed = leg_mean_speed(programme[0])
    if speed == 0.0:
        return None
    longest = elements / abs(speed) / -math.log(MAX_REMEMBERED)
    slow = [b for b, time in enumerate(spectrum.times) if time > longest]
    if not slow:
        return None
    moduli, times = (tuple(values[b] for b in slow) for values in spectrum[:2])
    return CarriedBranches(Spectrum(moduli, times, 0.0), speed)


def carried_memory(
    form: Any, carried: CarriedBranches, slow_form: Any, memory: np.ndarray, p: np.ndarray
) -> np.ndarray:
    """Return the memory of elements whose slow branches are carried along, shape (M, n).

    form : of the whole material. slow_form, memory, p (n,) : form of the slow branches alone, and
    the elements in steady sliding of a material of this form.
    """
    u = displacement(slow_form, memory, p)
    whole = rest_memory(form, -u)
    stretches = branch_stretches(carried.spectrum, slow_form, memory, u)
    stretch_branches(carried.spectrum, form, whole, stretches)
    return whole
