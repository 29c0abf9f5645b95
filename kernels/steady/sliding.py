"""The indentation of steady sliding under a load, found with spans.

The force F(d) is increasing and convex (plain.py), so Newton's method from the right keeps right
of the root and from the left jumps there. It begins with steps that are exact where F is a power
of d: those need no good guess.
"""

import numpy as np

from kernels.contact import solve_indentation
from kernels.jit import kernel
from kernels.steady.carry import carry

POWER_STEPS = 2
CLOSE = 4e-15  # of the load: what may be left of an excess
FEW = 512  # samples of a line that are asked where an elastic foundation would be


@kernel
def elastic_guess(z, deepest, load):
    """Return about the indentation of elastic contact, from few samples. load : n Fbar."""
    step = max(1, z.size // FEW)
    some = z[deepest % step :: step]
    share = load / z.size * some.size
    d, _ = solve_indentation(some, share, z[deepest] + share / some.size)
    return d


@kernel
def indentation(decay, z, spans, stay, load, guess, contacts):
    """Return (d, sweeps, pieces) of steady sliding under the load n Fbar; contacts are filled.

    decay, z, spans, stay, contacts : as of carry. guess > 0.
    """
    d = guess
    least, fewest = np.inf, z.size + 1
    right = False  # of the root, as every step of Newton's method leads
    sweeps = 0
    while True:
        total, slope, touching, pieces = carry(decay, z, spans, stay, d, contacts)
        sweeps += 1
        excess = total - load
        if abs(excess) <= CLOSE * load:
            return d, sweeps, pieces
        if sweeps <= POWER_STEPS:
            d *= (load / total) ** (total / (slope * d))
            continue
        new = d - excess / slope
        # Right of the root the excess falls and fewer elements touch, up to rounding.
        progress = touching < fewest or excess < 0.5 * least
        if right and not (excess > 0.0 and new < d and progress):
            return d, sweeps, pieces
        if excess > 0.0:
            fewest, least = min(fewest, touching), min(least, excess)
        right = True
        d = new
