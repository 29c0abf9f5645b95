"""First contacts that a slow branch holds for longer than a period of the line."""

import math

import numpy as np
import pytest

import elastomer_friction as ef
from elastomer_friction.kernels import Hold, Oscillation, Ramp, Sampled, Slide, programme_extent
from elastomer_friction.kernels.motion.extent import leg_mean_speed

LENGTH, SPEED, SLOW = 0.64e-3, 0.3, 1.0
REST = {"hold": {"duration": 1e-6}}  # before which nothing is carried along
SCENE = {
    "surface": {"length": LENGTH, "hurst": 0.7, "spacing": 1e-5, "roughness": 1e-6},
    "material": {"shear_modulus": 1e6, "branches": [[1e7, SLOW], [1e7, 1e-5]]},
    "normal_force": 1e-3,
    "quantities": ["trace"],
    "numerics": {"steps_per_spacing": 4, "trace": 8},
}


def trace(periods, *before, **changes):
    slide = {"slide": {"velocity": SPEED, "distance": periods * LENGTH}}
    defaults = {"programme": [*before, slide], "start": "relaxed"} | SCENE
    return ef.scene.run(**(defaults | changes)).squeeze()


def ranges(data):
    """Return the ranges of friction within a fifth of whole periods, and elsewhere."""
    place = data.trace_distance.values / LENGTH
    near = np.abs(place - np.round(place)) < 0.2
    return [np.ptp(data.trace_mu.values[(place > 0.5) & part]) for part in (near, ~near)]


def test_share_is_that_of_the_slowest_branch_after_a_period():
    data = trace(3.0, REST)
    assert float(data.trace_remembered) == pytest.approx(math.exp(-LENGTH / SPEED / SLOW), rel=1e-9)


def test_friction_repeats_the_first_contact_where_it_is_flagged():
    """Away from the first contact friction is steady; near whole periods it is not."""
    met, calm = ranges(trace(3.0, REST))
    assert met > 3.0 * calm


@pytest.mark.parametrize("body", ["foundation", "half-space"])
def test_branches_that_outlive_a_period_are_carried_along(body):
    surface = SCENE["surface"] | {"spacing": LENGTH / 32}
    data = trace(2.5, body=body, surface=surface)
    assert data.trace_remembered < 0.01
    steady = float(data.trace_mu[-1])
    assert steady > 0.0
    assert max(ranges(data)) < 1e-4 * steady


@pytest.mark.parametrize(
    "changes",
    [
        {"periods": 0.9},
        {"periods": 3.0, "start": "steady"},
        {"periods": 3.0, "material": {"shear_modulus": 1e6, "relaxation_time": 1.0}},
    ],
    ids=["no period", "steady", "dashpot"],
)
def test_nothing_is_repeated(changes):
    assert trace(**changes).trace_remembered == 0.0


@pytest.mark.parametrize(
    ("programme", "covered", "fastest"),
    [
        ((Slide(2.0, 30.0), Slide(-2.0, 10.0)), 30.0, 2.0),
        ((Slide(-2.0, 10.0), Hold(3.0), Slide(1.0, 30.0)), 30.0, 2.0),
        ((Ramp(0.0, 4.0, 10.0),), 20.0, 4.0),
        ((Ramp(-2.0, 2.0, 10.0),), 5.0, 2.0),  # returns to its start
        ((Sampled((0.0, 1.0, 3.0), (0.0, 2.0, 0.0)),), 3.0, 2.0),
    ],
)
def test_range_of_a_programme(programme, covered, fastest):
    assert programme_extent(programme) == pytest.approx((covered, fastest))


@pytest.mark.parametrize(
    ("leg", "speed"),
    [
        (Slide(-2.0, 30.0), -2.0),
        (Hold(0.0), 0.0),
        (Ramp(0.0, 4.0, 10.0), 2.0),
        (Oscillation(0.5, 3.0, 0.5, 7), 0.5),
        (Sampled((0.0, 1.0, 3.0), (0.0, 2.0, 0.0)), 1.0),
    ],
)
def test_mean_speed_of_a_leg(leg, speed):
    assert leg_mean_speed(leg) == pytest.approx(speed)


def test_range_of_an_oscillation_about_rest_is_twice_its_amplitude():
    covered, fastest = programme_extent((Oscillation(0.0, 3.0, 0.5, 7),))
    assert covered == pytest.approx(6.0)
    assert fastest == pytest.approx(3.0 * np.pi)
