"""The line that is equivalent to an isotropic rough surface in the one-dimensional model.

This is the rule of the method of dimensionality reduction: the paper's introduction and its refs.
35 (Popov, Friction 1, 41 (2013), doi:10.1007/s40544-013-0005-3) and 36. The line keeps rms height,
gradient and curvature of the surface, and its Hurst exponent: C_2D ~ q^(-2H-2) gives
C_1D ~ q^(-2H-1).
"""

from collections.abc import Callable

import numpy as np

from .self_affine import mode_numbers


def equivalent_spectrum(q: np.ndarray, isotropic: np.ndarray) -> np.ndarray:
    """Return the C_1D(q) of the line equivalent to an isotropic surface: 2 pi q C_2D(q).

    q > 0 and isotropic, C_2D(q), have the same shape. C_2D (unit m^4) is normalised over the whole
    plane, int C_2D d^2q = 2 pi int q C_2D dq = h^2, and C_1D (unit m^3) over q > 0.

    Normalised over both signs of q, the same spectrum of the line is pi q C_2D. It is not the
    spectrum of a cut through the surface, whose mean square slope is half the mean square
    gradient of the surface.
    """
    return 2.0 * np.pi * q * isotropic


def equivalent_amplitudes(
    isotropic: Callable[[np.ndarray], np.ndarray], length: float, elements: int
) -> np.ndarray:
    """Return the mode amplitudes of the line equivalent to C_2D(q), shape (floor(N/2),).

    isotropic : function of q (rad per unit of length) in the convention of equivalent_spectrum.
    length : L, in the same unit. The amplitudes have the unit of the heights of the surface.

    Raises ValueError where C_2D is negative or not finite.
    """
    step = 2.0 * np.pi / length
    q = step * mode_numbers(elements)
    spectrum = equivalent_spectrum(q, np.asarray(isotropic(q)))
    if not (np.isfinite(spectrum).all() and np.all(spectrum >= 0.0)):
        raise ValueError("the power spectrum of a surface must be finite and not negative")
    return np.sqrt(2.0 * spectrum * step)


def equivalent_of_cut(amplitude: np.ndarray) -> np.ndarray:
    """Return the mode amplitudes of the line equivalent to a surface, from those of a cut.

    amplitude : of the modes of straight cuts through an isotropic surface, shape (floor(N/2),), as
    from measured_amplitudes. Along a cut, a ring of wave vectors of length q appears as waves of
    all wave numbers q cos(phi). The conversion removes these, beginning with the shortest waves
    (inverse Abel transform in bands of wave numbers). The mean square slope doubles.
    """
    edges = _band_edges(amplitude.size)
    power = 0.5 * amplitude**2
    cut_power = np.add.reduceat(power, edges[:-1])
    rings = np.zeros_like(cut_power)
    bounds = edges + 0.5  # between modes; mode k is at index k - 1
    shares = _shares(bounds)
    for band in range(cut_power.size - 1, -1, -1):
        left = cut_power[band] - rings[band + 1 :] @ shares[band + 1 :, band]
        rings[band] = max(left, 0.0) / shares[band, band]
    ratio = np.divide(rings, cut_power, out=np.zeros_like(rings), where=cut_power > 0.0)
    return amplitude * np.sqrt(np.repeat(ratio, np.diff(edges)))


def _band_edges(modes: int) -> np.ndarray:
    """Return the edges of bands of modes: single modes, then bands a few per cent wide."""
    wide = np.unique(np.round(np.geomspace(1.0, modes + 1.0, 1 + 40 * len(str(modes)))).astype(int))
    return wide - 1


def _shares(bounds: np.ndarray) -> np.ndarray:
    """Return the share of ring i that a cut shows in band j, shape (bands, bands)."""
    shares = np.zeros((bounds.size - 1, bounds.size - 1))
    for band in range(bounds.size - 1):
        radii = np.linspace(bounds[band], bounds[band + 1], 9)[1::2]  # of rings in the band
        below = np.arcsin(np.minimum(bounds[None, :] / radii[:, None], 1.0))
        shares[band] = (2.0 / np.pi * np.diff(below, axis=1)).mean(axis=0)
    return shares
