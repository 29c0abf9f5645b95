"""Self-affine random line: one band-limited function, sampled m times per element spacing.

z(x) = sum_k A_k cos(q_k x + phi_k),  q_k = 2 pi k / L,  k = 1 ... floor(N/2),
A_k ~ q_k^-(H + 1/2), fixed amplitudes, uniform random phases. q_max = pi/dx.
Source: Li et al. (2014), Results, below eq. 1 (C_1D ~ q^(-2H-1), q_min = 2 pi/L, q_max = pi/dx).
"""

import numpy as np

NORMALISATIONS = ("modal", "integral")


def mode_numbers(elements: int) -> np.ndarray:
    """Return k = 1 ... floor(N/2) as floats; for even N the last one is the Nyquist mode."""
    return np.arange(1.0, elements // 2 + 1)


def amplitudes(hurst: float, elements: int, normalisation: str = "modal") -> np.ndarray:
    """Return the mode amplitudes A_k in units of the rms roughness h, shape (floor(N/2),).

    ``modal`` makes the sum over modes exact, sum A_k^2 / 2 = 1: every line has rms height h.
    ``integral`` normalises the spectral integral of the paper instead,
    h^2 = int C_1D dq from q_min to q_max; lines are then rougher by 1.04 (H=0) to 1.55 (H=1).
    """
    k = mode_numbers(elements)
    power = k ** (-2.0 * hurst - 1.0)
    if normalisation == "modal":
        total = power.sum()
    elif normalisation == "integral":
        total = _spectral_integral(hurst, k[-1])
    else:
        raise ValueError(f"normalisation = {normalisation!r}: use one of {NORMALISATIONS}")
    return np.sqrt(2.0 * power / total)


def _spectral_integral(hurst: float, k_max: float) -> float:
    """Return int_1^k_max k^(-2H-1) dk."""
    if hurst == 0.0:
        return float(np.log(k_max))
    return float(-np.expm1(-2.0 * hurst * np.log(k_max)) / (2.0 * hurst))


def rms_slope(amplitude: np.ndarray, elements: int) -> float:
    """Return the spectral rms slope, (sum A_k^2 q_k^2 / 2)^(1/2), in units of h/dx."""
    q = 2.0 * np.pi * mode_numbers(elements) / elements
    return float(np.sqrt(0.5 * np.sum((amplitude * q) ** 2)))


def draw_phases(rng: np.random.Generator, elements: int) -> np.ndarray:
    """Return one uniform random phase in [0, 2 pi) per mode, shape (floor(N/2),)."""
    return rng.uniform(0.0, 2.0 * np.pi, elements // 2)


def sample_line(
    amplitude: np.ndarray, phases: np.ndarray, elements: int, steps_per_spacing: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return heights (in h) and slopes (in h/dx) of the line, both of shape (N m,).

    Every m samples the same function: sample j of m = 1 is sample j m of any other m.
    """
    samples = elements * steps_per_spacing
    spectrum = np.zeros(samples // 2 + 1, dtype=complex)
    spectrum[1 : amplitude.size + 1] = 0.5 * samples * amplitude * np.exp(1j * phases)
    q = 2.0 * np.pi * np.arange(spectrum.size) / elements
    derivative = 1j * q * spectrum
    if 2 * amplitude.size == samples:
        # The Nyquist mode of an even grid: its two complex halves fall on one coefficient.
        spectrum[-1] = 2.0 * spectrum[-1].real
        derivative[-1] = 2.0 * derivative[-1].real
    return np.fft.irfft(spectrum, samples), np.fft.irfft(derivative, samples)
