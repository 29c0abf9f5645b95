"""Programmes of motion: position of the line and time at the end of every step."""

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from elastomer_friction.kernels.motion.legs import (
    Hold,
    Oscillation,
    Ramp,
    Sampled,
    Slide,
    last_speed,
    speed_at_start,
    steps_of,
)
from elastomer_friction.kernels.rheology.spectrum import MIN_DASHPOT_STEP

M = 4


@pytest.mark.parametrize(
    ("leg", "first", "last"),
    [
        (Slide(2.0, 1.0), 2.0, 2.0),
        (Hold(1.0), 0.0, 0.0),
        (Ramp(1.0, 3.0, 1.0), 1.0, 3.0),
        (Oscillation(0.5, 1.0, 1.0, 1), 0.5, 0.5 + 2.0 * math.pi),
        (Sampled((0.0, 1.0), (4.0, 5.0)), 4.0, 5.0),
    ],
)
def test_first_and_last_speed(leg, first, last):
    assert speed_at_start((leg,)) == first
    assert last_speed(leg) == pytest.approx(last)


@pytest.mark.parametrize(
    "leg",
    [
        Slide(0.0, 1.0),
        Slide(1.0, -1.0),
        Slide(math.nan, 1.0),
        Hold(-1.0),
        Ramp(1.0, 2.0, 0.0),
        Oscillation(0.0, 0.0, 1.0, 1),
        Oscillation(0.0, 1.0, 1.0, 0),
        Oscillation(0.0, 1.0, 1.0, 2.5),
        Sampled((0.0,), (1.0,)),
        Sampled((1.0, 2.0), (1.0, 1.0)),
        Sampled((0.0, 0.0), (1.0, 1.0)),
        Sampled((0.0, 1.0), (1.0, math.inf)),
    ],
    ids=str,
)
def test_legs_without_meaning_are_refused(leg):
    with pytest.raises(ValueError, match=type(leg).__name__):
        steps_of((leg,), M)


def test_steps_lost_in_rounding_are_refused():
    with pytest.raises(ValueError, match="lost in rounding"):
        steps_of((Slide(1.0 / (M * MIN_DASHPOT_STEP) * 2.0, 5.0),), M)


def distances(steps, start=0.0):
    """Return the distance of each step, in samples."""
    return np.diff(np.append(start, steps.position))


def test_a_slide_goes_by_whole_samples_all_of_one_length_of_time():
    steps = steps_of((Slide(-0.5, 6.0),), M)
    np.testing.assert_array_equal(steps.position, -np.arange(1.0, 25.0))
    assert set(steps.dt) == {1.0 / (M * 0.5)}


def test_a_distance_that_is_whole_but_for_rounding_ends_at_a_whole_sample():
    assert 0.1 * 3 * 10 * M != 12.0
    assert steps_of((Slide(1.0, 0.1 * 3 * 10),), M).position[-1] == 12.0


@given(
    speed=st.floats(-50.0, 50.0).filter(lambda v: abs(v) > 1e-3),
    distance=st.floats(0.01, 30.0),
    start=st.floats(-3.0, 3.0),
)
@example(speed=1.0, distance=0.328125, start=-1.125)
@example(speed=1.0, distance=26.0, start=1.0312054124595153e-07)
def test_a_slide_between_fractions_takes_its_time_in_steps_of_about_a_sample(
    speed, distance, start
):
    steps = steps_of((Slide(speed, distance),), M, start)
    moved = distances(steps, start)
    end = start + math.copysign(distance * M, speed)
    # An end within the rounding of a whole sample is moved there (motion/path.py).
    assert steps.position[-1] == pytest.approx(end, abs=1e-8 + 1e-9 * abs(end))
    assert steps.dt.sum() == pytest.approx(distance / abs(speed), rel=1e-6)
    np.testing.assert_allclose(moved, speed * M * steps.dt, rtol=1e-9)
    # Whole samples within a quarter of a sample of an end are skipped: at one end, or at both.
    assert np.abs(moved).max() <= (1.25 if moved.size > 1 else 1.5) + 1e-6
    assert np.abs(moved).min() >= min(0.25, distance * M) - 1e-6
    assert np.all(steps.position[:-1] % 1.0 == 0.0)


