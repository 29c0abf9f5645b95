"""The active-set march against the plain one and the element-by-element reference."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastomer_friction.kernels import SCHEMES, ConstantForce, Line
from elastomer_friction.kernels.motion.stretches import touchable
from elastomer_friction.kernels.quick.march.active import MARGINS, active_march
from tests.kernels.quick.march.given import (
    Jump,
    dense,
    rounding_of_mu,
    setting_of,
    size_of_jump,
    states_of,
)
from tests.sizes import size

EVERY = np.arange(1, size(60, 9) + 1)
REGIMES = [
    Jump(hurst, m, load, x, ratio, scheme)
    for hurst, m, load, x, ratio, scheme in itertools.product(
        (0.0, 0.5, 1.0),
        size((1, 4, 16), (1, 4)),
        size((1e-4, 0.03, 0.5, 5.0, 25.0), (1e-3, 0.5, 25.0)),
        size((0.01, 0.3, 3.0, 30.0, 1000.0), (0.3, 30.0)),
        size((0.3, 1.0 + 1e-6, 1.2, 3.0), (0.3, 1.2)),
        SCHEMES,
    )
]


def assert_same(setting, load, jump, kept_steps, margins=MARGINS):
    """Compare with the plain march, within 1e-9 of the jump and what rounding leaves of mu."""
    mu, d, settled, _, inside = active_march(setting, ConstantForce(load), kept_steps, margins)
    assert inside
    deviation, expected = dense(setting, load, kept_steps)
    np.testing.assert_allclose(d, expected, rtol=1e-11, atol=1e-15)
    allowed = 1e-9 * size_of_jump(setting, jump, load) + rounding_of_mu(setting, load)
    np.testing.assert_allclose(mu - settled, deviation, rtol=0.0, atol=allowed)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("hurst", [0.0, 0.5, 1.0])
def test_it_is_the_plain_march_in_every_regime(hurst, scheme):
    regimes = [jump for jump in REGIMES if (jump.hurst, jump.scheme) == (hurst, scheme)]
    for jump in regimes[:: size(7, 5)]:
        setting, load = setting_of(jump, size(100, 24))
        assert_same(setting, load, jump, EVERY)


LONG = [Jump(0.7, 4, 1.0, 78.0, 1.2), Jump(0.7, 4, 0.025, 78.0, 0.8), Jump(1.0, 4, 1.0, 31.0, 1.2)]


@pytest.mark.parametrize("jump", LONG, ids=str)
def test_long_lines_over_all_steps(jump):
    steps = int(size(4 * jump.m * jump.ratio * jump.x / np.pi, 20))
    setting, load = setting_of(jump, size(3000, 60))
    assert_same(setting, load, jump, np.arange(1, steps + 1))


@pytest.mark.parametrize("load", [1e-3, 0.1, 2.0])
@pytest.mark.parametrize("m", [1, 8])
def test_measured_lines(load, m):
    heights = np.random.default_rng(2).standard_normal(size(200, 40)).cumsum()
    heights -= np.linspace(0.0, heights[-1], heights.size)
    line = Line.measured(heights / heights.std(), m)
    jump = Jump(0.5, m, load, 20.0, 1.3)
    setting, load = setting_of(jump, None, line=(line.z, line.slope))
    assert_same(setting, load, jump, EVERY)


@settings(max_examples=size(150, 15))
@given(
    elements=st.integers(2, 40),
    seed=st.integers(0, 2**31),
    hurst=st.floats(0.0, 1.0),
    m=st.sampled_from([1, 2, 5]),
    load=st.floats(-5.0, 1.6),
    x=st.floats(-2.5, 4.0),
    ratio=st.floats(0.2, 4.0),
    scheme=st.sampled_from(list(SCHEMES)),
    margin=st.sampled_from([0.0, 1e-3, 0.1, 0.3]),
)
def test_small_lines(elements, seed, hurst, m, load, x, ratio, scheme, margin):
    """It may fall back on the plain march, but never gives other numbers."""
    jump = Jump(hurst, m, 10.0**load, 10.0**x, ratio, scheme)
    setting, load = setting_of(jump, max(elements, -(-4 // m)), seed)
    kept, margins = EVERY[:20], (margin, 0.5, 2.0)
    if active_march(setting, ConstantForce(load), kept, margins)[-1]:
        assert_same(setting, load, jump, kept, margins)


def test_full_contact_has_nothing_to_list():
    jump = Jump(1.0, 4, 60.0, 3.0, 1.2)
    setting, load = setting_of(jump, size(200, 40))
    w, d = states_of(setting)[0]
    assert (setting.z - w < d).all()
    assert_same(setting, load, jump, EVERY)
    *_, work, inside = active_march(setting, ConstantForce(load), EVERY)
    assert inside
    assert work == setting.z.size


def test_a_contact_narrower_than_a_sample_has_nothing_sure():
    jump = Jump(0.3, 1, 1e-6, 100.0, 1.2)
    setting, load = setting_of(jump, size(300, 60))
    w, d = states_of(setting)[1]
    assert (setting.z - w < d).sum() <= 2
    assert_same(setting, load, jump, EVERY)


@pytest.mark.parametrize("x", [1e-5, 1e-3, 1e5])
def test_decay_near_zero_and_near_one(x):
    for load in (1e-80, 1e-3, 1.0):
        setting, force = setting_of(Jump(0.7, 1, load, x, 1.2), size(200, 40))
        mu, d, settled, _, inside = active_march(setting, ConstantForce(force), EVERY)
        assert inside
        deviation, expected = dense(setting, force, EVERY)
        np.testing.assert_allclose(d, expected, rtol=1e-11)
        np.testing.assert_allclose(mu - settled, deviation, atol=1e-8 * np.abs(mu).max())


def test_only_the_recorded_steps_are_kept_and_arguments_left_alone():
    setting, load = setting_of(Jump(0.7, 2, 0.3, 5.0, 1.2), size(100, 40))
    arrays = [setting.z, setting.slope, setting.start.entered, setting.end.entered]
    copies = [array.copy() for array in arrays]
    every = active_march(setting, ConstantForce(load), EVERY)
    some = active_march(setting, ConstantForce(load), EVERY[[0, 4, 8]])
    last = active_march(setting, ConstantForce(load), EVERY[-1:])
    for k in (0, 1):
        np.testing.assert_array_equal(some[k], every[k][[0, 4, 8]])
        np.testing.assert_array_equal(last[k], every[k][-1:])
    for before, now in zip(copies, arrays, strict=True):
        np.testing.assert_array_equal(before, now)


def test_bounds_that_are_left_cost_a_restart_and_no_digit():
    jump = Jump(0.7, 4, 0.3, 10.0, 2.0)
    setting, load = setting_of(jump, size(200, 40))
    assert not active_march(setting, ConstantForce(load), EVERY, (-0.4,) * 3)[-1]
    assert_same(setting, load, jump, EVERY, (-0.4, 0.5, 2.0))


def test_few_elements_are_stepped():
    """Of the samples that the plain march steps."""
    jump = Jump(0.7, 4, 1.0, 78.0, 1.2)
    setting, load = setting_of(jump, size(2000, 100))
    steps = size(130, 30)
    *_, work, inside = active_march(setting, ConstantForce(load), np.array([steps]))
    assert inside
    start, stop = touchable(setting.z, 1.02 * setting.start.d)
    assert work - setting.z.size < size(0.3, 0.9) * steps * (stop - start).sum()
