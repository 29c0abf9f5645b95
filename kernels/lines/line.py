"""A sampled rigid line, checked once for all kernels."""

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from .measured_modes import measured_modes
from .self_affine import sample_line, sample_modes

QUARTET = 4  # lines that one drawing of phases gives
MAX_HEIGHT = 1e50  # and its inverse: heights far above numbers that count as zero


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

        band_limited : as the field. Raises ValueError for samples that are not finite, for a height
        without a slope, and for heights too large to be in units of their rms roughness.
        """
        if z.shape != slope.shape or z.ndim != 1 or z.size == 0 or steps_per_spacing < 1:
            raise ValueError("a line needs one slope per height, one sample per spacing or more")
        top, datum = int(z.argmax()), float(z.min())
        _check(float(z[top]), datum, slope)
        # Heights over the deepest point keep full precision where light loads touch.
        heights = _beginning_at(top, z) - datum
        return cls(heights, _beginning_at(top, slope), datum, steps_per_spacing, band_limited)

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
    def quartet(
        cls, amplitude: np.ndarray, phases: np.ndarray, elements: int, steps_per_spacing: int
    ) -> Iterator["Line"]:
        """Yield the QUARTET of lines whose phases are all turned by 0, pi, pi/2 and 3 pi/2.

        Arguments as in self_affine, which is the first. Turned uniform phases are uniform, so all
        four lines are equally probable: z, -z, the Hilbert transform of z and its negative. They
        depend on each other (docs/errors.md quantifies this); lines of other phases do not.
        """
        modes = amplitude * np.exp(1j * phases)
        for turned in (modes, 1j * modes):
            z, slope = sample_modes(turned, elements, steps_per_spacing)
            top, low = int(z.argmax()), int(z.argmin())
            highest, lowest = float(z[top]), float(z[low])
            _check(highest, lowest, slope)
            heights, slopes = _beginning_at(top, z) - lowest, _beginning_at(top, slope)
            yield cls(heights, slopes, lowest, steps_per_spacing, band_limited=True)
            heights, slopes = highest - _beginning_at(low, z), -_beginning_at(low, slope)
            yield cls(heights, slopes, -highest, steps_per_spacing, band_limited=True)

    @classmethod
    def measured(cls, heights: np.ndarray, steps_per_spacing: int) -> "Line":
        """Prepare a measured line (measured_modes.py), sampled m times as finely as it was given.

        heights (in h) : one period, one sample per element, shape (N,). Raises ValueError as
        measured_modes and from_samples do.
        """
        modes = measured_modes(heights)
        z, slope = sample_line(*modes, heights.size, steps_per_spacing)
        return cls.from_samples(z + heights.mean(), slope, steps_per_spacing, band_limited=True)


def _check(highest: float, lowest: float, slope: np.ndarray) -> None:
    """Raise ValueError for invalid heights (in h) and slopes."""
    if not (math.isfinite(highest) and math.isfinite(lowest) and np.isfinite(slope).all()):
        raise ValueError("the line holds samples that are not finite numbers")
    height = max(highest, -lowest)
    if height > 0.0 and not 1.0 / MAX_HEIGHT <= height <= MAX_HEIGHT:
        raise ValueError(f"height = {height:g}: heights must be in units of their roughness")


def _beginning_at(first: int, values: np.ndarray) -> np.ndarray:
    """Return periodic values from sample ``first`` on."""
    return np.concatenate((values[first:], values[:first]))
