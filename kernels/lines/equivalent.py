"""The line that is equivalent to an isotropic rough surface in the one-dimensional model.

The rule of the method of dimensionality reduction: the paper's introduction and its refs. 35
(Popov, Friction 1, 41 (2013), doi:10.1007/s40544-013-0005-3) and 36. The line keeps rms height,
gradient and curvature of the surface, and its Hurst exponent: C_2D ~ q^(-2H-2) gives
C_1D ~ q^(-2H-1).
"""

from collections.abc import Callable

import numpy as np

from .self_affine import mode_numbers


def equivalent_spectrum(q: np.ndarray, isotropic: np.ndarray) -> np.ndarray:
    """Return the C_1D(q) of the line equivalent to an isotropic surface: 2 pi q C_2D(q).

    q (> 0) and isotropic, C_2D(q), of one shape; C_2D is normalised over the whole plane,
    int C_2D d^2q = 2 pi int q C_2D dq = h^2 (unit m^4), C_1D over q > 0 (unit m^3).

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
    length : L, in the same unit. The amplitudes have the unit of heights that C_2D was made of.

    Raises ValueError where C_2D is negative or not finite.
    """
    step = 2.0 * np.pi / length
    q = step * mode_numbers(elements)
    spectrum = equivalent_spectrum(q, np.asarray(isotropic(q)))
    if not (np.isfinite(spectrum).all() and np.all(spectrum >= 0.0)):
        raise ValueError("the power spectrum of a surface must be finite and not negative")
    return np.sqrt(2.0 * spectrum * step)
