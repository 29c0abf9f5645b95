"""Persson's theory: closed-form friction and real contact area of a half-space.

Source: B. N. J. Persson, J. Chem. Phys. 115, 3840 (2001), doi:10.1063/1.1388626. Conventions: the
spectrum C(q) is two-sided with int C d^2q = h^2, so that its integral over a region of wave vectors
is the sum of |h_q|^2 there; E*(omega) = E/(1 - nu^2) is the modulus for exp(i omega t). As the
magnification grows, pressures spread and the contact area P falls. The share
S = gamma + (1 - gamma) P^2 of the remaining contact is deformed, with gamma = 1/2. In full contact,
P = S = 1, and the friction is exact.
"""

import math
from typing import NamedTuple

import numpy as np

from ..interface.layer import Layer, compliance_ratio
from ..lines.self_affine import last_mode
from ..rheology.spectrum import Spectrum, complex_modulus
from .surface import ring_amplitudes, ring_integral

GAMMA = 0.5
QUADRANT_ANGLES = 16  # angles per quadrant; the other quadrants follow by symmetry
MAX_LATTICE_ELEMENTS = 512  # a side of more elements has over 10^5 wave vectors
MAX_RINGS = 512  # the modes of a line are binned if there are more
ERF = np.vectorize(math.erf, otypes=[float])


class Waves(NamedTuple):
    """Waves of a surface: wave numbers in 1/dx, and shares of the mean square height."""

    q: np.ndarray  # |q|, ascending
    q_x: np.ndarray  # component along the direction of sliding, not negative
    power: np.ndarray  # in h^2


def waves_of_self_affine(
    hurst: float, elements: int, rolloff: float, cutoff: int, normalisation: str
) -> Waves:
    """Return the waves of a self-affine surface; arguments: see ring_amplitudes.

    Beyond MAX_LATTICE_ELEMENTS per side, rings replace single wave vectors.
    """
    if elements <= MAX_LATTICE_ELEMENTS:
        return waves_of_map(
            ring_amplitudes(hurst, elements, rolloff, cutoff, normalisation), elements
        )
    last = last_mode(rolloff, cutoff, elements // 2, normalisation)
    k = np.arange(1.0, last + 1.0)
    power = 2.0 * np.pi * k * np.maximum(k, rolloff) ** (-2.0 * hurst - 2.0)
    whole = ring_integral(hurst, rolloff, last) if normalisation == "integral" else power.sum()
    return waves_of_line(np.sqrt(2.0 * power / whole), elements)


def waves_of_map(amplitude: np.ndarray, elements: int) -> Waves:
    """Return the waves of a map; amplitude : from ring_amplitudes. elements : per side."""
    rows, columns = amplitude.shape
    k_y = np.fft.fftfreq(rows, 1.0 / rows)[:, None]
    k_x = np.arange(columns)[None, :]
    q = 2.0 * np.pi / elements * np.hypot(k_y, k_x).ravel()
    both = np.where(k_x == 0, 1.0, 2.0) * amplitude**2  # modes with both signs of k_x
    order = np.argsort(q, kind="stable")
    q_x = np.broadcast_to(2.0 * np.pi / elements * k_x, amplitude.shape).ravel()
    return Waves(q[order], q_x[order], both.ravel()[order])


def waves_of_line(amplitude: np.ndarray, elements: int) -> Waves:
    """Return the waves of the isotropic surface whose equivalent line has these amplitudes.

    C_1D = pi q C_2D (lines/equivalent.py): each ring has the mean square height of one mode.
    """
    k = np.arange(1, amplitude.size + 1)
    return waves_of_rings(*_rings(2.0 * np.pi / elements * k, 0.5 * amplitude**2))


def waves_of_rings(q: np.ndarray, power: np.ndarray) -> Waves:
    """Return the waves of an isotropic surface; power : mean square height of each ring q."""
    cosines = np.cos(0.5 * np.pi * (np.arange(QUADRANT_ANGLES) + 0.5) / QUADRANT_ANGLES)
    along = q[:, None] * cosines
    power = np.repeat(power / QUADRANT_ANGLES, QUADRANT_ANGLES)
    return Waves(np.repeat(q, QUADRANT_ANGLES), along.ravel(), power)


def _rings(q: np.ndarray, power: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return (q, power), binned if there are many modes; bins keep power and mean square slope."""
    if q.size <= MAX_RINGS:
        return q, power
    band = (np.log(q / q[0]) / np.log(q[-1] / q[0]) * (MAX_RINGS - 1)).astype(np.int64)
    total, slope = np.bincount(band, power), np.bincount(band, power * q * q)
    filled = total > 0.0
    return np.sqrt(slope[filled] / total[filled]), total[filled]


def persson_theory(
    waves: Waves,
    spectrum: Spectrum,
    pressure: float,
    speed: float,
    layer: Layer | None = None,
) -> tuple[float, float]:
    """Return (coefficient of friction in h/dx, real contact area over the nominal one).

    pressure : nominal, in E* h/dx, with the relaxed E*. speed : v tau/dx, signed. layer : divides
    E* by the ratio of compliances at each |q|, which keeps full contact exact.

        G(q) = (1/8) sum_(q' <= q) q'^2 |h_q'|^2 |E*(q'_x v)/sigma_0|^2,   P = erf(1/(2 sqrt G)),
        mu = (1/2) sum q q_x |h_q|^2 Im E*(q_x v)/sigma_0 P S,   S = gamma + (1 - gamma) P^2
    """
    modulus = complex_modulus(spectrum, waves.q_x * abs(speed)) / pressure
    if layer is not None:
        modulus /= compliance_ratio(layer, waves.q)
    spread = 0.125 * np.cumsum(waves.q**2 * waves.power * np.abs(modulus) ** 2)
    # Waves of equal length share the sum up to the last of them.
    last = np.searchsorted(waves.q, waves.q * (1.0 + 1e-12), side="right") - 1
    contact = ERF(0.5 / np.sqrt(np.maximum(spread[last], 1e-300)))
    share = GAMMA + (1.0 - GAMMA) * contact**2
    lost = waves.q * waves.q_x * waves.power * modulus.imag * contact * share
    return math.copysign(0.5, speed) * float(np.sum(lost)), float(contact[-1])
