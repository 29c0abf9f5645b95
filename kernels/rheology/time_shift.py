"""Shift of relaxation times with the temperature: laws and measured tables of log10 a_T.

One factor a_T multiplies all times (thermorheologically simple material). It is given by

    log10 a_T = -c1 (T - T_ref)/(c2 + T - T_ref)        Williams, Landel and Ferry
    log10 a_T = E_a/(R ln 10) (1/T - 1/T_ref)           Arrhenius, T in K
    log10 a_T over T, interpolated                      a measured table

The law of Vogel, Fulcher and Tammann, ln a_T = B/(T - T_0) - B/(T_ref - T_0), is the first one
with c2 = T_ref - T_0 and c1 = B/(c2 ln 10).
Source: M. L. Williams, R. F. Landel, J. D. Ferry, J. Am. Chem. Soc. 77, 3701 (1955),
doi:10.1021/ja01619a008.
"""

import math
from typing import NamedTuple, TypeVar

import numpy as np

ZERO_CELSIUS = 273.15  # K
GAS_CONSTANT = 8.314462618  # J/(mol K)
Numbers = TypeVar("Numbers", float, np.ndarray)


class Wlf(NamedTuple):
    """The law of Williams, Landel and Ferry."""

    c1: float
    c2: float  # K
    reference: float  # °C

    @property
    def limits(self) -> tuple[float, float]:
        """Return the temperatures (°C) between which the law holds; the first is the pole."""
        return self.reference - self.c2, math.inf

    def decades(self, temperature: float) -> float:
        """Return log10 a_T at a temperature (°C) above reference - c2."""
        above = temperature - self.reference
        return -self.c1 * above / (self.c2 + above)


def inverse_temperature(temperature: Numbers, reference: float) -> Numbers:
    """Return 1/T - 1/T_ref (1/K) of temperatures in °C."""
    return 1.0 / (temperature + ZERO_CELSIUS) - 1.0 / (reference + ZERO_CELSIUS)


class Arrhenius(NamedTuple):
    """The law of Arrhenius."""

    activation_energy: float  # J/mol
    reference: float  # °C

    @property
    def limits(self) -> tuple[float, float]:
        """Return the temperatures (°C) between which the law holds."""
        return -ZERO_CELSIUS, math.inf

    def decades(self, temperature: float) -> float:
        """Return log10 a_T at a temperature (°C)."""
        decades = self.activation_energy / (GAS_CONSTANT * math.log(10.0))
        return decades * inverse_temperature(temperature, self.reference)


class ShiftTable(NamedTuple):
    """A measured table with linear interpolation."""

    rows: tuple[tuple[float, float], ...]  # temperature (°C), log10 a_T; temperatures ascending
    description: str = ""  # of its file

    @property
    def limits(self) -> tuple[float, float]:
        """Return the temperatures (°C) of the first and the last row."""
        return self.rows[0][0], self.rows[-1][0]

    def decades(self, temperature: float) -> float:
        """Return log10 a_T at a temperature (°C); beyond the table that of its end."""
        return float(np.interp(temperature, *np.transpose(self.rows)))


ShiftLaw = Wlf | Arrhenius | ShiftTable
