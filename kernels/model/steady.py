"""Steady sliding under given load, without time marching, of elements that remember u alone.

At constant d the line carries its own displacement field along. One sweep against the
motion, from the deepest point of the profile (always in contact) round the period, gives it:
w = E u, u = min(w, z - d), E the decay of a step. Every -u is a maximum of increasing convex
functions of d (E^k (d - z) over the k samples upstream), so the total force F(d) is increasing
and convex as well, and Newton's method from the right ends with the exact root.

Sweeps are bounded: in exact arithmetic each has fewer elements touching than the one before,
or is the last. Where rounding hides the root, one more is granted as long as it halves the
excess force: never more than n + log2(first excess / (4e-16 load)) in all.
"""

import numpy as np

from ..compile.jit import kernel
from ..rheology.law import NEGLIGIBLE, State, reach
from .contact import solve_indentation


@kernel
def sweep(law, z, d, deepest, w):
    """Fill w with the free displacements of steady sliding at indentation d.

    law : of the elastomer, for steps of one sample. deepest : the sample to start from.
    Return (sum of w - (z - d) over touching elements, its derivative with respect to d, number).
    """
    u = z[deepest] - d
    du = 1.0  # -du/dd: 1 in contact, decaying outside
    total = 0.0
    slope = 0.0
    touching = 0
    # Two plain loops round the period: a test for the end of the line in one loop costs time.
    for first, last in ((deepest - 1, -1), (z.size - 1, deepest - 1)):
        for j in range(first, last, -1):
            free = reach(law, u) if u < -NEGLIGIBLE else 0.0
            du = reach(law, du) if du > NEGLIGIBLE else 0.0
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


@kernel
def steady_sliding(law, z, load):
    """Return (state, sweeps) of the steady state under the load sum_i f_i = load (eq. 4).

    law : of the elastomer, for steps of one sample (rheology), e.g. Kelvin.
    z : heights (in h), shape (n,). load : n Fbar.
    state : free displacements w, shape (n,), and indentation d (rheology/law.py).
    """
    deepest = np.argmin(z)
    w = np.empty_like(z)
    # F(d) >= sum (d - z)+: the elastic indentation (v -> 0) bounds d from above.
    d, _ = solve_indentation(z, load, z[deepest] + load / z.size)
    fewest = z.size + 1
    least = np.inf
    sweeps = 0
    while True:
        total, slope, touching = sweep(law, z, d, deepest, w)
        sweeps += 1
        excess = law.stiffness * total - load
        new = d - excess / (law.stiffness * slope)
        # From the right every iterate stays right of the root; rounding alone ends this.
        progress = touching < fewest or excess < 0.5 * least
        if not (excess > 4e-16 * load and new < d and progress):
            return State(w, d), sweeps
        fewest = min(fewest, touching)
        least = min(least, excess)
        d = new
