"""Heat of friction on a map: flux, contact temperature, and steps at this temperature.

The flux into the surface is mu v p, where mu is the sum of viscoelastic friction and shear of the
real contact: shear heat is distributed like the pressure. One temperature acts in a step: the
mean over the contact, weighted with p, halfway between its values before and after the step.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..heat.field import (
    HeatContent,
    HeatedSurface,
    cold_content,
    heat,
    heated_surface,
    steady_heat,
)
from ..heat.heat import Heat
from ..interface.effects import Effects
from ..interface.shear import ShearLaw, shear_stress
from ..rheology.time_shift import ZERO_CELSIUS
from ..root_search import new_secant_search, next_secant_guess
from .body import HalfSpace
from .waves import two_sided, wave_numbers

TEMPERATURE_TOLERANCE = 0.5  # K; a step that warms by up to 1 K is not repeated
DRIVE_TEMPERATURE_TOLERANCE = 1e-4  # K; larger ones let friction jump in the search of a drive
FIRST_WARMING = 100.0  # K, limit of the first change of an assumed temperature
SHEAR_TOLERANCE = 1e-3  # K, of the temperature at which shear acts in steady sliding
MIN_WARMING = 1e-9  # K, smallest change by a secant


class Warmth(NamedTuple):
    """Temperature of a surface at the end of a step."""

    content: HeatContent  # of the field, in the frame of the sliding surface
    rise: np.ndarray  # modes of the rise over the temperature of the scene, in K
    contact: float  # mean over the contact, in °C


class Heating(NamedTuple):
    """Constants of the heating of a map."""

    heat: Heat
    surface: HeatedSurface
    shape: tuple[int, int]  # of the map
    steps_per_spacing: int
    pressure: float  # mean pressure, in E* h/dx
    law: ShearLaw | None  # of the shear, which also heats

    @classmethod
    def of(cls, space: HalfSpace, effects: Effects, min_step: float) -> "Heating | None":
        """Return the heating of a map, or None without heat.

        min_step : shortest step to resolve, in tau.
        """
        heat = effects.heat
        if heat is None:
            return None
        shape, m = space.surface.z.shape, space.surface.steps_per_spacing
        q_y, q_x = wave_numbers(shape, m)
        field = heated_surface(q_y, q_x, heat.diffusivity, heat.block, min_step)
        return cls(heat, field, shape, m, space.pressure, effects.shear)

    def shear(self, area: float, speed: float, temperature: float) -> float:
        """Return the shear part of mu, in h/dx, with the sign of the speed (vbar).

        area : real contact over L^2. temperature : of the contact, in °C.
        """
        if self.law is None:
            return 0.0
        stress = float(shear_stress(self.law, np.array(speed), temperature + ZERO_CELSIUS))
        return float(np.sign(speed)) * stress * area / self.pressure

    def cold(self) -> Warmth:
        """Return the warmth of a surface at the temperature of the scene."""
        rise = np.zeros((self.shape[0], self.shape[1] // 2 + 1), complex)
        return Warmth(cold_content(self.surface), rise, self.heat.temperature)

    def steady(self, p: np.ndarray, mu: float, area: float, speed: float) -> tuple[Warmth, float]:
        """Return the warmth of steady sliding, and its shear part of friction, in h/dx.

        p : pressures at the samples. mu : viscoelastic friction. area : real contact over L^2, not
        used without shear. speed : vbar, signed.
        """
        modes, scene = np.fft.rfft2(p), self.heat.temperature
        unit = self._warmth(*steady_heat(self.surface, speed * modes, speed), modes)
        secants = new_secant_search(scene, FIRST_WARMING, 1.0)
        while True:
            assumed = secants.search.x
            shear = self.shear(area, speed, assumed)
            contact = scene + (mu + shear) * (unit.contact - scene)
            if self.law is not None:
                excess = assumed - contact
                secants = next_secant_guess(secants, assumed, excess, SHEAR_TOLERANCE, MIN_WARMING)
            if self.law is None or secants.search.ended:
                content = unit.content._replace(flux=(mu + shear) * unit.content.flux)
                return Warmth(content, (mu + shear) * unit.rise, contact), shear

    def after_step(self, warmth: Warmth, sliding: "SlidingContact", dt: float) -> Warmth:
        """Return the warmth after a step of length dt (tau)."""
        modes = np.fft.rfft2(sliding.p)
        if sliding.fraction:
            n = self.shape[1]
            modes *= np.exp(2j * np.pi / n * np.arange(n // 2 + 1) * sliding.fraction)
        moved = sliding.moved / self.steps_per_spacing
        flux = sliding.friction * moved / dt * modes
        content, rise = heat(self.surface, warmth.content, flux, moved, dt)
        return self._warmth(content, rise, modes)

    def _warmth(self, content: HeatContent, rise: np.ndarray, p: np.ndarray) -> Warmth:
        """Return the Warmth of a field; p : modes of the pressures."""
        samples = self.shape[0] * self.shape[1]
        total = _scaled_product(rise, self.heat.warming, p, two_sided(self.shape))
        mean = total / (float(p[0, 0].real) * samples)
        return Warmth(content, rise, self.heat.temperature + mean)

    def flash(self, warmth: Warmth) -> float:
        """Return the highest temperature of the surface, in °C."""
        return self.heat.temperature + float(np.fft.irfft2(warmth.rise, self.shape).max())


@kernel
def _scaled_product(rise, factor, p, counts):
    """Multiply rise in place; return its scalar product with p, with two-sided ``counts``."""
    total = 0.0
    for row in range(rise.shape[0]):
        in_row = 0.0
        for column in range(rise.shape[1]):
            value, pressure = factor * rise[row, column], p[row, column]
            rise[row, column] = value
            product = value.real * pressure.real + value.imag * pressure.imag
            in_row += counts[column] * product
        total += in_row
    return total


class SlidingContact(NamedTuple):
    """Contact of an attempted step."""

    result: Any  # of the body
    p: np.ndarray  # pressures at the samples, shape (rows, n)
    friction: float  # over the normal force, in h/dx, with the sign of the motion
    moved: float  # by the surface, in samples, signed
    fraction: float  # shift of the surface beyond its samples, in samples


def heated_step(
    heating: Heating,
    warmth: Warmth,
    dt: float,
    attempt: Callable[[float, float], SlidingContact],
    tolerance: float = TEMPERATURE_TOLERANCE,
) -> tuple[SlidingContact, Warmth, float]:
    """Return (contact, warmth, temperature in °C) of a step of length dt, in tau.

    attempt : (duration over a_T, temperature) -> SlidingContact. tolerance : of the temperature, K.
    Raises ValueError for a temperature out of the range of the shift.
    """
    before = warmth.contact
    secants = new_secant_search(before, FIRST_WARMING, 1.0)
    while True:
        assumed = secants.search.x
        sliding = attempt(dt * float(np.exp(heating.heat.log_rate(assumed))), assumed)
        after = heating.after_step(warmth, sliding, dt)
        excess = assumed - 0.5 * (before + after.contact)
        secants = next_secant_guess(secants, assumed, excess, tolerance, MIN_WARMING)
        if secants.search.ended:
            speed = sliding.moved / heating.steps_per_spacing / dt
            heating.heat.check(after.contact, speed)
            return sliding, after, assumed
