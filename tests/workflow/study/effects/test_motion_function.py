"""Functions of time as motions: lines between their samples miss them by little, and jumps stay."""

import math

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study import sampled_motion


@pytest.mark.parametrize(
    "velocity",
    [
        lambda t: 0.1,
        lambda t: 0.1 + 0.05 * math.sin(2.0 * math.pi * 1009.0 / 7.0 * t),
        lambda t: np.float32(1e-3) * np.exp(-3.0 * t),
        lambda t: np.array(0.2 * abs(math.cos(9.0 * t))),
    ],
)
def test_lines_between_the_samples_miss_a_function_by_little(velocity):
    motion = sampled_motion(velocity, 2.0)
    at = np.random.default_rng(0).uniform(0.0, 2.0, 5000)
    exact = np.array([float(velocity(t)) for t in at.tolist()])
    misfit = np.interp(at, motion["time"], motion["velocity"]) - exact
    assert abs(misfit).max() < 2e-4 * abs(exact).max()
    assert motion["time"][0] == 0.0
    assert motion["time"][-1] == 2.0


def test_a_jump_takes_no_time():
    motion = sampled_motion(lambda t: 0.1 if t < 1.0 / 3.0 else 0.3, 1.0)
    times, velocities = np.array(motion["time"]), np.array(motion["velocity"])
    (jump,) = np.flatnonzero(np.diff(velocities))
    assert times[jump] < 1.0 / 3.0 <= times[jump + 1] < times[jump] + 2e-7
    assert times.size < 1100


@pytest.mark.parametrize(
    ("velocity", "words"),
    [
        (lambda t: None, r"programme\(0\) = None: must be a finite number"),
        (lambda t: [0.1], "finite number"),
        (lambda t: math.nan, "finite number"),
        (lambda t: math.sin(1e5 * t), "100000 samples in duration = 2 s; give a shorter duration"),
    ],
)
def test_a_function_that_is_no_velocity_or_too_fast_is_refused(velocity, words):
    with pytest.raises(UserError, match=words):
        sampled_motion(velocity, 2.0)
