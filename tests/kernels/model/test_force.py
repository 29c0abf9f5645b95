"""Constant normal force: the balance of eq. 4 for the forces of a step."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, ConstantForce
from elastomer_friction.kernels.model.balance import balance, note
from tests.references import sorted_root

FIRST = np.array([0, 50])


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("load", [1e-3, 2.0, 500.0])
def test_the_forces_of_the_step_carry_the_load(scheme, load):
    law, control = SCHEMES[scheme](0.2), ConstantForce(load)
    z, c = np.random.default_rng(1).normal(size=(2, 50))
    before = c.copy()
    noted = note(control, c, 0.3, FIRST, None)
    d, passes = balance(control, law, z, c, noted, 0.3, 1)
    assert d == pytest.approx(sorted_root(before, load / law.stiffness), rel=1e-13)
    assert law.stiffness * np.sum(np.maximum(0.0, d - before)) == pytest.approx(load, rel=1e-11)
    assert passes >= 2
    np.testing.assert_array_equal(c, before)
