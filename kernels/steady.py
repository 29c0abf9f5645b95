"""Steady sliding under given load, without time marching.

At constant d the line carries its own displacement field along. One sweep against the
motion, from the deepest point of the profile (always in contact) round the period, gives it:
w = decay * u, u = min(w, z - d). Every -u is a maximum of increasing convex functions of d
(decay^k (d - z) over the k samples upstream), so the total force F(d) is increasing and
convex as well, and Newton's method from the right ends with the exact root.

Sweeps are bounded: in exact arithmetic each has fewer elements touching than the one before,
or is the last. Where rounding hides the root, one more is granted as long as it halves the
excess force: never more than n + log2(first excess / (4e-16 load)) in all.
"""

import numpy as np

from kernels.contact import solve_indentation
from kernels.jit import kernel
from kernels.schemes import NEGLIGIBLE


@kernel
def sweep(z, d, decay, deepest, c):
    """Fill c with the thresholds z - w of steady sliding at indentation d.

    Return (sum of d - c_i over touching elements, its derivative with respect to d, number).
    """
    u = z[deepest] - d
    du = 1.0  # -du/dd: 1 in contact, decaying outside
    total = 0.0
    slope = 0.0
    touching = 0
    j = deepest
    for _ in range(z.size):
        j = j - 1 if j > 0 else z.size - 1
        w = decay * u
        du *= decay
        if w > -NEGLIGIBLE:
            w = du = 0.0
        gap = z[j] - d
        c[j] = z[j] - w
        if gap < w:
            total += w - gap
            slope += 1.0 - du
            touching += 1
            u = gap
            du = 1.0
        else:
            u = w
    return total, slope, touching


@kernel
def steady_sliding(z, load, decay, stiffness):
    """Return (c, d, sweeps) of the steady state under the load sum_i f_i = load.

    z : heights (in h), shape (n,). load : n Fbar. decay, stiffness : of the step (schemes.py).
    c : contact thresholds z - w, shape (n,); element i touches where c_i < d. d : indentation.
    """
    deepest = np.argmin(z)
    c = np.empty_like(z)
    # F(d) >= sum (d - z)+: the elastic indentation (v -> 0) bounds d from above.
    d, _ = solve_indentation(z, load, z[deepest] + load / z.size)
    fewest = z.size + 1
    least = np.inf
    sweeps = 0
    while True:
        total, slope, touching = sweep(z, d, decay, deepest, c)
        sweeps += 1
        excess = stiffness * total - load
        new = d - excess / (stiffness * slope)
        # From the right every iterate stays right of the root; rounding alone ends this.
        progress = touching < fewest or excess < 0.5 * least
        if not (excess > 4e-16 * load and new < d and progress):
            return c, d, sweeps
        fewest = min(fewest, touching)
        least = min(least, excess)
        d = new
