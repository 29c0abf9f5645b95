"""The closed-form law: its limits, its parts, and what it makes of sampled velocities."""

import warnings

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.kernels import Case, Line, Quantities, amplitudes, rms_slope, run_case
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.kinetic_law import (
    BeyondKineticLawWarning,
    KineticLaw,
    jump_between,
    normalised_jump,
    relaxation_rate,
)

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


def test_friction_is_in_proportion_to_velocity_in_region_i_and_constant_above_the_table():
    sparse = law(velocity=[1e-4, 1e-3, 1e-2], friction=[4e-4, 4e-3, 0.015])
    np.testing.assert_allclose(sparse.steady([1e-6, 3e-4, 1e-3]), [4e-6, 1.2e-3, 4e-3], rtol=1e-12)
    assert sparse.steady(50.0) == pytest.approx(0.015)
    np.testing.assert_allclose(law().steady(VELOCITY), FRICTION)


def test_friction_is_odd_in_velocity_and_none_at_rest():
    v = np.array([1e-6, 1e-3, 0.3, 10.0])
    assert np.array_equal(law().steady(-v), -law().steady(v))
    assert law().steady(0.0) == law().jump(0.0, 0.0) == 0.0
    np.testing.assert_allclose(law().jump(-v, v), 2.0 * law().jump(0.0, v), rtol=1e-12)
    time, v = np.linspace(0.0, 1e-3, 50), 0.05 * np.cos(np.linspace(0.0, 9.0, 50))
    np.testing.assert_allclose(law().response(time, -v), -law().response(time, v), rtol=1e-12)


def test_relaxation_takes_a_length_at_low_speed_and_tau_on_smooth_lines():
    np.testing.assert_allclose(law().relaxation_length([1e-6, 1e-4, -1e-4]), 1.0 / Q_MAX)
    np.testing.assert_allclose(law(hurst=0.0).relaxation_length([0.1, 10.0]), 1.0 / Q_MAX)
    np.testing.assert_allclose(law(hurst=1.0).relaxation_times([0.1, 10.0]), TAU)
    assert law().relaxation_times(0.0) == np.inf
    assert law(time_below_one=True).relaxation_times(0.0) == TAU


def test_small_jump_is_that_of_eq_12_and_large_ones_are_the_sum_of_small_ones():
    for v in (1e-4, 1e-3, 0.3):
        small = SLOPE * normalised_jump(law().steady(v) / SLOPE) * 1e-4
        assert law().jump(v, v * (1.0 + 1e-4)) == pytest.approx(small, rel=1e-3)
    between = np.geomspace(1e-5, 1.0, 1000)
    assert np.sum(law().jump(between[:-1], between[1:])) == pytest.approx(law().jump(1e-5, 1.0))
    rise = law().steady(5e-6) - law().steady(1e-6)
    assert law().jump(1e-6, 5e-6) == pytest.approx(rise, rel=1e-3)
    assert jump_between(1e9, 1e9, np.log(2.0), SLOPE) == pytest.approx(0.4 * SLOPE * np.log(2.0))


def test_curve_goes_from_mu_1_by_the_jump_to_mu_2_in_the_time_of_the_velocity_after():
    v1, v2 = 0.05, 0.2
    time = np.array([-1.0, 0.0, law().relaxation_times(v2), 1.0])
    mu = law().after_jump(v1, v2, time)
    mu_1, mu_2 = law().steady(v1), law().steady(v2)
    start = mu_1 + law().jump(v1, v2)
    expected = [mu_1, start, mu_2 + (start - mu_2) / np.e, mu_2]
    np.testing.assert_allclose(mu, expected, rtol=1e-12)


