"""Heating of the elastomer by friction: constants of a scene."""

import math
from typing import NamedTuple

from ..rheology.time_shift import ShiftLaw


class Heat(NamedTuple):
    """Heating of a scene; hashable, because it is part of keys."""

    warming: float  # share E* h^2/(k tau), K: rise by the flux E* h^2/(dx tau) at q = 1/dx
    diffusivity: float  # of heat, k/(rho c), in dx^2/tau
    block: float  # thickness of a block heated by the mean flux, in dx; 0: none
    shift: ShiftLaw  # of the relaxation times
    temperature: float  # of the scene, to which tau belongs, in °C
    speed_unit: float  # dx/tau, in m/s

    def log_rate(self, temperature: float) -> float:
        """Return the logarithm of the factor by which relaxation is faster than in the scene."""
        decades = self.shift.decades(self.temperature) - self.shift.decades(temperature)
        return math.log(10.0) * decades

    def check(self, temperature: float, speed: float) -> None:
        """Raise ValueError for a temperature (°C) out of the range of the shift; speed : vbar."""
        low, high = self.shift.limits
        if not low < temperature <= high:
            raise ValueError(
                f"heat: at v = {abs(speed) * self.speed_unit:.4g} m/s the contact reaches "
                f"{temperature:.4g} °C, out of the range of the shift of relaxation times, "
                f"{low:g} to {high:g} °C"
            )
