"""The bounds of d and D that a march takes for granted: guessed, and checked at every step."""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from .given import advance

LEAST_SPREAD = 1e-11  # of d: rounding stays far below it


class Bounds(NamedTuple):
    """Between which values d and D(t) = d(t) - E d(t - 1) are taken to stay, both in h."""

    low: float  # of d
    high: float
    least: float  # of D
    most: float


NOTHING = Bounds(np.inf, -np.inf, np.inf, -np.inf)  # seen so far


@kernel
def are_within(bounds, d, advanced):
    """Return whether d and D, here ``advanced``, lie within the bounds; NaN does not."""
    return bounds.low < d < bounds.high and bounds.least < advanced < bounds.most


@kernel
def bounds_of(law, lowest, highest, least, most, margin):
    """Return the Bounds around values of d and of D, farther out by ``margin`` of their spread.

    D of any d that stays where it is, d / K, lies within them.
    """
    wide = margin * max(highest - lowest, LEAST_SPREAD * highest)
    low, high = max(lowest - wide, 0.0), highest + wide
    least, most = min(least, low / law.stiffness), max(most, high / law.stiffness)
    wide = margin * max(most - least, LEAST_SPREAD * highest)
    return Bounds(low, high, least - wide, most + wide)


@refcount_free_kernel
def first_bounds(march, d, margin):
    """Return the Bounds of a whole march, of which the first step takes d to ``d`` or nearby."""
    one, two = march.start.d, march.end.d
    advanced = advance(march.law, d, one)
    return bounds_of(march.law, min(one, two, d), max(one, two, d), advanced, advanced, margin)


@kernel
def widened(law, bounds, d, advanced, margin):
    """Return Bounds that hold also d and D, here ``advanced``, as a march left them."""
    lowest, highest = min(bounds.low, d), max(bounds.high, d)
    least, most = min(bounds.least, advanced), max(bounds.most, advanced)
    return bounds_of(law, lowest, highest, least, most, margin)


@kernel
def including(seen, d, advanced):
    """Return Bounds that hold values seen so far, and d and D, here ``advanced``."""
    low, high = min(seen.low, d), max(seen.high, d)
    return Bounds(low, high, min(seen.least, advanced), max(seen.most, advanced))
