"""Self-affine random line: one band-limited function, sampled m times per element spacing.

z(x) = sum_k A_k cos(q_k x + phi_k),  q_k = 2 pi k / L,  k = 1 ... floor(N/2),
A_k ~ q_k^-(H + 1/2), fixed amplitudes, uniform random phases. q_max = pi/dx.
Source: Li et al. (2014), Results, below eq. 1 (C_1D ~ q^(-2H-1), q_min = 2 pi/L, q_max = pi/dx).
"""

import numpy as np

from ..root_search import root_between

NORMALISATIONS = ("modal", "integral")


def mode_numbers(elements: int) -> np.ndarray:
    """Return k = 1 ... floor(N/2) as floats; for even N the last one is the Nyquist mode."""
    return np.arange(1.0, elements // 2 + 1)


def amplitudes(
    hurst: float,
    elements: int,
    normalisation: str = "modal",
    rolloff: float = 0.0,
    cutoff: int = 0,
) -> np.ndarray:
    """Return the mode amplitudes A_k in units of the rms roughness h, shape (floor(N/2),).

    ``modal`` makes the sum over modes exact, sum A_k^2 / 2 = 1: every line has rms height h.
    ``integral`` normalises the spectral integral of the paper instead,
    h^2 = int C_1D dq from q_min to q_max; without roll-off, lines are then rougher by a factor of
    1.04 (H=0) to 1.55 (H=1).

    rolloff : wave number, in 2 pi/L, below which the spectrum is flat (Persson et al., J. Phys.
        Condens. Matter 17, R1 (2005), doi:10.1088/0953-8984/17/1/R01, long-wave roll-off q_0).
    cutoff : number of the last mode that is not zero; q_max is then 2 pi cutoff/L. A rolloff of
        zero means none, and a cutoff of zero means floor(N/2).

    Raises ValueError for an unknown normalisation, and unless rolloff <= cutoff <= N/2.
    """
    k = mode_numbers(elements)
    last = last_mode(rolloff, cutoff, k.size, normalisation)
    power = np.maximum(k, rolloff) ** (-2.0 * hurst - 1.0)
    power[last:] = 0.0
    total = power.sum()
    if normalisation == "integral":
        flat = max(rolloff, 1.0)
        total = (flat - 1.0) * flat ** (-2.0 * hurst - 1.0)
        total += falling_integral(hurst, flat, k[last - 1])
    return np.sqrt(2.0 * power / total)


def last_mode(rolloff: float, cutoff: int, highest: int, normalisation: str) -> int:
    """Return the number of the last mode that is not zero; raise ValueError as amplitudes does."""
    last = cutoff or highest
    if not (0.0 <= rolloff <= last <= highest):
        raise ValueError(
            f"rolloff = {rolloff:g}, cutoff = {cutoff}: must ascend to N/2 = {highest} or be zero"
        )
    if normalisation not in NORMALISATIONS:
        raise ValueError(f"normalisation = {normalisation!r}: use one of {NORMALISATIONS}")
    return last


def falling_integral(hurst: float, k_flat: float, k_max: float) -> float:
    """Return int k^(-2H-1) dk from k_flat to k_max."""
    ratio = np.log(k_max / k_flat)
    if hurst == 0.0:
        return float(ratio)
    tail = -np.expm1(-2.0 * hurst * ratio) / (2.0 * hurst)
    return float(tail * k_flat ** (-2.0 * hurst))


def power_spectrum(amplitude: np.ndarray, length: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the wave numbers q_k = 2 pi k/L and C_1D(q_k) = A_k^2 / 2 / (2 pi/L) of the modes.

    amplitude : of the modes k = 1 ..., shape (modes,). C_1D is one-sided and normalised as in the
    paper: int C_1D dq = h^2, int C_1D q^2 dq = (grad z)^2. Its unit is m^3 where heights and
    lengths are in m.
    """
    step = 2.0 * np.pi / length
    return step * np.arange(1.0, amplitude.size + 1), 0.5 * amplitude**2 / step


def rms_height(amplitude: np.ndarray) -> float:
    """Return (sum A_k^2 / 2)^(1/2), in the unit of the amplitudes."""
    return float(np.sqrt(0.5 * np.sum(amplitude**2)))


def rms_slope(amplitude: np.ndarray, elements: int) -> float:
    """Return the spectral rms slope, (sum A_k^2 q_k^2 / 2)^(1/2), in units of h/dx."""
    q = 2.0 * np.pi * mode_numbers(elements) / elements
    return float(np.sqrt(0.5 * np.sum((amplitude * q) ** 2)))


def matching_rolloff(hurst: float, elements: int, slope: float) -> float:
    """Return the roll-off (in 2 pi/L) that gives self-affine lines of rms height h a given slope.

    slope : rms slope in h/dx, which increases with the flat part of the spectrum. Raises ValueError
    for a slope below that without roll-off or above that of white noise.
    """

    def slope_of(rolloff: float) -> float:
        return rms_slope(amplitudes(hurst, elements, "modal", rolloff), elements)

    low, high = 1.0, float(elements // 2)
    least, most = slope_of(low), slope_of(high)
    if not least <= slope <= most:
        raise ValueError(
            f"rms slope = {slope:g} h/dx: lines of H = {hurst:g} have {least:.4g} to {most:.4g}"
        )
    return root_between(lambda rolloff: slope_of(rolloff) - slope, low, high)


def draw_phases(rng: np.random.Generator, elements: int) -> np.ndarray:
    """Return one uniform random phase in [0, 2 pi) per mode, shape (floor(N/2),)."""
    return rng.uniform(0.0, 2.0 * np.pi, elements // 2)


def sample_line(
    amplitude: np.ndarray, phases: np.ndarray, elements: int, steps_per_spacing: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return heights (in h) and slopes (in h/dx) of the line, both of shape (N m,).

    The function does not depend on m = steps_per_spacing: sample j for m = 1 is sample j m.
    """
    return sample_modes(amplitude * np.exp(1j * phases), elements, steps_per_spacing)


def sample_modes(
    modes: np.ndarray, elements: int, steps_per_spacing: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return heights and slopes as sample_line, from modes A_k e^(i phi_k), shape (floor(N/2),)."""
    samples = elements * steps_per_spacing
    both = np.zeros((2, samples // 2 + 1), dtype=complex)  # of heights and of slopes
    heights, slopes = both[:, 1 : modes.size + 1]
    np.multiply(0.5 * samples, modes, out=heights)
    np.multiply((2.0j * np.pi / elements) * mode_numbers(elements), heights, out=slopes)
    if 2 * modes.size == samples:
        # The Nyquist mode of an even grid: its two complex halves fall on one coefficient.
        both[:, -1] = 2.0 * both[:, -1].real
    z, slope = np.fft.irfft(both, samples)
    return z, slope
