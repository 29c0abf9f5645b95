"""What a march is controlled by: a force, a force by eq. 3 as printed, an indentation."""

import numpy as np
import pytest
from scipy.optimize import brentq

from elastomer_friction.kernels import SCHEMES, ConstantForce, PrintedForce
from elastomer_friction.kernels.control.indentation import PrescribedIndentation
from elastomer_friction.kernels.model.balance import balance, note
from elastomer_friction.kernels.motion.slide import Rings
from tests.references import sorted_root

ALL_OF_IT = np.array([0, 50])


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("load", [1e-3, 2.0, 500.0])
def test_the_forces_of_the_step_carry_the_load(scheme, load):
    law, control = SCHEMES[scheme](0.2), ConstantForce(load)
    z, c = np.random.default_rng(1).normal(size=(2, 50))
    before = c.copy()
    noted = note(control, c, 0.3, ALL_OF_IT, None)
    d, passes = balance(control, law, z, c, noted, 0.3, 1)
    assert d == pytest.approx(sorted_root(before, load / law.stiffness), rel=1e-13)
    assert law.stiffness * np.sum(np.maximum(0.0, d - before)) == pytest.approx(load, rel=1e-11)
    assert passes >= 2
    np.testing.assert_array_equal(c, before)


FIRST = np.array([0, 20, 50])  # two stretches
NONE = np.empty(0)
RINGS = Rings(NONE, np.array([0, 18, 36]), NONE)  # over two gaps of 17 samples


def state(seed=1):
    """Return z, the thresholds at the end of a step and its d; some samples touch."""
    z, c = np.random.default_rng(seed).normal(size=(2, 50))
    return z, c, 0.2


def test_elements_are_held_that_come_straight_from_contact():
    _, c, d = state()
    held = note(PrintedForce(1.0), c, d, FIRST, RINGS)
    expected = np.append(c[1:] < d, False)
    expected[19] = False  # what arrives there has crossed the gap between the stretches
    np.testing.assert_array_equal(held, expected)
    assert 5 < held.sum() < 45


def test_where_the_whole_line_is_marched_its_end_is_held_by_its_beginning():
    _, c, d = state()
    no_gap = Rings(NONE, np.array([0, 1]), NONE)
    for first_touches in (False, True):
        c[0] = d - 0.1 if first_touches else d + 0.1
        held = note(PrintedForce(1.0), c, d, np.array([0, 50]), no_gap)
        np.testing.assert_array_equal(held, np.roll(c, -1) < d)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("load", [0.1, 5.0, 100.0])
def test_held_elements_press_with_their_height_and_the_motion_of_the_line_alone(scheme, load):
    """f = -(u + du/dt) over a step from z_(i+1) - d to z_i - d, both with the new d (eq. 3)."""
    law, control = SCHEMES[scheme](0.5), PrintedForce(load)
    z, c, d_old = state()
    held = note(control, c, d_old, FIRST, RINGS)
    free = c.copy()

    def forces(d):
        old = np.append(z[1:], 0.0) - d
        threshold = np.where(held, z - law.decay * old, free)
        return law.stiffness * np.maximum(0.0, d - threshold)

    expected = brentq(lambda d: forces(d).sum() - load, -20.0, 200.0, xtol=1e-14, rtol=1e-14)
    d, _ = balance(control, law, z, c, held, d_old, 1)
    assert d == pytest.approx(expected, rel=1e-11, abs=1e-12)
    # The march goes on from the thresholds of these forces.
    found = law.stiffness * np.maximum(0.0, d - c)
    np.testing.assert_allclose(found, forces(d), rtol=1e-9, atol=1e-11)


def test_the_indentation_of_every_step_is_the_one_given():
    law, control = SCHEMES["exponential"](0.2), PrescribedIndentation(np.array([0.3, -2.0, 0.1]))
    z, c = np.random.default_rng(1).normal(size=(2, 50))
    before = c.copy()
    for step, expected in enumerate(control.indentation, 1):
        noted = note(control, c, 9.0, np.array([0, 50]), None)
        assert balance(control, law, z, c, noted, 9.0, step) == (expected, 0)
    np.testing.assert_array_equal(c, before)
