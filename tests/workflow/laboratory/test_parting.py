"""Records as machines write them: rest, reversal, backwards, noise below zero, drift, softness."""

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.laboratory.parting import measured_steps, no_steps_of
from elastomer_friction.workflow.laboratory.record import Record
from elastomer_friction.workflow.laboratory.sentences import describe
from elastomer_friction.workflow.laboratory.step_fit import fit_step
from elastomer_friction.workflow.laboratory.together import Known, fit_records
from tests.workflow.laboratory.given import record

RATE, N = 8.0, 200


def driven(velocities, seed=0, size=3e-4):
    """Return a record of stretches of 2 s; friction jumps and relaxes after each change."""
    t = 2.0 * np.arange(N * len(velocities)) / N
    v = np.repeat(np.asarray(velocities, float), N)
    since = np.tile(2.0 * np.arange(N) / N, len(velocities))
    mu = np.sign(v) * (0.3 + 0.05 * np.exp(-RATE * since))
    return Record("r", t, v, mu + size * np.random.default_rng(seed).standard_normal(t.size))


def test_rest_and_reversal_are_left_out_and_said():
    one = driven([0.1, 0.3, 0.0, 0.1, 0.3, -0.3, 0.1, 0.3])
    steps = measured_steps(one)
    assert [step.v1 for step in steps] == pytest.approx([0.1] * 3)
    assert [step.v2 for step in steps] == pytest.approx([0.3] * 3)
    assert no_steps_of(one) == [
        "left out: 1 rest and 2 reversals, which are no velocity steps",
        "1 backward slide is fitted as sliding forward",
    ]
    for step in steps:
        assert fit_step(step).rate.value == pytest.approx(RATE, rel=0.1)


def test_sliding_backwards_gives_the_same_step():
    one = driven([0.1, 0.3])
    back = one._replace(velocity=-one.velocity, friction=-one.friction)
    (forth,), (turned,) = measured_steps(one), measured_steps(back)
    np.testing.assert_array_equal(forth.after, turned.after)
    assert (forth.v1, forth.v2) == (turned.v1, turned.v2)
    (unsigned,) = measured_steps(one._replace(velocity=-one.velocity))  # of friction as a size
    np.testing.assert_array_equal(forth.after, unsigned.after)


def test_friction_of_the_other_sign_is_turned_and_said():
    one = driven([0.1, 0.3])
    turned = one._replace(friction=-one.friction)
    np.testing.assert_array_equal(measured_steps(turned)[0].after, measured_steps(one)[0].after)
    assert no_steps_of(turned) == [
        "friction is negative where the velocity is positive: its sign is turned"
    ]
    assert not no_steps_of(one)


RAMP = np.linspace(0.1, 0.3, 400)


@pytest.mark.parametrize(
    ("velocity", "named", "words"),
    [
        (np.repeat([0.1, 0.0, 0.1], N), True, "run segments slide and hold"),
        (np.repeat([0.1, -0.1, 0.1, -0.1], N), True, "to and fro: run that motion"),
        (np.full(400, 0.1), True, "constant; if the load steps, run a study of several grid.norm"),
        (RAMP, True, "a ramp: run that motion as a programme"),
        (RAMP, False, "give --displacement"),
    ],
)
def test_motions_without_a_step_are_recognised(velocity, named, words):
    one = Record(
        "r", np.arange(velocity.size) / N, velocity, np.full(velocity.size, 0.3), (), named
    )
    with pytest.raises(UserError, match=f"^fit r: holds no velocity step: .*{words}"):
        measured_steps(one)


@pytest.mark.parametrize("scatter", [0.0, 0.03, 0.06])
def test_noise_that_goes_below_zero_leaves_the_steps(scatter):
    one = driven([0.1, 0.3, 0.1])
    noise = scatter * np.random.default_rng(2).standard_normal(one.time.size)
    steps = measured_steps(one._replace(velocity=one.velocity + noise))
    assert [step.v2 for step in steps] == pytest.approx([0.3, 0.1], rel=0.15)
    assert [abs(step.change) < 0.1 for step in steps] == [True, True]


def test_velocity_that_is_lost_in_noise_is_refused():
    one = driven([0.1, 0.3])
    noise = 0.15 * np.random.default_rng(2).standard_normal(one.time.size)
    with pytest.raises(UserError, match="too much noise to know it: smooth it, or give the comm"):
        measured_steps(one._replace(velocity=one.velocity + noise))


def test_a_displacement_that_is_taken_for_a_velocity_is_told_of():
    one = driven([0.1, 0.3])
    place = np.cumsum(one.velocity)
    with pytest.raises(UserError, match="as a displacement does: give --displacement"):
        measured_steps(one._replace(velocity=place))


@pytest.mark.parametrize("seed", range(4))
def test_a_drift_that_goes_on_is_taken_off(seed):
    one = record(seed, size=3e-4, span=2.0)
    drifting = one._replace(friction=one.friction + 0.02 * one.time)
    fit = fit_step(*measured_steps(drifting))
    assert fit.levelled
    assert fit.drift.value == pytest.approx(0.02, abs=3.0 * fit.drift.error)
    assert abs(fit.rate.value - 8.0) < 3.0 * fit.rate.error < 2.0
    assert abs(fit.jump.value - 0.05) < 3.0 * fit.jump.error
    np.testing.assert_allclose(fit.curve, drifting.friction[one.time > 0.0], atol=2e-3)


def test_a_drift_that_ends_with_the_step_is_not():
    one = record(size=3e-4)
    ended = one._replace(friction=one.friction + 0.02 * np.minimum(one.time, 0.0))
    fit = fit_step(*measured_steps(ended))
    assert fit.drifts
    assert not fit.levelled
    assert abs(fit.rate.value - 8.0) < 3.0 * fit.rate.error


def test_friction_that_is_constant_is_fitted_without_a_warning(recwarn):
    one = driven([0.1, 0.3])
    text = "\n".join(describe(fit_records([one._replace(friction=0.0 * one.time + 0.5)], Known())))
    assert "amplitude and rate: no relaxation" in text
    assert not recwarn.list


def test_steps_up_and_down_have_the_exponent_of_the_velocity_after():
    """Rates in proportion to the velocity after the step."""
    t = np.arange(0.0, 50.0, 0.05)
    phase = np.floor(t / 10.0).astype(int)
    v = np.where(phase % 2 == 0, 1e-3, 3e-3)
    mu = np.where(phase % 2 == 0, 0.5, 0.45)
    jump = np.where(phase % 2 == 0, -0.03, 0.03) * (phase > 0)
    before = np.where(phase > 0, np.where(phase % 2 == 0, 0.45, 0.5), 0.5)
    mu = mu + (before + jump - mu) * np.exp(-800.0 * v * (t - 10.0 * phase))
    mu = mu + 2e-4 * np.random.default_rng(0).standard_normal(t.size)
    fit = fit_records([Record("r", t, v, mu)], Known())
    assert fit.rates.exponent.value == pytest.approx(1.0, abs=0.03)
