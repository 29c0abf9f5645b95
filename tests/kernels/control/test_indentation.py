"""Prescribed indentation: what is given is taken, and costs no pass."""

import numpy as np

from elastomer_friction.kernels import SCHEMES
from elastomer_friction.kernels.control.indentation import PrescribedIndentation
from elastomer_friction.kernels.model.balance import balance, note


def test_the_indentation_of_every_step_is_the_one_given():
    law, control = SCHEMES["exponential"](0.2), PrescribedIndentation(np.array([0.3, -2.0, 0.1]))
    z, c = np.random.default_rng(1).normal(size=(2, 50))
    before = c.copy()
    for step, expected in enumerate(control.indentation, 1):
        noted = note(control, c, 9.0, np.array([0, 50]), None)
        assert balance(control, law, z, c, noted, 9.0, step) == (expected, 0)
    np.testing.assert_array_equal(c, before)