@pytest.mark.parametrize("v2", [0.5, 0.051, 0.0, -0.3])
@pytest.mark.parametrize("count", [2, 20, 1000])
def test_step_is_the_same_as_a_formula_and_sampled_however_densely(v2, count):
    known = law(time_below_one=True)
    times = np.linspace(0.0, 2.0 * TAU, count)
    found = known.response(np.append([-1.0, 0.0], times), [0.05, 0.05, *([v2] * count)])
    np.testing.assert_allclose(found[2:], known.after_jump(0.05, v2, times), rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("ends", [(0.01, 0.1), (0.1, 1e-4), (-0.1, 0.2), (0.0, 0.05)])
def test_response_to_a_ramp_does_not_depend_on_its_samples(ends):
    time = 0.3 * TAU
    whole = law().response([0.0, time], ends)[-1]
    for count in (3, 10, 3000):
        many = law().response(np.linspace(0.0, time, count), np.linspace(*ends, count))
        assert many[-1] == pytest.approx(whole, rel=2e-4)


def test_response_is_the_solution_of_its_equation():
    """Of dE/dt = -E/t_relax + d(jumps - steady)/dt, in steps of Euler far below t_relax."""
    time = np.linspace(0.0, 2.0 * TAU, 40_001)
    v = 0.05 * np.cos(time / TAU * 4.0)
    left = np.diff(law().jump(0.0, v) - law().steady(v))
    keep = 1.0 - np.diff(time) / law().relaxation_times(v[:-1])
    excess = np.zeros_like(v)
    for k in range(keep.size):
        excess[k + 1] = excess[k] * keep[k] + left[k]
    found = law().response(time[::100], v[::100])
    np.testing.assert_allclose(found, (law().steady(v) + excess)[::100], atol=1e-3 * SLOPE)


def test_law_says_where_it_does_not_hold():
    with pytest.warns(BeyondKineticLawWarning, match=r"above the table .* ends at 1 m/s"):
        law().after_jump(0.5, 1.5, 0.0)
    with pytest.warns(BeyondKineticLawWarning, match=r"above 0\.1 m/s, up to which .* holds"):
        law(fastest=0.1).response([0.0, 1.0], [0.01, -0.2])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        law(fastest=0.1).after_jump(0.1, 0.08, 0.0)


def simulated(ratios, hurst=0.0, speed=6.0, load=0.25, elements=512, lines=24):
    """Return mu_1, mu_2, jumps over grad z and rates of the model, means over random lines."""
    kept = np.unique(np.geomspace(1, 600, 60).astype(int))
    sizes = amplitudes(hurst, elements)
    cases = []
    for seed in range(lines):
        phases = np.random.default_rng(seed).uniform(0.0, 2.0 * np.pi, elements // 2)
        line = Line.self_affine(sizes, phases, elements, 4)
        case = Case(load, speed, ratios, (kept,) * len(ratios), "exponential", refine=False)
        cases.append(run_case(line, case, Quantities()))
    slope = rms_slope(sizes, elements)
    mu_1 = np.mean([each.mu_1 for each in cases]) / slope
    mu_2, jump = (np.mean([getattr(e, n) for e in cases], 0) / slope for n in ("mu_2", "jump"))
    rates = []
    for k, ratio in enumerate(ratios):
        curve = np.mean([each.curves[k] for each in cases], 0) / slope
        left = np.abs(curve - mu_2[k])
        window = left > 0.1 * left[0]
        time = kept / (4 * speed * ratio)
        rates.append(-np.polyfit(time[window], np.log(left[window]), 1)[0])
    return mu_1, mu_2, jump, np.array(rates)


def test_model_jumps_upwards_as_sums_of_small_steps_do():
    ratios = (1.01, 1.3, 2.0)
    mu_1, mu_2, jump, _ = simulated(ratios)
    predicted = jump_between(mu_1, mu_2, np.log(ratios), 1.0)
    np.testing.assert_allclose(jump / jump[0], predicted / predicted[0], rtol=0.05)


def test_rate_of_the_model_belongs_to_the_velocity_after_the_step():
    """At H = 0, where b is in proportion to x: velocities before are equal, those after are not."""
    ratios = np.array([0.5, 2.0, 4.0])
    *_, rates = simulated(tuple(ratios))
    exponent = np.polyfit(np.log(ratios), np.log(rates), 1)[0]
    assert 0.8 < exponent < 1.2


def result(velocity=(0.01, 0.1, 0.001)):
    """Return what a result of a study over loads and velocities holds of steady sliding."""
    axes = {"hurst": [0.7], "normal_force": [0.1, 1.0], "velocity": list(velocity)}
    axes |= {"roughness": [1e-5], "velocity_step": [-0.2, 0.2]}
    mu = np.multiply.outer([1.0, 0.5], np.array(velocity))[None, :, :, None, None]
    mu = mu * np.ones((1, 2, len(velocity), 1, 2))
    values = {"mu_1": (list(axes), mu), "rms_slope": (list(axes), np.full(mu.shape, 0.05))}
    numbers = {"tau": TAU, "q_max": Q_MAX, "shear_modulus": 1e7}
    return xr.Dataset(values | {name: ((), value) for name, value in numbers.items()}, axes)


def test_law_of_a_result_has_its_numbers_and_its_range():
    found = KineticLaw.from_result(result(), {"normal_force": 0.9})
    assert (found.relaxation_time, found.hurst, found.q_max, found.rms_slope) == (
        TAU, 0.7, Q_MAX, 0.05,
    )  # fmt: skip
    np.testing.assert_allclose(found.steady([1e-3, 0.05]), [5e-4, 0.025])
    assert found.fastest == pytest.approx(0.2 * 1.0 / (1e7 * TAU * 1e-5))
    assert found.time_below_one


def test_point_of_a_result_must_be_given_whole_and_hold_velocities():
    with pytest.raises(ValueError, match="where along normal_force"):
        KineticLaw.from_result(result())
    with pytest.raises(ValueError, match="two or more"):
        KineticLaw.from_result(result(velocity=[0.1]), {"normal_force": 1.0})
    for dataset, point in ((3, {}), (result(), {"hirst": 0.5}), (result().drop_vars("tau"), {})):
        with pytest.raises(UserError, match="the dataset, or the point in it"):
            KineticLaw.from_result(dataset, point)


TABLES = [([1.0], [0.1]), ([1.0, 2.0], [0.1]), ([2.0, 1.0], [0.1, 0.2]), ([0.0, 1.0], [0.1, 0.2])]
BAD = [
    *({"velocity": velocity, "friction": friction} for velocity, friction in TABLES),
    *({"hurst": 1.2}, {"relaxation_time": 0.0}, {"q_max": -1.0}, {"rms_slope": 0.0}),
    *({"velocity": [1.0, 2.0], "friction": [0.0, 1.0]}, {"fastest": 0.0}),
    *({"velocity": "fast"}, {"friction": [0.1j, 1.0]}, {"q_max": None}, {"hurst": np.nan}),
    *({"q_max": [1.0, 2.0]}, {"velocity": np.ma.array([1.0, 2.0], mask=[True, False])}),
]


@pytest.mark.parametrize("changes", BAD)
def test_values_without_meaning_are_refused(changes):
    with pytest.raises(UserError, match="must") as error:
        law(**changes)
    assert isinstance(error.value, ValueError)  # as it was once
