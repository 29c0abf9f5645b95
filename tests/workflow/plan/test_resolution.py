"""Time steps: what "auto" resolves, how far is marched, and what is recorded."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.small import small_plan
from workflow.errors import UserError
from workflow.plan.resolution import MAX_SAMPLES_PER_LINE, horizon_steps, steps_per_spacing
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
def test_automatic_steps_resolve_tau_and_the_relaxation_and_are_not_twice_as_many(
    hurst, speed, ratio
):
    steps = steps_per_spacing(problem(hurst, 100, speed, ratio), ALL, Numerics())
    assert steps >= 4
    assert steps & (steps - 1) == 0  # a power of two
    rate = max(1.0, (math.pi * speed) ** (1.0 - hurst))
    dt = rate / (steps * speed * min(1.0, ratio))  # in tau or relaxation times, at the slower speed
    assert dt <= 0.5 * (1 + 1e-6)
    assert steps == 4 or 2.0 * dt > 0.5


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
    words = r"^numerics.steps_per_spacing = auto: 100000 elements .* higher velocity"
    with pytest.raises(UserError, match=words):
        steps_per_spacing(problem(elements=100_000, speed=1e-4), ALL, Numerics())


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
