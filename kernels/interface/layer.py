"""An elastic layer of finite thickness on a rigid base, in place of the half-space.

Its compliance for a wave of the normal pressure is that of the half-space, 2/(E* |q|), times

    bonded: (2 kappa sinh 2s - 4s)/(2 kappa cosh 2s + 1 + kappa^2 + 4 s^2),   kappa = 3 - 4 nu,
    free:   (cosh 2s - 1)/(sinh 2s + 2s),                                     s = |q| thickness.

A bonded layer cannot move on its base, a free one slides on it without friction. Both factors tend
to 1 for s -> infinity. For s -> 0 the first tends to s (1 - 2 nu)/(2 (1 - nu)^2), or 2 s^3/3 for
nu = 1/2, the second to s/2. Neglected: shear stress at the surface also displaces a bonded layer,
and any layer with nu < 1/2, along the normal.
Source: K. L. Johnson, Contact Mechanics (Cambridge, 1985), ch. 5.
"""

from typing import NamedTuple

import numpy as np

BACKINGS = BONDED, FREE = ("bonded", "free")


class Layer(NamedTuple):
    """A layer on a rigid base; hashable, because it is part of keys."""

    thickness: float  # in dx
    backing: str  # "bonded" or "free"
    poisson: float  # Poisson's ratio; free layers do not depend on it


def compliance_ratio(layer: Layer, q: np.ndarray) -> np.ndarray:
    """Return the compliance of a layer over that of the half-space; 1 for q = 0.

    q : wave numbers |q|, in 1/dx.
    """
    ratio, inside = np.ones_like(q), q > 0.0
    s = layer.thickness * q[inside]
    decay = np.exp(-2.0 * s)  # factor of all terms, as hyperbolic functions overflow
    if layer.backing == FREE:
        ratio[inside] = np.expm1(-2.0 * s) ** 2 / (4.0 * s * decay - np.expm1(-4.0 * s))
        return ratio
    kappa = 3.0 - 4.0 * layer.poisson
    soft = -kappa * np.expm1(-4.0 * s) - 4.0 * s * decay
    ratio[inside] = soft / (kappa * (1.0 + decay**2) + (1.0 + kappa**2 + 4.0 * s**2) * decay)
    return ratio
