"""The Kelvin element, f = -(u + tau du/dt) (eq. 2), in two time schemes.

Both schemes use the same contact step and differ only in three constants.
Source: Li et al. (2014), eqs. 2 and 3, doi:10.1038/srep05795.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

from .law import MIN_MAGNITUDE, free_displacement


class Kelvin(NamedTuple):
    """Constants of one step; K (1 - E) = 1, because an element held at u carries f = -u."""

    decay: float  # E: factor on the displacement of a free element
    stiffness: float  # K (law.py)
    lag: float  # (law.py)


@free_displacement.register(Kelvin)
def _kelvin_displacement(law, u):
    return law.decay * u


def implicit_euler(dt: float) -> Kelvin:
    """Return the step of eqs. 1 and 2 by implicit Euler; ``dt`` in units of tau. First order."""
    return Kelvin(_decay(1.0 / (1.0 + dt)), 1.0 + 1.0 / dt, 0.0)


def exponential(dt: float) -> Kelvin:
    """Return the step of eqs. 1 and 2, solved exactly; ``dt`` in units of tau. Second order.

    u_new = e^-dt u_old - int e^-(dt - s) f(s) ds: the force of the step is the mean of f weighted
    with e^-(dt - s). It acts at the centre of the weight, 1/dt - 1/(e^dt - 1) steps before the end.
    """
    return Kelvin(_decay(math.exp(-dt)), -1.0 / math.expm1(-dt), _weight_centre(dt))


def _decay(value: float) -> float:
    return value if value > math.sqrt(MIN_MAGNITUDE) else 0.0


def _weight_centre(dt: float) -> float:
    if dt < 1e-3:  # avoid the difference of two large numbers
        return 0.5 - dt / 12.0
    if dt > 40.0:
        return 1.0 / dt
    return 1.0 / dt - 1.0 / math.expm1(dt)


SCHEMES: dict[str, Callable[[float], Kelvin]] = {
    "implicit-euler": implicit_euler,
    "exponential": exponential,
}
