"""The power spectrum of lines.

C_1D(q), q > 0, is one-sided and normalised as in the paper (Li et al. (2014), Results):
int C_1D dq = h^2, int C_1D q^2 dq = (grad z)^2. Its unit is m^3 where heights and lengths are in m.
"""

import numpy as np


def power_spectrum(amplitude: np.ndarray, length: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the wave numbers q_k = 2 pi k/L and C_1D(q_k) = A_k^2 / 2 / (2 pi/L) of the modes.

    amplitude : of the modes k = 1 ..., shape (modes,). The sum of C_1D 2 pi/L is sum A_k^2 / 2.
    """
    step = 2.0 * np.pi / length
    return step * np.arange(1.0, amplitude.size + 1), 0.5 * amplitude**2 / step


def rms_height(amplitude: np.ndarray) -> float:
    """Return (sum A_k^2 / 2)^(1/2), in the unit of the amplitudes."""
    return float(np.sqrt(0.5 * np.sum(amplitude**2)))
