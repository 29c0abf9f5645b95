"""Time steps: what "auto" resolves, how far is marched, and what is recorded."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kernels import SCHEMES, Case, Line, Quantities, amplitudes, draw_phases, run_case
from tests.workflow.small import small_plan
from workflow.errors import UserError
from workflow.plan.problems import speed_ratio
from workflow.plan.resolution import (
    MAX_SAMPLES_PER_LINE,
    expected_rate,
    horizon_steps,
    steps_per_spacing,
)
from workflow.simulate.realizations import record_steps, record_times
from workflow.simulate.tasks import Problem
from workflow.study.numerics import Numerics
from workflow.study.study import Scene

HURST = st.floats(0.0, 1.0)
SPEED = st.floats(1e-3, 1e3)
RATIO = st.floats(0.1, 10.0)
ALL = Scene()


def problem(hurst=0.7, elements=100, speed=1.0, ratio=1.2):
    """Return a problem."""
    return Problem(hurst, elements, 0.1, speed, ratio)


@given(HURST, SPEED, RATIO)
def test_automatic_steps_are_a_power_of_two_of_at_least_four(hurst, speed, ratio):
    steps = steps_per_spacing(problem(hurst, 100, speed, ratio), ALL, Numerics())
    assert steps >= 4
    assert steps & (steps - 1) == 0


@given(HURST, SPEED, RATIO)
def test_automatic_steps_resolve_tau_before_and_after_the_jump(hurst, speed, ratio):
    steps = steps_per_spacing(problem(hurst, 100, speed, ratio), ALL, Numerics())
    for v in (speed, ratio * speed):
        assert 1.0 / (steps * v) <= 0.5 * (1 + 1e-6)  # dt in tau


@given(HURST, SPEED, RATIO)
def test_automatic_steps_resolve_the_relaxation(hurst, speed, ratio):
    steps = steps_per_spacing(problem(hurst, 100, speed, ratio), ALL, Numerics())
    rate = max(1.0, (math.pi * speed) ** (1.0 - hurst))
    assert rate / (steps * speed * min(1.0, ratio)) <= 0.5 * (1 + 1e-6)


@given(HURST, SPEED, RATIO)
def test_automatic_steps_are_not_twice_what_is_needed(hurst, speed, ratio):
    one = problem(hurst, 100, speed, ratio)
    steps = steps_per_spacing(one, ALL, Numerics())
    dt = 1.0 / (steps / 2 * speed)
    assert steps == 4 or dt / min(1.0, ratio) * expected_rate(one) > 0.5


@given(HURST, SPEED, RATIO)
def test_eight_steps_without_a_relaxation(hurst, speed, ratio):
    scene = Scene(("steady", "jump"))
    assert steps_per_spacing(problem(hurst, 100, speed, ratio), scene, Numerics()) == 8


@given(HURST, SPEED)
def test_a_first_order_scheme_takes_more_steps(hurst, speed):
    one = problem(hurst, 100, speed)
    second = steps_per_spacing(one, ALL, Numerics("exponential"))
    first = steps_per_spacing(one, ALL, Numerics("implicit-euler"))
    assert first >= 4 * second


def test_given_steps_are_taken_as_they_are():
    assert steps_per_spacing(problem(), ALL, Numerics(steps_per_spacing=3)) == 3


def test_a_line_too_long_names_the_setting_and_the_way_out():
    with pytest.raises(UserError, match=r"^numerics.steps_per_spacing = auto: ") as error:
        steps_per_spacing(problem(elements=100_000, speed=1e-4), ALL, Numerics())
    assert "100000 elements" in str(error.value)
    assert "higher velocity" in str(error.value)


def test_the_longest_line_allowed_is_allowed():
    numerics = Numerics(steps_per_spacing=MAX_SAMPLES_PER_LINE // 100)
    assert steps_per_spacing(problem(elements=100), ALL, numerics) == MAX_SAMPLES_PER_LINE // 100
    with pytest.raises(UserError, match=r"^numerics.steps_per_spacing = 60000: "):
        steps_per_spacing(problem(elements=101), ALL, numerics)


@pytest.mark.parametrize("velocity", ["1e-320", "5e-324"])
def test_a_velocity_next_to_zero_is_refused(velocity):
    with pytest.raises(UserError):
        small_plan(f"grid.velocity={velocity}")


@given(HURST, SPEED, RATIO, st.floats(1.0, 100.0), st.integers(1, 1024))
def test_march_covers_the_horizon_and_no_more(hurst, speed, ratio, horizon, steps):
    one = problem(hurst, 100, speed, ratio)
    march = horizon_steps(one, Numerics(horizon=horizon), steps)
    needed = horizon / max(1.0, (math.pi * speed) ** (1.0 - hurst)) * steps * speed * ratio
    assert march >= 8
    assert march >= needed
    assert march == 8 or march < needed * (1 + 1e-9) + 1


@given(st.integers(8, 10**6), st.integers(8, 600))
def test_recorded_steps_run_from_the_first_to_the_last(march, samples):
    recorded = record_steps(march, samples)
    assert (recorded[0], recorded[-1]) == (1, march)
    assert np.all(np.diff(recorded) >= 1)
    assert recorded.size <= samples - 1


def test_every_step_is_recorded_where_there_are_few():
    assert record_steps(10, 64).tolist() == list(range(1, 11))


def test_speed_ratio_is_the_abscissa_of_figure_7():
    velocity, tau, spacing = 0.05, 1e-3, 1e-5
    q_max = math.pi / spacing
    assert speed_ratio(problem(speed=velocity * tau / spacing)) == pytest.approx(
        velocity * tau * q_max
    )


def deviation(moments, steps, lag=None):
    """Return mu - mu_2 of 8 lines at moments of slow creep after a jump, with m = ``steps``.

    lag : where within a step friction acts, other than by the scheme.
    """
    speed, total = 0.3, 0.0
    steps_per_tau = 1.2 * speed * steps
    recorded = np.arange(1, int(3 * steps_per_tau))
    times = (
        record_times(recorded, steps_per_tau, "exponential")
        if lag is None
        else (recorded - lag) / steps_per_tau
    )
    for seed in range(8):
        phases = draw_phases(np.random.default_rng(seed), 200)
        line = Line.self_affine(amplitudes(0.0, 200), phases, 200, steps)
        found = run_case(line, Case(0.1, speed, (1.2,), (recorded,), "exponential"), Quantities())
        total += np.interp(moments, times, found.curves[0] - found.mu_2[0])
    return total


def test_recorded_friction_belongs_to_its_times():
    moments = np.linspace(0.5, 2.0, 12)
    limit = deviation(moments, 256)
    error = {m: np.abs(deviation(moments, m) / limit - 1.0).max() for m in (16, 64)}
    at_the_end = np.abs(deviation(moments, 16, lag=0.0) / limit - 1.0).max()
    assert error[16] < 0.02
    assert error[64] < 0.002
    assert at_the_end > 0.08  # of first order


@pytest.mark.parametrize("scheme", SCHEMES)
def test_recorded_times_lie_within_their_steps(scheme):
    recorded = np.array([1, 2, 7])
    for steps_per_tau in (0.1, 1.0, 30.0):
        times = record_times(recorded, steps_per_tau, scheme) * steps_per_tau
        assert np.all((times <= recorded) & (times > recorded - 1))
