"""[[scene.programme]]: every kind of segment as it is written. Refusals: tests/refusals.md."""

import math

import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.study.effects.programme import (
    FromFile,
    HoldSegment,
    Oscillate,
    RampSegment,
    SlideSegment,
    Velocity,
)
from elastomer_friction.workflow.study.effects.segments import read_programme
from tests.support.small import FILES


def read(tmp_path, *entries):
    (tmp_path / "velocity.csv").write_text(FILES["velocity.csv"])
    return read_programme("scene.programme", list(entries), tmp_path)


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
    ],
)
def test_segments_as_they_are_written(tmp_path, entry, segment):
    assert read(tmp_path, entry) == (segment,)


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


@pytest.mark.parametrize("cycles", [0, 1.5])
def test_cycles_are_whole(tmp_path, cycles):
    table = {"amplitude": 1e-4, "frequency": 10, "cycles": cycles}
    with pytest.raises(UserError, match="must be a whole number, at least 1"):
        read(tmp_path, {"oscillate": table})


def test_times_of_a_file_start_at_zero(tmp_path):
    (tmp_path / "late.csv").write_text("t;v\n5;0.1\n6;0.2\n")
    (segment,) = read(tmp_path, {"file": "late.csv"})
    assert segment.times == (0.0, 1.0)
