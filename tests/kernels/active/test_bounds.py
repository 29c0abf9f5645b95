"""The bounds of d and D hold what they are made of, with a margin."""

import numpy as np
import pytest

from kernels import SCHEMES, ConstantForce
from kernels.active.balance import foresee
from kernels.active.bounds import bounds_of, first_bounds, first_thresholds, holds, widened
from kernels.active.setting import advance
from tests.kernels.active.given import Jump, dense, setting_of, states_of

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
    guess = foresee(ConstantForce(load), setting)
    _, (d,) = dense(setting, load, np.array([1]))
    assert guess == pytest.approx(d, rel=1e-3)
    found = first_bounds(setting, guess, 0.1)
    assert holds(found, d, advance(setting.law, d, setting.start.d))


@pytest.mark.parametrize("ratio", [0.7, 1.2])
@pytest.mark.parametrize(("load", "x"), [(0.01, 10.0), (0.5, 1.0), (5.0, 3.0), (25.0, 1.0)])
def test_thresholds_and_sums_are_those_of_all_elements(load, x, ratio):
    setting, _ = setting_of(Jump(0.9, 4, load, x, ratio), 160)
    d, law = setting.start.d, setting.law
    c, sums = first_thresholds(setting)
    assert c.size < setting.z.size
    push = advance(law, d, d)
    depth = np.maximum(d - c, 0.0).sum() + sums.depth + (push - sums.level) * sums.samples
    w, _ = states_of(setting)[0]
    u = np.minimum(w, setting.z - d)
    expected = np.maximum(d - (setting.z - law.decay * np.roll(u, -1)), 0.0)
    assert depth == pytest.approx(expected.sum(), rel=1e-9)
    assert (c < d).sum() + sums.samples == (expected > 0.0).sum()
