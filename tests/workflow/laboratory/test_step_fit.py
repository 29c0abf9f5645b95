"""One step: known parameters within stated errors, and nothing where the data say nothing."""

import math
from itertools import pairwise

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.laboratory import sentences
from elastomer_friction.workflow.laboratory.estimate import correlation_factor, mean
from elastomer_friction.workflow.laboratory.parting import constant_stretches, measured_steps
from elastomer_friction.workflow.laboratory.step_fit import (
    NO_RELAXATION_TEXT,
    TOO_COARSE_TEXT,
    TOO_NOISY_TEXT,
    TOO_SHORT_TEXT,
    fit_step,
)
from elastomer_friction.workflow.reduce import STATE_LAWS, step_law
from tests.workflow.laboratory.given import noise, record


@pytest.mark.parametrize("correlation", [0.0, 0.5, 0.9])
def test_stated_errors_of_means_hold_two_thirds_of_them(correlation):
    found = [mean(noise(seed, 1500, 2.0, correlation)) for seed in range(100)]
    pulls = np.array([each.value / each.error for each in found])
    assert 0.55 < np.mean(abs(pulls) < 1.0) < 0.82
    assert np.mean(abs(pulls) < 3.0) > 0.95


def test_the_factor_is_that_of_the_autocorrelation():
    factor = correlation_factor(noise(1, 200_000, 1.0, 0.8))
    assert factor == pytest.approx((1.0 + 0.8) / (1.0 - 0.8), rel=0.05)
    assert correlation_factor(noise(1, 200_000, 1.0, -0.8)) == 1.0
    assert correlation_factor(np.ones(50)) == 1.0


def test_one_step_is_taken_apart():
    (step,) = measured_steps(record(n=100, span=1.0))
    assert (step.name, step.v1, step.v2) == ("r0.txt", pytest.approx(0.1), pytest.approx(0.12))
    assert step.ratio == pytest.approx(1.2)
    assert step.change == pytest.approx(0.01)
    assert (step.before.size, step.after.size) == (50, 100)
    np.testing.assert_allclose(step.time[:2], [0.005, 0.015])


@pytest.mark.parametrize("size", [0.0, 3e-3, 2e-2])
@pytest.mark.parametrize("ramp", [0, 30])
def test_stretches_of_noisy_velocities_with_slow_changes(size, ramp):
    levels = [1.0, 1.3, 1.0, 0.1]
    parts = [np.full(200, levels[0])]
    for one, two in pairwise(levels):
        parts += [np.linspace(one, two, ramp + 2)[1:-1], np.full(200, two)]
    values = np.log(np.concatenate(parts)) + noise(1, 800 + 3 * ramp, size)
    found = constant_stretches(values)
    assert len(found) == 4
    for i, stretch in enumerate(found):
        start = i * (200 + ramp)
        assert abs(stretch.start - start) <= 8
        assert abs(stretch.stop - start - 200) <= 8


def test_steps_of_one_file_are_numbered_and_a_window_cuts_them():
    one = record(n=100, span=1.0)
    v = np.concatenate([one.velocity, 0.1 + 0 * one.velocity])
    t = np.concatenate([one.time, one.time + 2.0])
    twice = one._replace(time=t, velocity=v, friction=np.tile(one.friction, 2))
    steps = measured_steps(twice, window=0.5)
    assert [step.name for step in steps] == ["r0.txt, step 1", "r0.txt, step 2"]
    assert [step.time.size for step in steps] == [50, 50]


def test_what_has_no_step_or_too_few_samples_is_refused():
    with pytest.raises(UserError, match=r"^fit r0\.txt: holds no velocity step: no two stretches"):
        measured_steps(record(v=(0.1, 0.1005)))
    with pytest.raises(UserError, match=r"^fit r0\.txt: 5 samples within 0\.05 s of the step"):
        measured_steps(record(n=100, span=1.0), window=0.05)


def test_a_step_on_a_sample_is_half_an_interval_from_the_assumed_moment():
    """The described difference gives the known jump; one lost in noise is not described."""
    log_ratio = math.log(1.2)
    for n, size, stated in ((40, 1e-5, True), (4000, 1e-3, False)):
        one = record(n=n)
        fit = fit_step(measured_steps(one._replace(friction=later(one, size)))[0])
        (words,) = sentences._moment(fit) or [""]
        assert bool(words) == stated
        less = float(words.split("b are ")[1].split()[0]) if stated else 0.0
        assert fit.jump.value - less * log_ratio == pytest.approx(0.05, rel=0.02)


