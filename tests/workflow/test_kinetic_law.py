"""The closed-form law: its limits, its parts, and what it makes of sampled velocities."""

import numpy as np
import pytest

from elastomer_friction.workflow.kinetic_law import KineticLaw, normalised_jump, relaxation_rate

SLOPE, TAU, Q_MAX = 0.2, 1e-3, 1e6
VELOCITY = np.geomspace(1e-5, 1.0, 60)
FRICTION = 1.3 * SLOPE * VELOCITY / (VELOCITY + 1e-3)


def law(**changes):
    """Return a law whose x is one at 1 mm/s."""
    settings = {
        "relaxation_time": TAU,
        "hurst": 0.7,
        "q_max": Q_MAX,
        "rms_slope": SLOPE,
        "velocity": VELOCITY,
        "friction": FRICTION,
    }
    return KineticLaw(**{**settings, **changes})


def test_jump_follows_friction_at_low_speed_and_then_a_plateau():
    assert normalised_jump(1e-4) == pytest.approx(1e-4, rel=1e-6)
    assert normalised_jump(1e4) == pytest.approx(0.4, rel=1e-6)


def test_rate_is_x_below_one_and_a_power_of_it_above():
    x = np.array([0.01, 0.5, 1.0, 4.0, 100.0])
    np.testing.assert_allclose(relaxation_rate(x, 0.5), [0.01, 0.5, 1.0, 2.0, 10.0])
    np.testing.assert_allclose(relaxation_rate(x, 0.5, True), [1.0, 1.0, 1.0, 2.0, 10.0])


def test_friction_is_proportional_below_the_table_and_constant_above():
    table = law()
    assert table.steady(1e-6) == pytest.approx(0.1 * FRICTION[0])
    assert table.steady(50.0) == pytest.approx(FRICTION[-1])
    np.testing.assert_allclose(table.steady(VELOCITY), FRICTION)


def test_relaxation_takes_a_length_at_low_speed_and_tau_on_smooth_lines():
    np.testing.assert_allclose(law().relaxation_length([1e-6, 1e-4]), 1.0 / Q_MAX)
    np.testing.assert_allclose(law(hurst=0.0).relaxation_length([0.1, 10.0]), 1.0 / Q_MAX)
    np.testing.assert_allclose(law(hurst=1.0).relaxation_times([0.1, 10.0]), TAU)


def test_curve_goes_from_mu_1_by_the_jump_to_mu_2():
    v1, v2 = 0.05, 0.06
    time = np.array([-1.0, 0.0, law().relaxation_times(v1), 1.0])
    mu = law().after_jump(v1, v2, time)
    mu_1, mu_2 = law().steady(v1), law().steady(v2)
    start = mu_1 + SLOPE * normalised_jump(mu_1 / SLOPE) * (v2 / v1 - 1.0)
    expected = [mu_1, start, mu_2 + (start - mu_2) / np.e, mu_2]
    np.testing.assert_allclose(mu, expected, rtol=1e-12)


@pytest.mark.parametrize("factor", [1.01, 0.99])
def test_small_step_sampled_is_the_jump(factor):
    time = np.linspace(-1e-3, 3e-3, 401)
    velocity = np.where(time < 0.0, 0.05, 0.05 * factor)
    expected = law().after_jump(0.05, 0.05 * factor, time - time[time >= 0.0][0])
    jump = abs(law().jump(0.05, 0.05 * factor))
    np.testing.assert_allclose(law().response(time, velocity), expected, atol=0.02 * jump)


def test_constant_velocity_is_steady():
    time = np.linspace(0.0, 1.0, 11)
    assert np.array_equal(law().response(time, np.full(11, 0.03)), [law().steady(0.03)] * 11)


def test_slow_change_stays_steady_and_a_quick_one_does_not():
    velocity = np.geomspace(0.01, 0.1, 500)
    slow = law().response(np.linspace(0.0, 100.0, 500), velocity)
    quick = law().response(np.linspace(0.0, 1e-4, 500), velocity)
    np.testing.assert_allclose(slow, law().steady(velocity), rtol=3e-3)
    assert quick[-1] > 1.05 * law().steady(velocity[-1])


TABLES = [([1.0], [0.1]), ([1.0, 2.0], [0.1]), ([2.0, 1.0], [0.1, 0.2]), ([0.0, 1.0], [0.1, 0.2])]
BAD = [
    *({"velocity": velocity, "friction": friction} for velocity, friction in TABLES),
    *({"hurst": 1.2}, {"relaxation_time": 0.0}, {"q_max": -1.0}, {"rms_slope": 0.0}),
]


@pytest.mark.parametrize("changes", BAD)
def test_values_without_meaning_are_refused(changes):
    with pytest.raises(ValueError, match="must"):
        law(**changes)


@pytest.mark.parametrize(
    ("time", "velocity"), [([0.0, 0.0], [1.0, 1.0]), ([0.0, 1.0], [1.0, 0.0]), ([0.0, 1.0], [1.0])]
)
def test_samples_without_meaning_are_refused(time, velocity):
    with pytest.raises(ValueError, match=r"must (increase|be positive)"):
        law().response(time, velocity)
