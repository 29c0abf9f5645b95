"""Time schemes. All share one contact step and differ in three numbers only.

A free element would reach w = decay * u_old in one step of length dt. The step's force is
stiffness * (w - u_new) in units of 4 G dx h. ``lag`` says where within the step this force
acts, as a fraction of the step before its end: the slope that weighs it is read there.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

# What decays below this is zero: subnormal numbers would slow a sweep tenfold. Below its root
# so is the decay of one step, whose product with what is left then stays a normal number.
NEGLIGIBLE = 1e-200
# Shortest step, in units of tau: displacements change by dt of themselves in a step, so that
# rounding, 1e-16 of them, comes back as 1e-16 / dt of the force.
SHORTEST = 1e-10


class Step(NamedTuple):
    """Constants of one time step."""

    decay: float
    stiffness: float
    lag: float


def implicit_euler(dt: float) -> Step:
    """Return the step of the implicit Euler scheme; ``dt`` in units of tau. First order."""
    return Step(_decay(1.0 / (1.0 + dt)), 1.0 + 1.0 / dt, 0.0)


def exponential(dt: float) -> Step:
    """Return the step of the exponential scheme; ``dt`` in units of tau. Second order.

    u_new = e^-dt u_old - int e^-(dt - s) f(s) ds: the step's force is the mean of f weighted
    with e^-(dt - s), so it acts at the centre of that weight, 1/dt - 1/(e^dt - 1) before the end.
    """
    return Step(_decay(math.exp(-dt)), -1.0 / math.expm1(-dt), _weight_centre(dt))


def _decay(value: float) -> float:
    return value if value > math.sqrt(NEGLIGIBLE) else 0.0


def _weight_centre(dt: float) -> float:
    if dt < 1e-3:  # the difference of two large numbers otherwise
        return 0.5 - dt / 12.0
    if dt > 40.0:
        return 1.0 / dt
    return 1.0 / dt - 1.0 / math.expm1(dt)


SCHEMES: dict[str, Callable[[float], Step]] = {
    "implicit-euler": implicit_euler,
    "exponential": exponential,
}
