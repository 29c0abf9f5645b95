"""Steady sliding under given load, without time marching.

At constant d the line carries its own displacement field along. One sweep against the
motion, from the deepest point of the profile (always in contact) round the period, gives it:
w = decay * u, u = min(w, z - d). Every -u is a maximum of increasing convex functions of d
(decay^k (d - z) over the k samples upstream), so the total force F(d) is increasing and
convex as well, and Newton's method from the right ends with the exact root.
"""

import numpy as np

from kernels.contact import solve_indentation
from kernels.jit import kernel

# A decayed displacement is zero long before it reaches subnormal numbers, which cost 10x.
NEGLIGIBLE = 1e-290


@kernel
def sweep(z, d, decay, deepest, c):
    """Fill c with the thresholds z - w of steady sliding at indentation d.

    Return (sum of d - c_i over touching elements, its derivative with respect to d).
    """
    u = z[deepest] - d
    du = 1.0  # -du/dd: 1 in contact, decaying outside
    total = 0.0
    slope = 0.0
    j = deepest
    for _ in range(z.size):
        j = j - 1 if j > 0 else z.size - 1
        w = decay * u if u < -NEGLIGIBLE else 0.0
        du *= decay
        gap = z[j] - d
        c[j] = z[j] - w
        if gap < w:
            total += w - gap
            slope += 1.0 - du
            u = gap
            du = 1.0
        else:
            u = w
    return total, slope


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
    sweeps = 0
    while True:
        total, slope = sweep(z, d, decay, deepest, c)
        sweeps += 1
        excess = stiffness * total - load
        new = d - excess / (stiffness * slope)
        # From the right every iterate stays right of the root; rounding alone ends this.
        if not (excess > 4e-16 * load and new < d):
            return c, d, sweeps
        d = new
