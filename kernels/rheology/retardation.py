"""The retardation form of a material: an element as a glassy spring and Kelvin units in series.

Under a force p an element is displaced by u = -J_g p + sum_k y_k with

    lambda_k dy_k/dt = -y_k - J_k p.

Without force every unit decays exponentially, independently of the others. The retardation times
are -1/s at the zeros s of the modulus G(s) = 1 + sum_b g_b s t_b / (1 + s t_b) + eta s. One zero
lies between 0 and the first pole, one between neighbouring poles, and with a dashpot one beyond
the last pole.
Source: B. Gross, Mathematical Structure of the Theories of Viscoelasticity (Hermann, 1953).
"""

import math
from typing import NamedTuple

import numpy as np

from ..root_search import root_between
from .spectrum import Spectrum

LOG_RANGE = 667.0  # of the distance of a zero from a pole: nearly that of positive numbers


class Retardation(NamedTuple):
    """A material in its retardation form; J_g + sum J_k = 1, the relaxed compliance."""

    glass: float  # J_g G: of the spring; 0 where the material has a dashpot
    compliances: np.ndarray  # J_k G of the units, shape (K,)
    times: np.ndarray  # lambda_k / tau, shape (K,), descending


def retardation(spectrum: Spectrum) -> Retardation:
    """Return the retardation form. Raises ValueError as ``merged_branches`` does."""
    moduli, times = merged_branches(spectrum)
    viscous = spectrum.viscosity > 0.0
    glass = 0.0 if viscous else 1.0 / (1.0 + float(moduli.sum()))
    count = times.size + (1 if viscous else 0)
    units = [_unit(moduli, times, spectrum.viscosity, k) for k in range(count)]
    return Retardation(glass, *np.array(units).T.copy())


def merged_branches(spectrum: Spectrum) -> tuple[np.ndarray, np.ndarray]:
    """Return (moduli, times) of the branches, both (B,), slowest first; equal times are merged.

    Raises ValueError for a material that does not relax, or for values out of range.
    """
    for name, values in (("modulus", spectrum.moduli), ("time", spectrum.times)):
        for value in values:
            if not 0.0 < value < math.inf:
                raise ValueError(f"{name} = {value:g}: that of a branch must be positive, finite")
    if not 0.0 <= spectrum.viscosity < math.inf:
        raise ValueError(f"viscosity = {spectrum.viscosity:g}: must be finite, not negative")
    if not spectrum.moduli and spectrum.viscosity == 0.0:
        raise ValueError("a material needs a branch or a dashpot: without it friction is zero")
    sums: dict[float, float] = {}
    for g, t in sorted(zip(spectrum.moduli, spectrum.times, strict=True)):
        sums[t] = sums.get(t, 0.0) + g
    times = np.array(sorted(sums, reverse=True), float)
    return np.array([sums[t] for t in times], float), times


def _unit(moduli: np.ndarray, times: np.ndarray, viscosity: float, k: int) -> tuple[float, float]:
    """Return (J_k, lambda_k) of the unit whose zero lies between poles k - 1 and k.

    The unknown is the distance of the zero from the nearer pole: a weak branch puts it so close
    that 1 - r t_b would lose all digits. The logarithm of the distance is sought.
    """
    slower = times[k - 1] if k > 0 else math.inf
    faster = times[k] if k < times.size else 0.0
    rate = 0.0 if k == 0 else 1.0 / slower
    if faster == 0.0:  # beyond the last pole: an upper bound from the sum of all moduli
        total = float(moduli.sum())
        half = (1.0 + total) / viscosity + (math.sqrt(total / viscosity * rate) if rate else 0.0)
    else:
        half = 0.5 / faster * (1.0 if k == 0 else (slower - faster) / slower)
    pole, sign = slower, 1.0
    if faster > 0.0 and _modulus(moduli, times, viscosity, pole, half) > 0.0:
        pole, sign = faster, -1.0

    def rise(log_distance: float) -> float:
        return -sign * _modulus(moduli, times, viscosity, pole, sign * math.exp(log_distance))

    highest = math.log(half)
    distance = sign * math.exp(root_between(rise, highest - LOG_RANGE, highest))
    rate, rest = _rate_near_pole(times, pole, distance)
    fall = float(np.sum(moduli * times / rest**2)) + viscosity
    return 1.0 / (rate * fall), 1.0 / rate


def _modulus(
    moduli: np.ndarray, times: np.ndarray, viscosity: float, pole: float, distance: float
) -> float:
    """Return G(-r) = 1 - sum g_b r t_b / (1 - r t_b) - eta r, falling between two poles."""
    rate, rest = _rate_near_pole(times, pole, distance)
    return 1.0 - float(np.sum(moduli * (rate * times) / rest)) - viscosity * rate


def _rate_near_pole(times: np.ndarray, pole: float, distance: float) -> tuple[float, np.ndarray]:
    """Return (r, 1 - r t_b), without cancellation, at a distance from the pole 1/``pole``."""
    apart = np.ones_like(times) if math.isinf(pole) else (pole - times) / pole
    return 1.0 / pole + distance, apart - distance * times
