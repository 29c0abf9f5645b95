"""The bounds of d and D hold what they are made of, with a margin."""

import numpy as np
import pytest

from kernels import SCHEMES
from kernels.active.bounds import bounds_of, first_bounds, first_indentation, holds, widened
from kernels.active.setting import advance
from tests.kernels.active.given import Jump, dense, setting_of

LAW = SCHEMES["exponential"](0.3)


@pytest.mark.parametrize("margin", [0.1, 2.0])
def test_what_they_are_made_of_lies_within_and_what_is_farther_out_does_not(margin):
    found = bounds_of(LAW, 2.0, 3.0, 0.6, 0.9, margin)
    for d, push in ((2.0, 0.6), (3.0, 0.9), (2.5, 2.5 / LAW.stiffness)):
        assert holds(found, d, push)
    assert not holds(found, 3.0 + 1.01 * margin, 0.7)
    assert not holds(found, np.nan, 0.7)
    assert not holds(found, 2.5, np.nan)


def test_wider_ones_hold_what_left_them():
    narrow = bounds_of(LAW, 2.0, 3.0, 0.6, 0.9, 0.1)
    assert not holds(narrow, 4.0, 1.5)
    assert holds(widened(LAW, narrow, 4.0, 1.5, 0.1), 4.0, 1.5)


def test_the_first_step_is_guessed_and_lies_within_the_first_bounds():
    setting, load = setting_of(Jump(0.7, 4, 0.3, 10.0, 1.2), 200)
    guess = first_indentation(setting, load)
    _, (d,) = dense(setting, load, np.array([1]))
    assert guess == pytest.approx(d, rel=1e-3)
    found = first_bounds(setting, guess, 0.1)
    assert holds(found, d, advance(setting.law, d, setting.start.d))
