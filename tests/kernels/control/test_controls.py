"""Controls of a march: a force, a force by eq. 3 as printed, an indentation."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, ConstantForce, PrintedForce
from elastomer_friction.kernels.control.indentation import PrescribedIndentation
from elastomer_friction.kernels.model.balance import balance, balance_history
from elastomer_friction.kernels.motion.slide import Rings
from tests.references import sorted_root

ALL_OF_IT = np.array([0, 50])


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("load", [1e-3, 2.0, 500.0])
def test_the_forces_of_the_step_carry_the_load(scheme, load):
    law, control = SCHEMES[scheme](0.2), ConstantForce(load)
    z, c = np.random.default_rng(1).normal(size=(2, 50))
    before = c.copy()
    history = balance_history(control, c, 0.3, ALL_OF_IT, None)
    d, passes = balance(control, law, z, c, history, 0.3, 1)
    assert d == pytest.approx(sorted_root(before, load / law.stiffness), rel=1e-13)
    assert law.stiffness * np.sum(np.maximum(0.0, d - before)) == pytest.approx(load, rel=1e-11)
    assert passes >= 2
    np.testing.assert_array_equal(c, before)


FIRST = np.array([0, 20, 50])  # two stretches
NONE = np.empty(0)
RINGS = Rings(NONE, np.array([0, 18, 36]), NONE)  # over two gaps of 17 samples


def state(seed=1):
    """Return (z, thresholds, d) at the end of a step; some samples touch."""
    z, c = np.random.default_rng(seed).normal(size=(2, 50))
    return z, c, 0.2


def test_elements_are_held_that_come_straight_from_contact():
    _, c, d = state()
    held = balance_history(PrintedForce(1.0), c, d, FIRST, RINGS)
    expected = np.append(c[1:] < d, False)
    expected[19] = False  # its element has crossed the gap between the stretches
    np.testing.assert_array_equal(held, expected)
    assert 5 < held.sum() < 45


def test_the_indentation_of_every_step_is_the_one_given():
    law, control = SCHEMES["exponential"](0.2), PrescribedIndentation(np.array([0.3, -2.0, 0.1]))
    z, c = np.random.default_rng(1).normal(size=(2, 50))
    before = c.copy()
    for step, expected in enumerate(control.indentation, 1):
        assert balance(control, law, z, c, None, 9.0, step) == (expected, 0)
    np.testing.assert_array_equal(c, before)
