"""Scenes pulled by a spring: units, axes and both bodies."""

import numpy as np
import pytest

from elastomer_friction.workflow.plan import make_plan
from elastomer_friction.workflow.reduce.resolution import RESOLVED, UNRESOLVED
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


def test_a_heavy_slider_accelerates_by_the_net_force():
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


def test_steady_pulling_has_no_swing_and_no_slip_period():
    actual = pulled(
        1e9,
        {"pull": {"velocity": VELOCITY, "distance": 64 * LENGTH / N}},
        quantities=("steady", "stick_slip"),
    )
    assert float(actual.drive_swing) < 1e-3 * float(actual.mu_1)
    assert float(actual.peak_velocity) == pytest.approx(VELOCITY, rel=1e-3)
    assert np.isnan(float(actual.slip_period))


@pytest.mark.parametrize(("damping", "status"), [(0.0, UNRESOLVED), (5e-8, RESOLVED)])
def test_a_slider_that_another_valley_may_catch_is_unresolved(damping, status):
    """Without a damper the mass rings until it is caught; finer steps change its swing by 8 %."""
    phases = (6.2549, 4.9804, 3.9093, 6.2138, 1.3528, 1.0066, 3.8487, 0.2761)
    phases += (0.2242, 3.2351, 2.9293, 5.7627, 3.9536, 3.2303, 3.1220, 1.5552)
    x = 2.0 * np.pi * np.arange(128) / 128
    waves = enumerate(phases, start=1)
    actual = run(
        {"pull": {"velocity": 0.5, "distance": 3e-3}},
        profile=sum(1.2085775e-6 * k**-1.2 * np.cos(k * x + phase) for k, phase in waves),
        length=2e-3,
        normal_force=8e-4,
        material={"shear_modulus": 1e6, "branches": [[6e6, 2e-4], [4e6, 3e-5]]},
        drive={"stiffness": 0.004, "mass": 1e-13, "damping": damping},
        start="relaxed",
        quantities=["trace", "stick_slip"],
        numerics={"steps_per_spacing": 8},
    )
    assert actual.slip_resolution_status == status
    assert (actual.trace_resolution_status == UNRESOLVED) == (status == UNRESOLVED)
    assert (float(actual.drive_swing_bias) > 0.02) == (status == UNRESOLVED)


def test_a_trace_of_every_step_holds_those_of_a_slip_and_energies_that_balance():
    """With trace = 1 steps end at samples: from one to the next, or at a turn."""
    drive = {"stiffness": 0.01, "mass": 1e-13, "damping": 5e-8}
    spectrum = {"hurst": 0.7, "roughness": 1e-6, "spacing": 2e-5, "length": 2e-3}
    actual = run(
        {"pull": {"velocity": 0.5, "distance": 2e-3}},
        {"pull": {"velocity": 0.0, "duration": 1e-4}},
        profile=None,
        length=None,
        surface=spectrum,
        normal_force=8e-4,
        material={"shear_modulus": 1e6, "branches": [[1e7, 1e-4]]},
        drive=drive,
        start="relaxed",
        quantities=["trace", "stick_slip", "energy"],
        numerics={"steps_per_spacing": 8, "trace": 1},
    )
    moved = np.abs(np.diff(actual.trace_distance)) * 8 / spectrum["spacing"]
    assert np.isfinite(actual.trace_mu).all()
    assert (np.diff(actual.trace_time) > 0.0).all()
    assert moved.max() < 1.01
    assert float(np.abs(actual.trace_velocity).max()) >= float(actual.peak_velocity)
    assert actual.trace_segment.values[[0, -1]].tolist() == [0, 1]
    assert abs(float(actual.balance_residual)) < 1e-3


def test_times_of_reversals_are_in_seconds():
    back = {"pull": {"velocity": -VELOCITY, "distance": 32 * LENGTH / N}}
    there = PULL["pull"]["distance"] / VELOCITY
    actual = pulled(1e9, PULL, back, quantities=("trace", "slip_events"), start="relaxed")
    assert actual.slip_event_kind.values.tolist() == [2]
    assert actual.slip_event_kind.attrs["flag_meanings"].split()[3] == "reversal"
    assert float(actual.slip_event_time[0]) == pytest.approx(there, rel=0.02)
