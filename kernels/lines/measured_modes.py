"""Measured lines: periodic samples, one per element spacing, as one band-limited function.

z(x) = mean + sum_k A_k cos(q_k x + phi_k),  q_k = 2 pi k / L,  k = 1 ... floor(n/2),

is the trigonometric polynomial through the samples. sample_line (self_affine.py) computes its exact
slopes and samples it m times as finely.
"""

import numpy as np

MIN_LINE_SAMPLES = 4  # a shorter line has no meaningful slope


def measured_modes(heights: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return amplitudes (in the unit of the heights) and phases of the line through samples.

    heights : shape (n,), one period. Both results have shape (floor(n/2),). For even n the samples
    determine only the cosine of the Nyquist mode.
    Raises ValueError for samples that are not finite, and for fewer than 4 of them.
    """
    spectrum = _coefficients(heights)
    amplitude = 2.0 * np.abs(spectrum)
    if heights.size % 2 == 0:
        amplitude[-1] /= 2.0
    return amplitude, np.angle(spectrum)


def measured_amplitudes(heights: np.ndarray) -> np.ndarray:
    """Return the rms mode amplitudes of an ensemble of lines, shape (floor(n/2),).

    heights : shape (lines, n). sum A_k^2 / 2 is the mean variance of the lines (Parseval), and
    lines of these amplitudes with random phases have the power spectrum of the ensemble.

    Raises ValueError as measured_modes does.
    """
    spectrum = _coefficients(heights)
    power = 2.0 * np.mean(np.abs(spectrum) ** 2, axis=0)
    if heights.shape[-1] % 2 == 0:
        power[-1] /= 2.0
    return np.sqrt(2.0 * power)


def _coefficients(heights: np.ndarray) -> np.ndarray:
    """Return the complex Fourier coefficients of modes 1 ... floor(n/2) along the last axis."""
    if not np.isfinite(heights).all():
        raise ValueError("the line holds samples that are not finite numbers")
    samples = heights.shape[-1]
    if samples < MIN_LINE_SAMPLES:
        raise ValueError(f"a measured line of {samples} samples: needs {MIN_LINE_SAMPLES} or more")
    return np.fft.rfft(heights, axis=-1)[..., 1:] / samples
