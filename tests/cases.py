"""The small case that tests of whole realizations share."""

import numpy as np

from kernels import Case, Line, Quantities, amplitudes, draw_phases
from tests.sizes import size

ELEMENTS, M = size(120, 60), 2
KEPT = np.array([1, 2, 3, 5, 10, 20, 50, 100])
RATIOS = (0.8, 1.2, 1.5)
CASE = Case(0.1, 0.5, RATIOS, (KEPT,) * 3, "exponential")
ALL = Quantities()


def line_of(seed=1, m=M, hurst=0.7):
    """Return a random line."""
    phases = draw_phases(np.random.default_rng(seed), ELEMENTS)
    return Line.self_affine(amplitudes(hurst, ELEMENTS), phases, ELEMENTS, m)
