"""A sampled rigid line, checked once: what the kernels take for granted holds from here on."""

from typing import NamedTuple

import numpy as np

from kernels.surfaces.measured import measured_modes
from kernels.surfaces.self_affine import sample_line

TALLEST = 1e50  # and its inverse: heights far above numbers that count as zero


class Line(NamedTuple):
    """A sampled rigid line, highest point first, heights above its deepest point (in h)."""

    z: np.ndarray  # shape (N m,)
    slope: np.ndarray  # shape (N m,), in h/dx
    datum: float  # height of the deepest point over the mean line, in h
    steps_per_spacing: int
    band_limited: bool = False  # whether it is a function without modes above q = pi/dx

    @classmethod
    def from_samples(
        cls, z: np.ndarray, slope: np.ndarray, steps_per_spacing: int, band_limited: bool = False
    ) -> "Line":
        """Prepare given heights (in h) and slopes (in h/dx) of a periodic line.

        band_limited : as the field.
        Raises ValueError where a sample is not finite, where a height has no slope, and for
        heights that cannot be in units of their rms roughness.
        """
        if not (np.isfinite(z).all() and np.isfinite(slope).all()):
            raise ValueError("the line holds samples that are not finite numbers")
        if z.shape != slope.shape or z.ndim != 1 or z.size == 0 or steps_per_spacing < 1:
            raise ValueError("a line needs one slope per height, one sample per spacing or more")
        height = float(np.abs(z).max())
        if height > 0.0 and not 1.0 / TALLEST <= height <= TALLEST:
            raise ValueError(f"height = {height:g}: heights must be in units of their roughness")
        top = int(np.argmax(z))
        # Heights over the deepest point keep full precision where light loads touch.
        datum = float(z.min())
        heights, slopes = np.roll(z, -top) - datum, np.roll(slope, -top)
        return cls(heights, slopes, datum, steps_per_spacing, band_limited)

    @classmethod
    def self_affine(
        cls, amplitude: np.ndarray, phases: np.ndarray, elements: int, steps_per_spacing: int
    ) -> "Line":
        """Sample the random line of self_affine.py.

        amplitude (in h), phases : of its modes, shape (N/2,), as from amplitudes and draw_phases.
        elements : N. Raises ValueError as from_samples does.
        """
        z, slope = sample_line(amplitude, phases, elements, steps_per_spacing)
        return cls.from_samples(z, slope, steps_per_spacing, band_limited=True)

    @classmethod
    def measured(cls, heights: np.ndarray, steps_per_spacing: int) -> "Line":
        """Prepare a measured line (measured.py), sampled m times as finely as it was given.

        heights (in h) : one period, one sample per element, shape (N,). Raises ValueError as
        measured_modes and from_samples do.
        """
        modes = measured_modes(heights)
        z, slope = sample_line(*modes, heights.size, steps_per_spacing)
        return cls.from_samples(z + heights.mean(), slope, steps_per_spacing, band_limited=True)
