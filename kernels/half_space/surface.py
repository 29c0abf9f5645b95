"""Rough surfaces: band-limited periodic functions, sampled m times per element spacing.

z(x, y) = sum_q h_q exp(i q r), two-sided, with q = 2 pi k/L, is self-affine with random phases, or
the trigonometric polynomial through a measured map. The function does not depend on m.
Source: C_2D ~ |q|^(-2(H+1)) is the spectrum whose equivalent line is that of Li et al. (2014),
doi:10.1038/srep05795 (lines/equivalent.py).
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..lines.self_affine import falling_integral, last_mode

MIN_MAP_COLUMNS = 4  # of a measured map along x: fewer do not determine slopes


class Surface(NamedTuple):
    """A sampled rigid surface; its mean height is zero unless a measured map has another one."""

    z: np.ndarray  # shape (N m, N m), or (1, N m) for a line contact, in h
    slope: np.ndarray  # dz/dx, of the same shape, in h/dx
    steps_per_spacing: int
    band_limited: bool = False  # whether all modes have q <= pi/dx

    @classmethod
    def from_samples(
        cls, z: np.ndarray, slope: np.ndarray, steps_per_spacing: int, band_limited: bool = False
    ) -> "Surface":
        """Return the surface of a periodic map of heights (in h) and slopes (in h/dx).

        Raises ValueError if the map is neither square nor a single row, if its sides are not
        multiples of m, or if it holds values that are not finite.
        """
        if z.ndim != 2 or z.shape != slope.shape or z.shape[0] not in (1, z.shape[1]):
            raise ValueError(f"a map of shape {z.shape}: must be square, or one row, with slopes")
        if steps_per_spacing < 1 or z.size == 0 or z.shape[1] % steps_per_spacing:
            raise ValueError(
                f"steps_per_spacing = {steps_per_spacing}: must divide the {z.shape[1]} samples"
            )
        if not (np.isfinite(z).all() and np.isfinite(slope).all()):
            raise ValueError("the map holds samples that are not finite numbers")
        z, slope = (np.ascontiguousarray(values, float) for values in (z, slope))
        return cls(z, slope, steps_per_spacing, band_limited)

    @classmethod
    def drawn(
        cls,
        generator: np.random.Generator,
        amplitudes: np.ndarray,
        elements: int,
        steps_per_spacing: int,
    ) -> "Surface":
        """Draw a surface with random phases, which depend only on N and the generator.

        amplitudes : |h_q|, from ring_amplitudes. elements : N.
        """
        phases = generator.uniform(0.0, 2.0 * np.pi, amplitudes.shape)
        modes = amplitudes * np.exp(1j * phases)
        return cls.from_samples(
            *_sampled(modes, elements, steps_per_spacing), steps_per_spacing, band_limited=True
        )

    @classmethod
    def measured(cls, heights: np.ndarray, steps_per_spacing: int) -> "Surface":
        """Return the trigonometric polynomial through a periodic map, sampled m times as finely.

        heights : shape (N, N), or (1, N) for a line contact, in h. Raises ValueError as
        from_samples does, and for fewer than MIN_MAP_COLUMNS samples along x.
        """
        flat = np.zeros_like(heights, float)
        cls.from_samples(np.asarray(heights, float), flat, 1)  # only to check the heights
        columns = heights.shape[1]
        if columns < MIN_MAP_COLUMNS:
            message = f"a map of {columns} samples along x: needs {MIN_MAP_COLUMNS} or more"
            raise ValueError(message)
        fields = _sampled(_modes(heights), columns, steps_per_spacing)
        return cls.from_samples(*fields, steps_per_spacing, band_limited=True)


def ring_amplitudes(
    hurst: float,
    elements: int,
    rolloff: float = 0.0,
    cutoff: int = 0,
    normalisation: str = "modal",
) -> np.ndarray:
    """Return the amplitudes |h_q| of the modes of a self-affine surface, in h.

    The spectrum is two-sided, <z^2> = sum |h_q|^2 over all q. Modes with k_x >= 0 are returned,
    shape (2 M + 1, M + 1) with M = floor(N/2): rows k_y = 0 ... M, -M ... -1, columns k_x = 0 ...
    M. C_2D ~ |q|^(-2(H+1)) on the ring 1 <= |k| <= cutoff, k = q L/(2 pi); flat below rolloff.

    rolloff, cutoff : wave numbers in 2 pi/L; zero means no roll-off, and a cutoff at floor(N/2).
    normalisation : "modal" makes the sum over modes exact, sum |h_q|^2 = 1; "integral" makes the
    integral of the spectrum over the ring equal to 1 instead.
    Raises ValueError as the amplitudes of lines do (lines/self_affine.py).
    """
    highest = elements // 2
    last = last_mode(rolloff, cutoff, highest, normalisation)
    k = np.hypot(*_wave_indices(2 * highest + 1, highest))
    inside = (k >= 1.0) & (k <= last)
    power = np.zeros_like(k)
    power[inside] = np.maximum(k[inside], rolloff) ** (-2.0 * hurst - 2.0)
    total = float((_multiplicity(highest) * power).sum())
    if normalisation == "integral":
        total = ring_integral(hurst, rolloff, last)
    return np.sqrt(power / total)


def isotropic_amplitudes(
    isotropic: Callable[[np.ndarray], np.ndarray], length: float, elements: int
) -> np.ndarray:
    """Return the amplitudes |h_q| of the modes of maps of C_2D(q), in the order of ring_amplitudes.

    isotropic : function of q (rad per unit of length), with int C_2D d^2q = h^2. length : L, in the
    same unit. |h_q|^2 = C_2D (2 pi/L)^2, in the unit of the heights of the surface.
    """
    highest, step = elements // 2, 2.0 * np.pi / length
    q = step * np.hypot(*_wave_indices(2 * highest + 1, highest))
    q[0, 0] = step
    amplitudes = step * np.sqrt(isotropic(q))
    amplitudes[0, 0] = 0.0
    return amplitudes


def rms_height_of(amplitudes: np.ndarray) -> float:
    """Return the rms height, (sum |h_q|^2)^(1/2), in the unit of the amplitudes."""
    return float(np.sqrt(np.sum(_multiplicity(amplitudes.shape[1] - 1) * amplitudes**2)))


def ring_integral(hurst: float, rolloff: float, last: int) -> float:
    """Return the integral of max(k, rolloff)^(-2H-2) over the ring 1 <= |k| <= last."""
    flat = max(rolloff, 1.0)
    inner = 0.5 * (flat**2 - 1.0) * flat ** (-2.0 * hurst - 2.0)
    return 2.0 * np.pi * (inner + falling_integral(hurst, flat, float(last)))


def rms_slope_of(amplitudes: np.ndarray, elements: int) -> float:
    """Return the rms of the full gradient, (sum |h_q|^2 q^2)^(1/2), in h/dx.

    amplitudes : from ring_amplitudes. elements : N.
    """
    highest = amplitudes.shape[1] - 1
    q = 2.0 * np.pi / elements * np.hypot(*_wave_indices(amplitudes.shape[0], highest))
    return float(np.sqrt(np.sum(_multiplicity(highest) * (amplitudes * q) ** 2)))


def map_amplitudes(heights: np.ndarray) -> np.ndarray:
    """Return the amplitudes |h_q| of the modes of a periodic map, in the order of ring_amplitudes.

    heights : shape (N, N), or (1, N) for a line contact; their mean is ignored.
    """
    amplitudes = np.abs(_modes(heights))
    amplitudes[0, 0] = 0.0
    return amplitudes


def _modes(heights: np.ndarray) -> np.ndarray:
    """Return the modes of a periodic map, in the order of ring_amplitudes."""
    rows, columns = heights.shape
    # For waves of two samples, both signs of k coincide and share the amplitude.
    spectrum = np.fft.rfft2(heights) / heights.size
    if columns % 2 == 0:
        spectrum[:, -1] *= 0.5
    half = rows // 2
    modes = np.empty((2 * half + 1, columns // 2 + 1), complex)
    modes[: half + 1] = spectrum[: half + 1]
    modes[half + 1 :] = spectrum[rows - half :]
    if rows % 2 == 0:
        modes[half : half + 2] *= 0.5
    return modes


def _wave_indices(rows: int, highest: int) -> tuple[np.ndarray, np.ndarray]:
    """Return k_y as a column and k_x as a row, in the order of ring_amplitudes."""
    k_y = np.fft.fftfreq(rows, 1.0 / rows)  # rows is odd: the signs come in pairs
    return k_y[:, None], np.arange(highest + 1.0)[None, :]


def _multiplicity(highest: int) -> np.ndarray:
    """Return the number of two-sided modes per stored mode, by column: 1 for k_x = 0, else 2."""
    return np.where(np.arange(highest + 1) == 0, 1.0, 2.0)


def _sampled(modes: np.ndarray, elements: int, m: int) -> tuple[np.ndarray, np.ndarray]:
    """Return (heights, slopes) of the function with these modes, in the order of ring_amplitudes.

    Modes with k_x = 0 and k_y < 0 are ignored: they are the conjugates of those with k_y > 0.
    """
    rows, highest = modes.shape[0], modes.shape[1] - 1
    n = elements * m
    n_rows = 1 if rows == 1 else n
    k_y, k_x = _wave_indices(rows, highest)
    heights = modes.copy()
    half = rows // 2
    heights[rows - half :, 0] = np.conj(heights[1 : half + 1, 0])[::-1]
    heights[0, 0] = heights[0, 0].real
    row = k_y[:, 0].astype(np.int64) % n_rows
    fields = []
    for values in (heights, 2j * np.pi / elements * k_x * heights):
        spectrum = np.zeros((n_rows, n // 2 + 1), complex)
        np.add.at(spectrum[:, : highest + 1], row, values)
        if 2 * highest == n:  # both signs of this k_x share one coefficient
            spectrum[:, -1] += np.conj(spectrum[-np.arange(n_rows), -1])
        fields.append(np.fft.irfft2(spectrum * (n_rows * n), (n_rows, n)))
    return fields[0], fields[1]
