"""Properties of all laws: dispatch on types, and decay to zero without subnormal numbers."""

import numpy as np

from elastomer_friction.kernels import Kelvin
from elastomer_friction.kernels.model import steady


def test_decay_never_leaves_subnormal_numbers():
    """If decay > 1/2, the smallest subnormal number times decay rounds to itself forever."""
    products = []

    class Watched(float):
        def __mul__(self, other):
            products.append(abs(float(self) * other))
            return float(self) * other

    z = np.full(3000, 5.0)
    z[2998] = 0.0  # one element touches, all others decay for almost the whole period
    law, w = Kelvin(Watched(0.7), 1.0, 0.0), np.empty_like(z)
    assert getattr(steady.sweep, "py_func", steady.sweep)(law, z, 1.0, 2998, w) == (1.0, 1.0, 1)
    assert len(products) > 2000
    assert min(p for p in products if p > 0.0) > 1e-300
