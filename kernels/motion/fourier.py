"""Fourier shift of a periodic surface by fractions of a sample; exact if it is band-limited.

With linear interpolation, the mean of z^2 would depend on the fraction of a sample. The resulting
lattice force would hide the response to motions smaller than a sample.
"""

from functools import lru_cache

import numpy as np


class FourierShift:
    """Heights and slopes of a line or a map, shifted along x by a fraction of a sample."""

    def __init__(self, z: np.ndarray, slope: np.ndarray, steps_per_spacing: int) -> None:
        """Transform heights (in h) and slopes (in h/dx), shape (n,), or (rows, n) for a map."""
        self.samples = z.shape[-1]
        self.spectra = np.fft.rfft(np.stack([z, slope]))
        self.phase = -2.0 * np.pi * np.arange(self.spectra.shape[-1]) / self.samples
        self.nyquist = np.pi * steps_per_spacing  # wave number of the wave of two samples, in 1/dx

    def by(self, fraction: float) -> tuple[np.ndarray, np.ndarray]:
        """Return (heights, slopes) with the surface shifted by ``fraction`` of a sample towards +x.

        Samples of the heights determine only the cosine of the wave of two samples; those of the
        slopes determine its sine.
        """
        moved = self.spectra * np.exp(1j * self.phase * fraction)
        if self.samples % 2 == 0:
            z, slope = self.spectra[..., -1].real
            q, angle = self.nyquist, np.pi * fraction
            moved[0, ..., -1] = z * np.cos(angle) - slope / q * np.sin(angle)
            moved[1, ..., -1] = slope * np.cos(angle) + q * z * np.sin(angle)
        z, slope = np.fft.irfft(moved, self.samples)
        return z, slope


class FractionalShifts:
    """A surface shifted by fractions of a sample, with a cache of the last shifts."""

    def __init__(self, z: np.ndarray, slope: np.ndarray, steps_per_spacing: int) -> None:
        """Create an empty cache; arguments as in FourierShift."""
        self.given = z, slope, steps_per_spacing
        self.shifted: FourierShift | None = None
        self.at = lru_cache(maxsize=4)(self._at)

    def _at(self, fraction: float) -> tuple[np.ndarray, np.ndarray]:
        """Return (heights, slopes) shifted by a fraction of a sample towards +x."""
        if fraction == 0.0:
            return self.given[:2]
        if self.shifted is None:
            self.shifted = FourierShift(*self.given)
        return self.shifted.by(fraction)
