"""Constant normal force with eq. 3 as printed, without the force of the indentation rate.

For comparison with Li et al. (2014), doi:10.1038/srep05795: eq. 3 has v z' for the rate of an
element in contact, where u = z - d moves at v z' - d'. Defined for the Kelvin element alone.
"""

from typing import NamedTuple

import numpy as np

from ..model.balance import balance, balance_history
from ..model.contact import solve_indentation


class PrintedForce(NamedTuple):
    """Control that balances the load by eq. 3 as printed."""

    load: float  # sum of the forces of all elements, n Fbar


@balance_history.register(PrintedForce)
def _held(control, c, d, first, rings):
    """Return the samples whose element was in contact one sample upstream."""
    held = np.zeros(c.size, np.bool_)
    for s in range(first.size - 1):
        for i in range(first[s], first[s + 1] - 1):
            held[i] = c[i + 1] < d
    if rings.at[-1] == 1:  # no gap anywhere: the sample upstream of the last one is the first
        held[-1] = c[0] < d
    return held


@balance.register(PrintedForce)
def _balance(control, law, z, c, history, d, step):
    """Balance the load if held elements move with the line but not with the indentation.

    Their last displacement is taken as z - d with the new d, so that the rate of d costs no force.
    The force of a held element is then d - (z_i - E z_(i+1)) / (1 - E), with the decay E, because
    K (1 - E) = 1. c is made consistent with the new d.
    """
    held = history
    threshold = c.copy()
    weight = np.full(c.size, law.stiffness)
    for i in range(c.size):
        if held[i]:
            ahead = z[i + 1 if i + 1 < z.size else 0]
            threshold[i] = (z[i] - law.decay * ahead) / (1.0 - law.decay)
            weight[i] = 1.0
    d, passes = solve_indentation(threshold, control.load, d, weight)
    for i in range(c.size):
        if held[i]:
            c[i] = z[i] - law.decay * (z[i + 1 if i + 1 < z.size else 0] - d)
    return d, passes
