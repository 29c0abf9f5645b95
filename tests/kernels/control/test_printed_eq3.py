"""Eq. 3 as it is printed: its balance, and that its code is there only where it is asked for."""

import numba
import numpy as np
import pytest
from scipy.optimize import brentq

from kernels import SCHEMES, ConstantForce, PrintedForce, steady_sliding
from kernels.control.balance import balance, note
from kernels.jit import FLAGS
from kernels.march import march
from tests.lines import random_line
from tests.sizes import PLAIN_PYTHON

SPEED = 2.0  # at one sample per spacing
FIRST = np.array([0, 20, 50])  # two stretches


def state(seed=1):
    """Return z, the thresholds at the end of a step and its d; some samples touch."""
    z, c = np.random.default_rng(seed).normal(size=(2, 50))
    return z, c, 0.2


def test_elements_are_held_that_come_straight_from_contact():
    _, c, d = state()
    held = note(PrintedForce(1.0), c, d, FIRST)
    expected = np.append(c[1:] < d, False)
    expected[19] = False  # what arrives there has crossed the gap between the stretches
    np.testing.assert_array_equal(held, expected)
    assert 5 < held.sum() < 45


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("load", [0.1, 5.0, 100.0])
def test_held_elements_press_with_their_height_and_the_motion_of_the_line_alone(scheme, load):
    """f = -(u + du/dt) over a step from z_(i+1) - d to z_i - d, both with the new d (eq. 3)."""
    law, control = SCHEMES[scheme](1.0 / SPEED), PrintedForce(load)
    z, c, d_old = state()
    held = note(control, c, d_old, FIRST)
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


@pytest.mark.parametrize("scheme", SCHEMES)
def test_steady_sliding_has_no_rate_to_drop(scheme):
    law = SCHEMES[scheme](1.0 / SPEED)
    z, slope = random_line(60, 0.7, 1, seed=2)
    start, _ = steady_sliding(law, z, 6.0)
    steps = np.arange(1, 200)
    _, d, _, _ = march(law, PrintedForce(6.0), z, slope, start, steps, np.inf)
    np.testing.assert_allclose(d, start.d, rtol=1e-12)


def machine_code(control):
    """Return the assembler of a march under a control, compiled now: none is kept with a cache."""
    law = SCHEMES["exponential"](0.5)
    z, slope = random_line(20, 0.7, 1, seed=2)
    start, _ = steady_sliding(law, z, 2.0)
    compiled = numba.njit(**FLAGS)(march.py_func)
    compiled(law, control, z, slope, start, np.array([3]), np.inf)
    return compiled.inspect_asm(compiled.signatures[0])


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")
def test_a_control_that_is_off_is_not_in_the_machine_code():
    """The names of all functions in it can be read there, inlined or not."""
    off, on = machine_code(ConstantForce(2.0)), machine_code(PrintedForce(2.0))
    for name in ("printed_eq3", "weighted_overlap"):  # in a march nothing else needs the second
        assert name not in off
        assert name in on
    assert "ConstantForce" in off
    assert "ConstantForce" not in on
