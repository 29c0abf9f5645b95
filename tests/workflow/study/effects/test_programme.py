"""[[scene.programme]]: segments as they are written, and what a programme of them does."""

import math

import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.effects.programme import (
    FromFile,
    HoldSegment,
    Oscillate,
    RampSegment,
    Scene,
    SlideSegment,
    Velocity,
)
from elastomer_friction.workflow.study.effects.segments import read_programme
from tests.support.small import FILES


def read(tmp_path, *entries):
    (tmp_path / "velocity.csv").write_text(FILES["velocity.csv"])
    return read_programme(list(entries), tmp_path)


@pytest.mark.parametrize(
    ("entry", "segment"),
    [
        ({"slide": {"velocity": -0.1, "distance": 1e-3}}, SlideSegment(Velocity(-0.1), 1e-3)),
        ({"slide": {"ratio": 1.2, "duration": 2}}, SlideSegment(Velocity(1.2, True), None, 2.0)),
        ({"hold": {"duration": 3}}, HoldSegment((3.0,))),
        ({"hold": {"duration": [3.0]}}, HoldSegment((3.0,), several=True)),
        ({"hold": {"duration": {"geomspace": [1, 100, 3]}}}, HoldSegment((1.0, 10.0, 100.0), True)),
        (
            {"ramp": {"ratio": [1, -1], "duration": 2}},
            RampSegment(Velocity(1.0, True), Velocity(-1.0, True), 2.0),
        ),
        (
            {"oscillate": {"amplitude": 1e-4, "frequency": 10, "cycles": 3}},
            Oscillate(Velocity(0.0), 1e-4, 10.0, 3),
        ),
        ({"file": "velocity.csv"}, FromFile((0.0, 1e-3), (0.1, 0.2))),
        ({"time": [1.0, 1.5], "velocity": [0.1, 0]}, FromFile((0.0, 0.5), (0.1, 0.0))),
    ],
)
def test_segments_as_they_are_written(tmp_path, entry, segment):
    (actual,) = read(tmp_path, entry)
    assert (actual._replace(description="") if isinstance(actual, FromFile) else actual) == segment


def test_an_amplitude_of_the_velocity_is_one_of_the_path(tmp_path):
    table = {"ratio": 1, "velocity_amplitude": 0.5, "frequency": 10, "cycles": 3}
    (swing,) = read(tmp_path, {"oscillate": table})
    assert swing.velocity == Velocity(1.0, relative=True)
    assert swing.amplitude * 2.0 * math.pi * 10.0 == pytest.approx(0.5)


def test_an_oscillation_goes_on_where_a_ramp_ends(tmp_path):
    ramp = {"ramp": {"velocity": [0.1, 0.2], "duration": 1}}
    swing = {"velocity": 0.2, "amplitude": 1e-4, "frequency": 10, "cycles": 3}
    assert len(read(tmp_path, ramp, {"oscillate": swing})) == 2
    with pytest.raises(UserError, match=r"which the ramp before it ends, 0\.2 m/s"):
        read(tmp_path, ramp, {"oscillate": swing | {"velocity": 0.1}})


def test_times_of_a_file_start_at_zero(tmp_path):
    (tmp_path / "late.csv").write_text("t;v\n5;0.1\n6;0.2\n")
    (segment,) = read(tmp_path, {"file": "late.csv"})
    assert segment.times == (0.0, 1.0)


SLOW, FAST = SlideSegment(Velocity(0.1), 1e-3), SlideSegment(Velocity(0.3), None, 2.0)
BACK = SlideSegment(Velocity(-0.3), 1e-3)
OWN = SlideSegment(Velocity(1.2, relative=True), 1e-3)
REST = HoldSegment((1.0,))
SEVERAL = HoldSegment((1.0, 10.0), several=True)
SWING = Oscillate(Velocity(0.0), 1e-4, 10.0, 3)
FILE = FromFile((0.0, 1.0, 2.0), (0.0, -0.2, 0.4))


def scene(*programme):
    return Scene(programme=programme, start="relaxed")


@pytest.mark.parametrize(
    ("programme", "steps"),
    [((SLOW, FAST, REST, SLOW, SLOW, BACK), [0]), ((SLOW, REST, FAST), []), ((SLOW, OWN), [0])],
)
def test_a_step_is_from_one_slide_to_another_in_the_same_direction(programme, steps):
    assert scene(*programme).velocity_steps == steps


def test_a_hold_heals_between_slides():
    assert scene(REST, SLOW, REST, FAST, REST).heals
    assert not scene(REST, SLOW, REST, REST, FAST).heals


def test_the_durations_of_a_list_make_one_programme_each():
    several = scene(SLOW, SEVERAL, FAST, REST)
    assert several.listed == {"hold": (1.0, 10.0)}
    assert several.with_axis_value("hold", 10.0) == scene(SLOW, HoldSegment((10.0,)), FAST, REST)
    assert scene(SLOW, REST, SWING).listed == {}


def test_lists_of_an_oscillation_make_one_programme_each(tmp_path):
    """At several frequencies the amplitude that was given stays, of velocity or of displacement."""
    swing = {"ratio": 1.0, "frequency": [10, 40], "cycles": 3}
    both = {"oscillate": swing | {"velocity_amplitude": [0.5, 2.0]}}
    several = scene(*read(tmp_path, {"hold": {"duration": [1.0, 2.0]}}, both))
    axes = {"hold": (1.0, 2.0), "velocity_amplitude": (0.5, 2.0), "frequency": (10.0, 40.0)}
    assert several.listed == axes
    assert several.programme[1].amplitude == 0.5 / (2.0 * math.pi * 10.0)
    for axis in ("velocity_amplitude", "frequency", "hold"):
        several = several.with_axis_value(axis, axes[axis][1])
    assert several.programme[1].amplitude == 2.0 / (2.0 * math.pi * 40.0)
    assert several.programme[0] == HoldSegment((2.0,))
    one = scene(*read(tmp_path, {"oscillate": swing | {"amplitude": 1e-4}}))
    assert one.with_axis_value("frequency", 40.0).programme[0].amplitude == 1e-4


@pytest.mark.parametrize(
    ("programme", "velocity", "speed"),
    [
        ((REST, BACK), 7.0, 0.3),  # that of the grid, before the rest
        ((RampSegment(Velocity(0.2), Velocity(0.1), 1.0),), 0.2, 0.2),
        ((OWN,), pytest.approx(8.4), 1.2),
        ((FILE,), 0.0, 0.2),
        ((SWING,), 0.0, pytest.approx(2.0 * math.pi * 1e-3)),
        ((REST,), 7.0, 0.0),
    ],
)
def test_where_a_programme_begins_and_its_first_speed_that_is_not_zero(programme, velocity, speed):
    assert scene(*programme).start_velocity(7.0) == velocity
    assert scene(*programme).typical_speed == speed
