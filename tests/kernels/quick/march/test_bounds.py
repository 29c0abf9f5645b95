"""The bounds of d and D hold what they are made of, with a margin."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, ConstantForce
from elastomer_friction.kernels.quick.march.bounds import (
    are_within,
    bounds_of,
    first_bounds,
    widened,
)
from elastomer_friction.kernels.quick.march.given import advance
from elastomer_friction.kernels.quick.march.load_balance import foresee
from elastomer_friction.kernels.quick.march.narrow import closer_bounds
from tests.kernels.quick.march.given import Jump, dense, setting_of

LAW = SCHEMES["exponential"](0.3)


@pytest.mark.parametrize("margin", [0.1, 2.0])
def test_what_they_are_made_of_lies_within_and_what_is_farther_out_does_not(margin):
    found = bounds_of(LAW, 2.0, 3.0, 0.6, 0.9, margin)
    for d, push in ((2.0, 0.6), (3.0, 0.9), (2.5, 2.5 / LAW.stiffness)):
        assert are_within(found, d, push)
    assert not are_within(found, 3.0 + 1.01 * margin, 0.7)
    assert not are_within(found, np.nan, 0.7)
    assert not are_within(found, 2.5, np.nan)


def test_wider_ones_hold_what_left_them():
    narrow = bounds_of(LAW, 2.0, 3.0, 0.6, 0.9, 0.1)
    assert not are_within(narrow, 4.0, 1.5)
    assert are_within(widened(LAW, narrow, 4.0, 1.5, 0.1), 4.0, 1.5)


@pytest.mark.parametrize("room", [0.0, 0.5, 5.0])
def test_closer_ones_leave_room_but_never_go_beyond(room):
    """Their own margin is 0.6 of the spread between what was seen, here 2.5, and the end, 2.75."""
    outer = bounds_of(LAW, 1.0, 3.0, 0.2, 0.9, 0.4)
    seen = bounds_of(LAW, 2.5, 2.5, 0.6, 0.6, 0.0)
    found = closer_bounds(LAW, outer, seen, 2.75, (room, 0.01 * room))
    assert found.high == pytest.approx(max(2.75 + 0.6 * 0.25, min(2.75 + room, outer.high)))
    assert found.high <= outer.high
    assert found.low >= outer.low
    assert found.most >= min(0.6 + 0.01 * room, outer.most)
    assert are_within(found, 2.75, 0.6)


@pytest.mark.parametrize("ratio", [0.7, 1.2])
@pytest.mark.parametrize(("load", "x"), [(0.01, 10.0), (0.3, 10.0), (0.5, 1.0), (2.0, 3.0)])
def test_the_first_step_is_foreseen_and_lies_within_the_first_bounds(load, x, ratio):
    setting, load = setting_of(Jump(0.7, 4, load, x, ratio), 200)
    guess = foresee(ConstantForce(load), setting)
    _, (d,) = dense(setting, load, np.array([1]))
    assert 0.9 < (guess - setting.start.d) / (d - setting.start.d) < 1.7
    found = first_bounds(setting, guess, 0.05)
    assert are_within(found, d, advance(setting.law, d, setting.start.d))
