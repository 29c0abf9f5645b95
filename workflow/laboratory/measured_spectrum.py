"""Power spectrum of a measured surface, its moments, and their standard errors."""

from typing import NamedTuple

import numpy as np

from ...kernels import power_spectrum
from ..study import Profile
from .estimate import Estimate


class MeasuredSpectrum(NamedTuple):
    """C_1D(q) of lines (m^3), or C_2D(q) of a map over rings of wave vectors (m^4), shape (n,)."""

    q: np.ndarray  # 1/m, ascending
    density: np.ndarray  # C(q)
    modes: np.ndarray  # number of modes in each mean
    area: np.ndarray  # dq, or the area of a ring: sum C area = h^2
    falling: int  # C ~ q^-(2 H + falling): 1 for lines, 2 for maps

    def slopes(self) -> np.ndarray:
        """Return the rms slope of all waves up to each q; for maps that of the full gradient."""
        return np.sqrt(np.cumsum(self.density * self.area * self.q**2))

    def height_error(self, mode_variance: float) -> float:
        """Return the relative standard error of h as that of a longer surface of this spectrum.

        mode_variance : relative variance of C of a single mode.
        """
        variance = mode_variance / self.modes
        power = self.density * self.area
        return float(0.5 * np.sqrt(np.sum(power**2 * variance / (1.0 + variance))) / power.sum())


def spectrum_of(profile: Profile) -> MeasuredSpectrum:
    """Return the mean spectrum of the periodic lines, or of the map, of a profile."""
    amplitudes, lines = profile.amplitudes, len(profile.heights)
    if profile.heights.ndim == 2:
        q, density = power_spectrum(amplitudes, profile.length)
        return MeasuredSpectrum(q, density, np.full(q.size, lines), np.full(q.size, q[0]), 1)
    highest, step = amplitudes.shape[1] - 1, 2.0 * np.pi / profile.length
    k_x = np.arange(highest + 1)
    k_y = np.fft.fftfreq(len(amplitudes), 1.0 / len(amplitudes))
    k = np.hypot(k_y[:, None], k_x).ravel()
    modes = np.broadcast_to(np.where(k_x > 0, 2.0, 1.0), amplitudes.shape).ravel()
    ring = np.rint(k).astype(int)
    # The last ring is left out: a cut-off at it would make it incomplete.
    weights = modes, modes * amplitudes.ravel() ** 2, modes * k
    count, power, radius = (np.bincount(ring, values)[1:highest] for values in weights)
    area = count * step**2
    return MeasuredSpectrum(step * radius / count, power / area, count * lines, area, 2)


def skewness_of(profile: Profile) -> Estimate:
    """Return the skewness of the heights, with the standard error of a Gaussian surface.

    The variance of the mean of z^3 is 6 h^6 times the mean of the cubed correlation function, for
    each independent line or map. The two halves of a mirrored line count as one.
    """
    heights = profile.heights
    axes = tuple(range(1, heights.ndim))
    centred = heights - heights.mean(axis=axes, keepdims=True)
    correlation = np.fft.ifftn(np.mean(np.abs(np.fft.fftn(centred, axes=axes)) ** 2, axis=0)).real
    correlation /= correlation.flat[0]
    copies = (profile.length / profile.measured_length) ** len(axes)
    lines = len(heights) / (profile.correlation.lines if profile.correlation else 1.0)
    variance = 6.0 * float(np.mean(correlation**3)) * copies / lines
    return Estimate(profile.skewness, max(variance, 0.0) ** 0.5)
