"""Constant normal force with eq. 3 as printed, without the force of the indentation rate.

This control serves for comparison with Li et al. (2014), doi:10.1038/srep05795. Their eq. 3 uses
the rate v z' for an element in contact, but u = z - d has the rate v z' - d'. Kelvin elements only.
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
    """Return a mask of the samples whose element was in contact one sample upstream."""
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

    Their last displacement is taken as z - d with the new d, so that the rate of d adds no force.
    The force of a held element is then d - (z_i - E z_(i+1)) / (1 - E), where E is the decay,
    because K (1 - E) = 1. Finally, c is made consistent with the new d.
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
