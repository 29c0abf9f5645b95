"""The active-set march, with and without shortened lists: agreement with the plain march, work."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastomer_friction.kernels import SCHEMES, ConstantForce
from elastomer_friction.kernels.motion.slide import touchable
from elastomer_friction.kernels.quick.march.active import (
    BOUND_MARGINS,
    MarchState,
    Recorder,
    active_march,
    march_with_shortening,
    predict_first_indentation,
    step_until,
)
from elastomer_friction.kernels.quick.march.crossings import SteadyFlight, no_landings, run_entries
from elastomer_friction.kernels.quick.march.kinds import listed_samples, undecided_runs
from elastomer_friction.kernels.quick.march.lists import ActiveSet
from elastomer_friction.kernels.quick.march.problem import initial_bounds
from tests.kernels.quick.march.given import Jump, dense, rounding_of_mu, setting_of, size_of_jump
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


def assert_same(setting, load, jump, kept_steps, margins=BOUND_MARGINS):
    """Compare with the plain march to 1e-9 of the jump plus the rounding of mu."""
    mu, d, settled, _, inside = active_march(setting, ConstantForce(load), kept_steps, margins)
    assert inside
    deviation, expected = dense(setting, load, kept_steps)
    np.testing.assert_allclose(d, expected, rtol=1e-11, atol=1e-15)
    allowed = 1e-9 * size_of_jump(setting, jump, load) + rounding_of_mu(setting, load)
    np.testing.assert_allclose(mu - settled, deviation, rtol=0.0, atol=allowed)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("hurst", [0.0, 0.5, 1.0])
def test_equals_the_plain_march_in_every_regime(hurst, scheme):
    regimes = [jump for jump in REGIMES if (jump.hurst, jump.scheme) == (hurst, scheme)]
    for jump in regimes[:: size(7, 5)]:
        setting, load = setting_of(jump, size(100, 24))
        assert_same(setting, load, jump, EVERY)


def marched(setting, control, steps, shortening=True, margin=0.1):
    """Return (mu, indentation, inside, work) of a march with or without shortened lists."""
    start = setting.start
    guess = predict_first_indentation(control, setting)
    bounds = initial_bounds(setting, guess, margin)
    runs, collected, sums = undecided_runs(setting, bounds)
    listed, flight = listed_samples(runs, collected), SteadyFlight(start.decay.sample, start.d)
    entries = run_entries(setting.law, listed, runs, flight, setting.z, steps)
    landings = no_landings(setting.end.d, start.d, steps)
    active = ActiveSet(runs, listed, sums, entries, landings)
    mu, d = np.full(steps, np.nan), np.full(steps, np.nan)
    recorder = Recorder(np.arange(1, steps + 1), mu, d)
    state = MarchState(0, 0, start.d, guess, np.nan)
    arguments = setting, control, active, bounds, state, steps, recorder
    if shortening:
        inside, _, _, work = march_with_shortening(*arguments, 1e9)
    else:
        inside, _, _, work = step_until(*arguments)
    return mu, d, inside, work


@settings(max_examples=size(200, 15))
@given(
    elements=st.integers(2, 60),
    seed=st.integers(0, 2**31),
    hurst=st.floats(0.0, 1.0),
    m=st.sampled_from([1, 2, 5]),
    load=st.floats(-5.0, 1.6),
    x=st.floats(-2.5, 4.0),
    ratio=st.floats(0.2, 4.0),
    scheme=st.sampled_from(list(SCHEMES)),
    margin=st.sampled_from([0.0, 1e-3, 0.05, 0.1, 0.3, 0.5]),
)
def test_small_lines(elements, seed, hurst, m, load, x, ratio, scheme, margin):
    """A march may fail, and the plain march takes over, but it never gives different numbers.

    The same holds if lists are shortened as early as possible and the march has to return to longer
    ones any number of times. It then succeeds if its initial bounds hold.
    """
    jump = Jump(hurst, m, 10.0**load, 10.0**x, ratio, scheme)
    setting, load = setting_of(jump, max(elements, -(-4 // m)), seed)
    kept, margins = EVERY[:20], (margin, 0.5, 2.0)
    if active_march(setting, ConstantForce(load), kept, margins)[-1]:
        assert_same(setting, load, jump, kept, margins)
    short, long = (
        marched(setting, ConstantForce(load), EVERY.size, shortening, max(margin, 0.05))
        for shortening in (True, False)
    )
    assert short[2] == long[2]
    mu, d, _, _ = short
    deviation, expected = dense(setting, load, EVERY)
    reached = np.isfinite(d)
    np.testing.assert_allclose(d[reached], expected[reached], rtol=1e-11, atol=1e-15)
    allowed = 1e-9 * size_of_jump(setting, jump, load) + rounding_of_mu(setting, load)
    steady = (mu - deviation)[reached]  # the steady average, equal at all steps
    np.testing.assert_allclose(steady - steady[:1], 0.0, atol=2.0 * allowed)


def test_shorter_lists_save_work():
    setting, load = setting_of(Jump(0.7, 4, 1.0, 60.0, 1.2), size(1000, 60))
    short, long = (
        marched(setting, ConstantForce(load), size(300, 40), shortening)
        for shortening in (True, False)
    )
    assert short[2]
    assert long[2]
    assert short[3] < size(0.6, 0.95) * long[3]


LONG = [Jump(0.7, 4, 1.0, 78.0, 1.2), Jump(0.7, 4, 0.025, 78.0, 0.8), Jump(1.0, 4, 1.0, 31.0, 1.2)]


@pytest.mark.parametrize("jump", LONG, ids=str)
def test_long_lines_over_all_steps(jump):
    steps = int(size(4 * jump.m * jump.ratio * jump.x / np.pi, 80))
    setting, load = setting_of(jump, size(3000, 500))
    assert_same(setting, load, jump, np.arange(1, steps + 1))


@pytest.mark.parametrize("x", [1e-5, 1e-3, 1e5])
def test_decay_near_zero_and_near_one(x):
    for load in (1e-80, 1e-3, 1.0):
        setting, force = setting_of(Jump(0.7, 1, load, x, 1.2), size(200, 40))
        mu, d, settled, _, inside = active_march(setting, ConstantForce(force), EVERY)
        assert inside
        deviation, expected = dense(setting, force, EVERY)
        np.testing.assert_allclose(d, expected, rtol=1e-11)
        np.testing.assert_allclose(mu - settled, deviation, atol=1e-8 * np.abs(mu).max())


def test_leaving_the_bounds_costs_a_restart_and_no_accuracy():
    jump = Jump(0.7, 4, 0.3, 10.0, 2.0)
    setting, load = setting_of(jump, size(200, 40))
    assert not active_march(setting, ConstantForce(load), EVERY, (-0.4,) * 3)[-1]
    assert_same(setting, load, jump, EVERY, (-0.4, 0.5, 2.0))


def test_few_elements_are_stepped():
    """The plain march steps all samples that can touch."""
    jump = Jump(0.7, 4, 1.0, 78.0, 1.2)
    setting, load = setting_of(jump, size(2000, 100))
    steps = size(130, 30)
    *_, work, inside = active_march(setting, ConstantForce(load), np.array([steps]))
    assert inside
    start, stop = touchable(setting.z, 1.02 * setting.start.d)
    assert work - setting.z.size < size(0.3, 0.9) * steps * (stop - start).sum()
