"""A scene that is pulled through a spring, as a user asks for it: units, axes, both bodies."""

import numpy as np
import pytest

from elastomer_friction.workflow.plan import make_plan
from tests.support.documents import without
from tests.support.small import small_study
from tests.workflow.scene.scenes import KELVIN, LENGTH, PULL, N, run

VELOCITY = 0.1


def pulled(stiffness, *programme, mass=0.0, **changed):
    drive = {"stiffness": stiffness, "mass": mass}
    return run(*(programme or [PULL]), drive=drive, **changed)


def test_from_rest_the_spring_is_stretched_at_the_drives_velocity():
    """F = k V t while the line has hardly moved, in newtons, metres and seconds."""
    stiffness = 100.0
    actual = pulled(stiffness, start="relaxed", material=KELVIN)
    stretch = VELOCITY * actual.trace_time - actual.trace_distance
    early = (actual.trace_time > 0.0) & (actual.trace_time < 0.3 * actual.trace_time[-1])
    force = actual.trace_drive_force.where(early, drop=True)
    np.testing.assert_allclose(force, stiffness * stretch.where(early, drop=True), rtol=0.05)
    assert float(actual.trace_drive_force[0]) == 0.0


def test_a_heavy_slider_gathers_way_as_newton_says():
    """The impulse of drive less friction is its momentum, all in SI."""
    mass = 0.05
    actual = pulled(2e4, start="relaxed", mass=mass)
    driven = actual.trace_drive_force - actual.trace_friction_force
    impulse = float(np.trapezoid(driven, actual.trace_time))
    assert impulse == pytest.approx(mass * float(actual.trace_velocity[-1]), rel=0.03)


def test_stiffness_and_the_velocity_of_the_grid_are_axes():
    text = without("grid.velocity_step")
    study = small_study(
        "scene.drive={stiffness=[1e3, 1e4, 1e5], mass=1e-3}",
        "scene.programme=[{pull={ratio=1, distance=1e-3}}]",
        'scene.quantities=["steady", "trace"]',
        "grid.velocity=[0.01, 0.1]",
        text=text,
    )
    variant = make_plan(study).variants[0]
    drives = {task.problem.drive for task in variant.tasks}
    assert study.axes[-1] == "stiffness"
    assert len({drive.stiffness for drive in drives}) == 3
    by_stiffness = sorted({drive.stiffness for drive in drives})
    np.testing.assert_allclose(by_stiffness[2] / by_stiffness[0], 100.0, rtol=1e-9)


def test_a_machine_per_normal_force_is_scaled_to_that_of_each_point():
    def drives(machine, *forces):
        study = small_study(
            f"scene.drive={machine}",
            "scene.programme=[{pull={ratio=1, distance=1e-3}}]",
            'scene.quantities=["trace"]',
            f"grid.normal_force={list(forces)}",
            text=without("grid.velocity_step"),
        )
        return {task.problem.drive for task in make_plan(study).variants[0].tasks}

    scaled = "{stiffness=3e3, mass=1e-3, damping=0.2, per_normal_force=true}"
    expected = drives("{stiffness=6e3, mass=2e-3, damping=0.4}", 2.0)
    expected |= drives("{stiffness=9e3, mass=3e-3, damping=0.6}", 3.0)
    assert len(expected) == 2
    assert drives(scaled, 2.0, 3.0) == expected


def test_sticking_and_slipping_is_told_by_swing_period_and_velocity():
    actual = pulled(
        1e9,
        {"pull": {"velocity": VELOCITY, "distance": 64 * LENGTH / N}},
        quantities=("steady", "stick_slip"),
    )
    assert float(actual.drive_swing) < 1e-3 * float(actual.mu_1)
    assert float(actual.peak_velocity) == pytest.approx(VELOCITY, rel=1e-3)
    assert np.isnan(float(actual.slip_period))


def test_when_a_slider_turns_is_a_list_in_seconds():
    back = {"pull": {"velocity": -VELOCITY, "distance": 32 * LENGTH / N}}
    there = PULL["pull"]["distance"] / VELOCITY
    actual = pulled(1e9, PULL, back, quantities=("trace", "slip_events"), start="relaxed")
    assert actual.slip_event_kind.values.tolist() == [2]
    assert actual.slip_event_kind.attrs["flag_meanings"].split()[3] == "reversal"
    assert float(actual.slip_event_time[0]) == pytest.approx(there, rel=0.02)
