"""Steady sliding under a given load, without time marching, for elements that remember only u.

At constant d the displacement field moves with the line. One sweep against the motion computes it,
from the deepest sample, which always touches, round the period: w = E u and u = min(w, z - d),
where E is the decay factor of a step. Every -u is a maximum of increasing convex functions of d,
E^k (d - z) of the k-th sample upstream. The total force F(d) is therefore increasing and convex as
well, and Newton's method from the right ends with the exact root.

The number of sweeps is bounded: in exact arithmetic each has fewer touching elements than the one
before, or is the last. If rounding hides the root, sweeps continue as long as each halves the
excess force. There are at most n + log2(first excess / (4e-16 load)) sweeps in total.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..rheology.kelvin import Kelvin
from ..rheology.law import MIN_MAGNITUDE, State, free_displacement
from .contact import excess_at, solve_indentation

EXCESS_TOLERANCE = 4e-16  # relative to the load


@kernel
def sweep(law, z, d, deepest, w):
    """Fill w with the free displacements of steady sliding at indentation d.

    law : of the elastomer, for steps of one sample. deepest : the sample to start from.
    Return (sum of w - (z - d) over touching elements, its derivative with respect to d, count).
    """
    u = z[deepest] - d
    du = 1.0  # -du/dd: 1 in contact, decaying outside
    total = 0.0
    slope = 0.0
    touching = 0
    # Two loops round the period: a single one would test for the end of the line at every sample.
    for first, last in ((deepest - 1, -1), (z.size - 1, deepest - 1)):
        for j in range(first, last, -1):
            free = free_displacement(law, u) if u < -MIN_MAGNITUDE else 0.0
            du = free_displacement(law, du) if du > MIN_MAGNITUDE else 0.0
            gap = z[j] - d
            w[j] = free
            if gap < free:
                total += free - gap
                slope += 1.0 - du
                touching += 1
                u = gap
                du = 1.0
            else:
                u = free
    return total, slope, touching


class PlainSliding(NamedTuple):
    """A steadily sliding line, whose elements are visited one by one."""

    law: Kelvin  # or another of elements that remember u alone, for steps of one sample
    z: np.ndarray  # heights (in h), shape (n,)
    deepest: int  # index of the deepest sample
    w: np.ndarray  # free displacements, shape (n,): filled


@excess_at.register(PlainSliding)
def _excess_of_plain_sliding(contact, load, d):
    law, z, deepest, w = contact
    total, slope, touching = sweep(law, z, d, deepest, w)
    return law.stiffness * total - load, law.stiffness * slope, touching


@kernel
def steady_indentation(elements, load, guess, above, most, close):
    """Return (d, sweeps) of steady sliding under the load sum_i f_i = load (eq. 4).

    elements : a contact of sliding elements, for which excess_at (contact.py) is registered.
    above : whether the guess of d lies to the right of the root, up to rounding.
    most : number of elements. close : tolerance of the excess, relative to the load.
    Eq. 4 is solved in contact.py too, and for internal variables in branches/steady_memory.py.
    """
    d, fewest, least, sweeps = guess, most + 1, np.inf, 0
    while True:
        excess, slope, touching = excess_at(elements, load, d)
        sweeps += 1
        new = d - excess / slope
        # Right of the root the excess falls and fewer elements touch, up to rounding.
        progress = touching < fewest or excess < 0.5 * least
        right = excess > 0.0 and new < d and progress
        if abs(excess) <= close * load or ((above or sweeps > 1) and not right):
            return d, sweeps
        if excess > 0.0:
            fewest, least = min(fewest, touching), min(least, excess)
        d = new


@kernel
def steady_sliding(law, z, load):
    """Return (state, sweeps) of steady sliding of elements that remember only u.

    law : of the elastomer, for steps of one sample (rheology), e.g. Kelvin.
    z : heights (in h), shape (n,). load : n Fbar.
    state : free displacements w, shape (n,), and indentation d (rheology/law.py).
    """
    deepest = int(np.argmin(z))
    elements = PlainSliding(law, z, deepest, np.empty_like(z))
    # F(d) >= sum (d - z)+: the elastic indentation (v -> 0) bounds d from above.
    guess, _ = solve_indentation(z, load, z[deepest] + load / z.size)
    d, sweeps = steady_indentation(elements, load, guess, True, z.size, EXCESS_TOLERANCE)
    return State(elements.w, d), sweeps