def later(one, size):
    """Return the friction of a record whose step is at its first sample after time 0."""
    t = one.time - one.time[one.time > 0.0].min()
    return np.where(t < 0.0, 0.3, 0.32 + 0.03 * np.exp(-8.0 * t)) + noise(0, t.size, size)


TRUE = {"mu_1": 0.3, "mu_2": 0.32, "jump": 0.05, "amplitude": 0.03, "rate": 8.0}


def fitted(*arguments, law="ruina", **options):
    (step,) = measured_steps(record(*arguments, **options))
    return fit_step(step, law)


@pytest.mark.parametrize(("correlation", "size"), [(0.0, 2e-3), (0.8, 1e-3)])
def test_stated_errors_are_those_of_the_estimates(correlation, size):
    fits = [fitted(seed, correlation=correlation, size=size) for seed in range(36)]
    for name, true in TRUE.items():
        found = [getattr(fit, name) for fit in fits]
        pulls = np.array([(each.value - true) / each.error for each in found])
        if name == "rate":  # whose error is that of its logarithm
            pulls = np.array(
                [np.log(each.value / true) * each.value / each.error for each in found]
            )
        assert 0.65 < pulls.std() < 1.5, name
        assert np.mean(abs(pulls) < 1.0) > 0.4, name


def test_without_noise_the_estimates_are_exact_but_for_the_moment_of_the_step():
    fit = fitted(size=0.0)
    for name, true in TRUE.items():
        assert getattr(fit, name).value == pytest.approx(true, rel=1e-6)
    between = 2.0 / 400  # s, two samples
    assert fit.jump.error == pytest.approx(0.03 * 8.0 * between / math.sqrt(12.0), rel=1e-3)
    assert fit.mu_2.error < 1e-9


@pytest.mark.parametrize(
    ("options", "why"),
    [
        ({"jump": 0.02}, NO_RELAXATION_TEXT),
        ({"rate": 0.05, "size": 1e-4}, TOO_SHORT_TEXT),
        ({"rate": 300.0}, TOO_COARSE_TEXT),
        ({"size": 3e-2}, {NO_RELAXATION_TEXT, TOO_NOISY_TEXT, TOO_SHORT_TEXT, TOO_COARSE_TEXT}),
    ],
    ids=["no relaxation", "slow", "fast", "noise"],
)
def test_a_rate_that_the_data_leave_open_is_none(options, why):
    fit = fitted(**options)
    assert not fit.rate.known
    assert fit.why["rate"] in why if isinstance(why, set) else fit.why["rate"] == why
    assert not fit.state()[2].known


def test_what_does_not_depend_on_the_rate_is_known_without_it():
    still, slow = fitted(jump=0.02), fitted(rate=0.05, size=1e-4)
    assert abs(still.jump.value - 0.02) < 3.0 * still.jump.error < 0.01
    assert abs(slow.jump.value - 0.05) < 3.0 * slow.jump.error < 0.01


def test_the_end_of_a_relaxation_that_was_not_seen_is_not_determined():
    for size in (1e-4, 1e-3):  # seen to be slow, and taken for steady
        fit = fitted(rate=0.02, size=size)
        assert not fit.mu_2.known
        assert set(fit.why) == {"mu_2", "amplitude", "rate"}
        assert abs(fit.jump.value - 0.05) < 3.0 * fit.jump.error < 0.01


@pytest.mark.parametrize("law", STATE_LAWS)
@pytest.mark.parametrize("ratio", [0.2, 3.0])
def test_constants_of_a_state_law_are_found(law, ratio):
    a, b, length, v1 = 0.03, 0.05, 1e-3, 1e-2
    rate = ratio * v1 / length
    one = record(v=(v1, ratio * v1), size=0.0, span=10.0 / rate)
    curve = step_law(law, ratio)(np.array([[b, math.log(rate)]]), np.clip(one.time, 0.0, None))[0][
        0
    ]
    after = 0.3 + (a - b) * math.log(ratio) + curve
    rng = np.random.default_rng(3)
    friction = np.where(one.time < 0.0, 0.3, after) + 2e-4 * rng.standard_normal(one.time.size)
    fit = fit_step(*measured_steps(one._replace(friction=friction)), law)
    for found, true in zip(fit.state(), (a, b, length), strict=True):
        assert abs(found.value - true) < 4.0 * found.error
        assert found.error < 0.1 * true
    other = fit_step(
        *measured_steps(one._replace(friction=friction)), STATE_LAWS[law == STATE_LAWS[0]]
    )
    assert other.rms > 1.5 * fit.rms
