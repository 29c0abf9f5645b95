"""Forces of a body from the sums of eq. 5."""

import numpy as np

from ..compile.jit import inlined_kernel
from ..model.friction import weighted_sums
from .step import Forces


@inlined_kernel
def mean_forces(sums, n):
    """Return the Forces of n elements; sums : of weighted_sums (model/friction.py)."""
    normal, tangential, touching = sums
    mu = tangential / normal if normal > 0.0 else np.nan
    return Forces(mu, normal / n, tangential / n, touching / n)


def forces_at_start(p: np.ndarray, slope: np.ndarray, lag: float) -> Forces:
    """Return the Forces of the steady step before a programme.

    p, slope : shape (n,) of a line or (rows, n) of a map, the last axis along x. lag : of the step,
    signed like its velocity; 0 without one.
    """
    earlier = np.roll(slope, -1 if lag > 0.0 else 1, axis=-1)
    acting = (slope + abs(lag) * (earlier - slope)).ravel()
    return mean_forces(weighted_sums(-p.ravel(), None, acting, 0.0), p.size)