@pytest.mark.parametrize("duration", [1e-6, 1.0, 1e9])
def test_a_hold_is_geometric_from_a_quarter_of_the_time_of_a_sample(duration):
    steps = steps_of((Slide(1.0, 1.0), Hold(duration)), M)
    dt = steps.dt[steps.leg == 1]
    assert dt.sum() == pytest.approx(duration, rel=1e-12)
    np.testing.assert_allclose(dt[1:] / dt[:-1], 1.0 + 0.5 / M, rtol=1e-9)
    assert dt[0] <= 0.25 / M
    assert np.all(steps.position[steps.leg == 1] == M)
    assert dt.size < 200


def test_no_time_no_steps_and_no_change_of_what_follows():
    with_it = steps_of((Slide(1.0, 1.0), Hold(0.0), Hold(3.0)), M)
    without = steps_of((Slide(1.0, 1.0), Hold(3.0)), M)
    np.testing.assert_array_equal(with_it.dt, without.dt)
    assert set(with_it.leg) == {0, 2}
    assert steps_of((Hold(0.0),), M).dt.size == steps_of((), M).dt.size == 0


@pytest.mark.parametrize(("first", "last"), [(0.0, 3.0), (3.0, 0.5), (2.0, -3.0), (-1.0, -2.0)])
def test_a_ramp_is_at_its_whole_samples_when_its_speed_takes_it_there(first, last):
    duration = 8.0
    steps = steps_of((Ramp(first, last, duration),), M)
    t = np.cumsum(steps.dt)
    where = M * (first * t + 0.5 * (last - first) / duration * t**2)
    np.testing.assert_allclose(steps.position, where, atol=1e-7)
    assert t[-1] == pytest.approx(duration)
    assert np.abs(distances(steps)).max() < 1.3
    assert np.mean(steps.position % 1.0 == 0.0) > 0.4
    assert steps.dt.max() <= duration / 32 + 1e-12


def test_a_small_oscillation_goes_by_equal_times_the_same_in_every_cycle():
    frequency, amplitude = 0.3, 1e-3 / M
    steps = steps_of((Oscillation(0.0, amplitude, frequency, 3),), M)
    assert steps.dt.size == 3 * 64
    np.testing.assert_allclose(steps.dt, 1.0 / (64 * frequency), rtol=1e-14)
    t = np.cumsum(steps.dt)
    np.testing.assert_allclose(
        steps.position, 1e-3 * np.sin(2.0 * np.pi * frequency * t), atol=1e-15
    )
    np.testing.assert_array_equal(steps.position[:64], steps.position[64:128])


@pytest.mark.parametrize("speed", [0.0, 0.4, -30.0])
def test_a_large_oscillation_turns_where_it_turns_and_ends_its_cycles(speed):
    leg = Oscillation(speed, 5.0, 0.3, 2)
    steps = steps_of((leg,), M)
    t = np.cumsum(steps.dt)
    where = M * (speed * t + 5.0 * np.sin(2.0 * np.pi * 0.3 * t))
    np.testing.assert_allclose(steps.position, where, atol=1e-6)
    assert np.abs(t - 1.0 / 0.3).min() < 1e-12
    assert np.abs(distances(steps)).max() < 1.3
    fine = np.linspace(0.0, t[-1], 20001)
    path = M * (speed * fine + 5.0 * np.sin(2.0 * np.pi * 0.3 * fine))
    assert max(steps.position.max(), 0.0) == pytest.approx(path.max(), abs=1e-4)
    assert steps.dt.max() < 1.0 / (64 * 0.3) + 1e-9


def test_a_sampled_speed_rests_turns_and_arrives():
    leg = Sampled((0.0, 1.0, 2.0, 50.0, 51.0, 52.0), (2.0, 0.0, 0.0, 0.0, 1.5, -1.5))
    steps = steps_of((leg,), M)
    t = np.cumsum(steps.dt)
    assert t[-1] == pytest.approx(52.0)
    resting = (t > 1.0 + 1e-9) & (t < 50.0 + 1e-9)
    assert np.all(steps.position[resting] == M)
    assert 10 < np.sum(resting) < 60
    assert steps.position.max() == pytest.approx(M * (1.0 + 0.75 + 0.375), abs=1e-6)
    assert steps.position[-1] == pytest.approx(M * 1.75, abs=1e-6)


def test_a_sampled_ramp_is_the_ramp():
    ramp, sampled = (
        steps_of((leg,), M) for leg in (Ramp(0.2, 2.0, 5.0), Sampled((0.0, 5.0), (0.2, 2.0)))
    )
    np.testing.assert_array_equal(ramp.position, sampled.position)
    np.testing.assert_array_equal(ramp.dt, sampled.dt)
