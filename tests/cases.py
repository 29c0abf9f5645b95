"""A small case shared by the tests of whole realizations."""

import numpy as np

from elastomer_friction.kernels import Case, Line, Quantities, amplitudes, draw_phases
from elastomer_friction.kernels.lines.self_affine import mode_numbers
from tests.sizes import size

ELEMENTS, M = size(120, 60), 2
KEPT = np.array([1, 2, 3, 5, 10, 20, 50, 100])
RATIOS = (0.8, 1.2, 1.5)
CASE = Case(0.1, 0.5, RATIOS, (KEPT,) * 3, "exponential")
ALL = Quantities()


def bits(outcome):
    """Return the numbers of an outcome except its time, as bytes."""
    fields = outcome._replace(seconds=None)._asdict()
    return {field: np.asarray(value).tobytes() for field, value in fields.items()}


def line_of(elements=ELEMENTS, shift=0.0, steps=M):
    """Return a random line. shift : in spacings."""
    phases = draw_phases(np.random.default_rng(1), elements)
    shifted = phases + 2.0 * np.pi * mode_numbers(elements) * shift / elements
    return Line.self_affine(amplitudes(0.7, elements), shifted, elements, steps)
