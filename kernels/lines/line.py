"""A sampled rigid line, checked once for all kernels."""

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from .measured_modes import measured_modes
from .self_affine import sample_line, sample_modes

QUARTET = 4  # lines from one draw of phases
MAX_HEIGHT = 1e50  # the minimum is 1/MAX_HEIGHT, far above numbers that count as zero


class Line(NamedTuple):
    """A sampled rigid line that begins at its highest sample."""

    z: np.ndarray  # shape (N m,), heights over the deepest point, in h
    slope: np.ndarray  # shape (N m,), in h/dx
    datum: float  # height of the deepest point over the mean line, in h
    steps_per_spacing: int
    band_limited: bool = False  # whether the line is a function without modes above q = pi/dx

    @classmethod
    def from_samples(
        cls, z: np.ndarray, slope: np.ndarray, steps_per_spacing: int, band_limited: bool = False
    ) -> "Line":
        """Return the Line of heights (in h) and slopes (in h/dx) over one period.

        band_limited : as the field. Raises ValueError for samples that are not finite, for shapes
        that do not match, and for heights beyond MAX_HEIGHT or its inverse.
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
        """Return a random line (self_affine.py).

        amplitude (in h), phases : of its modes, shape (N/2,), as from amplitudes and draw_phases.
        elements : N. Raises ValueError as from_samples does.
        """
        z, slope = sample_line(amplitude, phases, elements, steps_per_spacing)
        return cls.from_samples(z, slope, steps_per_spacing, band_limited=True)

    @classmethod
    def quartet(
        cls, amplitude: np.ndarray, phases: np.ndarray, elements: int, steps_per_spacing: int
    ) -> Iterator["Line"]:
        """Yield the QUARTET of lines with all phases shifted by 0, pi, pi/2 and 3 pi/2.

        Arguments are those of self_affine, which returns the first line. Shifted uniform phases are
        uniform, so all four lines are equally probable: z, -z, the Hilbert transform of z and its
        negative. They depend on each other (see docs/errors.md), but not on other quartets.
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
        """Return a measured line (measured_modes.py), sampled m times as finely as the heights.

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
