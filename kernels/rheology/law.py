"""What a law of the elastomer must provide. A file beside this one holds one law.

A law is a NamedTuple of the constants of one time step. Two fields are common to all:

stiffness   A free element would reach w in the step. The step's force is stiffness * (w - u)
            in units of 4 G dx h, where u is the displacement at its end.
lag         Where within the step this force acts, as a fraction of the step before its end:
            the slope that weighs it is read there.

The functions declared here are reached by the type of the law.
"""

from typing import NamedTuple

import numpy as np

from kernels.jit import by_type

# What decays below this is zero: subnormal numbers would slow a sweep tenfold. Below its root
# so is the decay of one step, whose product with what is left then stays a normal number.
NEGLIGIBLE = 1e-200


class State(NamedTuple):
    """What the elements of a line remember from one step to the next."""

    w: np.ndarray  # shape (n,): displacements they would have without force, in h
    d: float  # indentation, in h; element i touches where z_i - w_i < d, at u_i = z_i - d


@by_type
def reach(law, u):
    """Return the displacement of an element one step after u, if no force acts on it."""
