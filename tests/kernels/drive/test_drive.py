"""A slider on a spring: stiff drives, work, order of convergence, stick-slip, and bodies."""

import math

import numpy as np
import pytest

from elastomer_friction.kernels import Hold, Sampled, Slide
from elastomer_friction.kernels.drive import (
    DRIVE_ENERGIES,
    PULLED_TRACES,
    Drive,
    pulled_line,
    run_pulled,
)
from elastomer_friction.kernels.drive.slider_record import SLIDER_TURNS, SLIP_BEGINS, SLIP_ENDS
from elastomer_friction.kernels.half_space.scenes import run_pulled_on_half_space
from elastomer_friction.kernels.lines.line import Line
from elastomer_friction.kernels.scene import TRACES, run_scene, scene_steps
from tests.kernels.half_space.test_limits import rough
from tests.kernels.scene.given import KELVIN, MATERIALS, PRONY, PULLS, SOLID, a_line, a_scene
from tests.sizes import PLAIN_PYTHON

M = 4
LOAD = 0.3
ANY_MATERIAL = pytest.mark.parametrize("spectrum", MATERIALS.values(), ids=MATERIALS)


def scale_of(line):
    return LOAD * math.sqrt(np.mean(line.slope**2))


def pulled(line, programme, drive, spectrum=SOLID, m=M, **changes):
    """Pull a line; drive : stiffness, mass and damping over load times rms slope."""
    scene = a_scene(programme, spectrum, m, **changes)
    return run_pulled(line, scene, Drive(*(scale_of(line) * np.array(drive))))


@ANY_MATERIAL
def test_steady_sliding_equals_that_of_a_line_that_is_moved(spectrum):
    line = a_line(20)
    steady = run_scene(line, a_scene((Slide(1.3, 4.0),), spectrum))
    result = pulled(line, (Slide(1.3, 4.0),), (0.3, 0.5, 0.2), spectrum)
    for name in TRACES:
        if name not in ("trace_time", "trace_distance"):
            np.testing.assert_allclose(result[name], steady[name][0], rtol=1e-4, err_msg=name)
    # The damper moves with the slider: only the spring carries the friction.
    np.testing.assert_allclose(
        result["trace_drive_force"], result["trace_friction_force"], rtol=1e-4
    )


@ANY_MATERIAL
def test_a_stiff_drive_takes_the_slider_along(spectrum):
    """The pulled line agrees with a line moved directly, to discretization errors."""
    legs = (Sampled((0.0, 1.0, 2.0, 4.0, 6.0), (2.0, 2.0, 1.0, 3.0, -1.0)),)
    at = np.linspace(0.1, 5.7, 100)

    def mu(result):
        return np.interp(at, result["trace_time"], result["trace_mu"])

    def error(m):
        line = a_line(12, m=m)
        driven = pulled(line, legs, (1e5,), spectrum, m)
        return math.sqrt(
            np.mean((mu(driven) - mu(run_scene(line, a_scene(legs, spectrum, m)))) ** 2)
        )

    coarse, fine = error(4), error(16)
    assert coarse < 0.03
    assert fine < 0.4 * coarse


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: sixteen marches")
@pytest.mark.parametrize("drive", [(1.0,), (1.0, 0.3, 0.1)], ids=["spring", "mass"])
@ANY_MATERIAL
def test_errors_fall_with_the_steps(spectrum, drive):
    legs = (Sampled((0.0, 1.0, 2.0, 3.0), (2.0, 2.0, 1.0, 2.5)),)
    at = np.linspace(0.1, 2.7, 100)

    def force(m):
        line = a_line(12, m=m)
        result = pulled(line, legs, drive, spectrum, m)
        force = np.interp(at, result["trace_time"], result["trace_drive_force"])
        return force / scale_of(line)

    best = force(64)
    errors = [math.sqrt(np.mean((force(m) - best) ** 2)) for m in (4, 16)]
    assert errors[1] < 0.35 * errors[0]
    assert errors[1] < 0.01


@pytest.mark.parametrize("on_map", [False, True], ids=["line", "map"])
@pytest.mark.parametrize("drive", [(1.0,), (1.0, 0.0, 0.1), (1.0, 0.3), (1.0, 0.3, 0.1)])
def test_the_work_of_the_drive_is_that_of_friction_spring_damper_and_mass(drive, on_map):
    m, programme = (4 if on_map else 32), (Slide(1.3, 4.0), Slide(2.6, 4.0))
    surface = rough(8, m) if on_map else a_line(20, m=m)
    pull, factor = (run_pulled_on_half_space, m) if on_map else (run_pulled, 1)
    scene = a_scene(programme, PRONY, m, requested=("trace", "energy"))
    result = pull(surface, scene, Drive(*(scale_of(surface) * np.array(drive))))
    driven, friction, spring, kinetic, damper, error = (result[name] for name in DRIVE_ENERGIES)
    spent = friction + spring - spring[0] + kinetic - kinetic[0] + damper + error
    np.testing.assert_allclose(driven, spent, rtol=0.0, atol=1e-5 * driven[-1])
    assert np.abs(error).max() < (3e-3 if on_map else 3e-4) * driven[-1]
    assert error.any() == (len(drive) > 1 and drive[1] > 0.0)
    time, place, force = (
        result[f"trace_{name}"] for name in ("time", "distance", "friction_force")
    )
    assert friction[-1] == pytest.approx(np.trapezoid(force, place), rel=2e-3 * factor)
    stretch = np.where(time < 4.0 / 1.3, 1.3 * time, 4.0 + 2.6 * (time - 4.0 / 1.3)) - place
    k = drive[0] * scale_of(surface)
    stretch += math.sqrt(2.0 * spring[0] / k) - stretch[0]
    np.testing.assert_allclose(spring, 0.5 * k * stretch**2, rtol=0.02 * factor, atol=0.0)


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: two ways of 3000 spacings")
def test_stick_and_slip_occurs_only_below_the_critical_stiffness():
    """k_c = -(d mu/d ln v) F_N / (v t_b), t_b the branch's time (Rice & Ruina, 1983)."""
    line = a_line(100, 0.7)
    speeds = 30.0 * np.array([0.97, 1.0, 1.03])
    mu = [run_scene(line, a_scene((Slide(v, 1.0),), SOLID))["trace_mu"][0] for v in speeds]
    weakening = -(mu[2] - mu[0]) / math.log(speeds[2] / speeds[0])
    assert weakening > 0.0
    critical = weakening * LOAD / (speeds[1] * SOLID.times[0]) / scale_of(line)
    result = []
    for share in (5.0, 0.3):
        legs = (Slide(speeds[1], 3000.0),)
        requested = ("trace", "stick_slip", "slip_events")
        result.append(pulled(line, legs, (share * critical,), start="relaxed", requested=requested))
    steady, slipping = result
    assert steady["drive_swing"] < 0.02 * slipping["drive_swing"]
    assert steady["peak_velocity"] < 1.1 * speeds[1] < 2.0 * speeds[1] < slipping["peak_velocity"]
    assert np.isnan(steady["slip_period"])
    # Between slips the spring extends at nearly the velocity of the drive.
    swing = float(slipping["drive_swing"]) * LOAD
    loading = swing / (0.3 * critical * scale_of(line) * speeds[1])
    assert 0.2 * loading < float(slipping["slip_period"]) < 4.0 * loading
    assert SLIP_ENDS not in steady["slip_event_kind"]  # it breaks loose once, then slides on
    time, kind = slipping["slip_event_time"], slipping["slip_event_kind"]
    begins, ends = (time[kind == event] for event in (SLIP_BEGINS, SLIP_ENDS))
    assert (begins[: ends.size] < ends).all()
    assert (ends[: begins.size - 1] < begins[1:]).all()
    late = begins[begins > 0.5 * 3000.0 / speeds[1]]
    assert np.mean(np.diff(late)) == pytest.approx(float(slipping["slip_period"]), rel=0.02)


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: six ways of 400 spacings")
def test_stick_and_slip_without_a_mass_converges_at_second_order():
    """The line is one wave, which jumps by its length.

    Each jump is one slip, however many steps it takes.
    """
    speed, length = 30.0, 8

    def swing_and_period(m, stiffness):
        x = 2.0 * np.pi * np.arange(length * m) / (length * m)
        line = Line.from_samples(np.cos(x), -2.0 * np.pi / length * np.sin(x), m)
        legs, requested = (Slide(speed, 400.0),), ("trace", "stick_slip", "slip_events")
        result = pulled(line, legs, (stiffness,), m=m, start="relaxed", requested=requested)
        distance = speed * result["trace_time"]
        distance, force = (
            series[distance > 200.0] for series in (distance, result["trace_drive_force"])
        )
        force = force - 0.5 * (force.max() + force.min())
        i = np.flatnonzero((force[:-1] < 0.0) & (force[1:] >= 0.0))
        rises = distance[i] - force[i] / (force[i + 1] - force[i]) * (distance[i + 1] - distance[i])
        assert rises.size > 10
        rise = np.mean(np.diff(rises))
        assert speed * float(result["slip_period"]) == pytest.approx(rise, rel=2e-3)
        time, kind = result["slip_event_time"], result["slip_event_kind"]
        begins, ends = (time[kind == event] for event in (SLIP_BEGINS, SLIP_ENDS))
        assert (begins[: ends.size] < ends).all()
        assert (ends[: begins.size - 1] < begins[1:]).all()
        late = begins[speed * begins > 200.0]
        assert speed * np.mean(np.diff(late)) == pytest.approx(rise, rel=0.02)
        return float(result["drive_swing"]), rise

    coarse, fine, best = (
        np.array([swing_and_period(m, stiffness) for stiffness in (0.02, 0.03)])
        for m in (8, 32, 64)
    )
    errors = [np.sqrt(np.mean((run / best - 1.0) ** 2, axis=0)) for run in (coarse, fine)]
    assert (best[:, 1] > length).all()
    # The ratio of errors is (1/8 - 1/64)/(1/32 - 1/64) = 7 at first order, and 21 at second.
    assert (errors[1] < errors[0] / 12.0).all()
    assert (errors[1] < 1e-3).all()


def test_a_slider_on_a_stiff_drive_turns_with_it():
    legs = (Sampled((0.0, 2.0, 4.0, 6.0), (1.5, 1.5, -1.5, 1.5)),)
    result = pulled(a_line(20, m=16), legs, (1e4,), KELVIN, 16, requested=("trace", "slip_events"))
    known = np.isfinite(result["slip_event_time"])
    assert result["slip_event_kind"][known].tolist() == [SLIDER_TURNS, SLIDER_TURNS]
    assert result["slip_event_time"][known] == pytest.approx([3.0, 5.0], abs=0.05)


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: many periods of a mass")
@pytest.mark.parametrize("amplitude", [1.5, 8.0])
def test_a_mass_that_rings_about_steady_sliding_does_not_slip(amplitude):
    """Friction is negligible: the speed is nearly V + A V cos(w t) throughout, w^2 = k/M."""
    line, speed, frequency, stiffness = a_line(12, m=16), 2.0, 4.0, 1e3
    swings = Sampled((0.0, 1e-3, 40.0), ((1.0 - amplitude) * speed, speed, speed))
    drive = stiffness, stiffness / frequency**2
    result = pulled(line, (swings,), drive, SOLID, 16, requested=("trace", "stick_slip"))
    force = 2.0 * amplitude * speed * stiffness / frequency * scale_of(line) / LOAD
    assert 0.6 * force < result["drive_swing"] < 1.05 * force
    assert result["peak_velocity"] > 2.0 * speed
    assert np.isnan(result["slip_period"])


def test_values_at_the_end_of_a_hold_belong_to_the_hold():
    """With a dashpot, friction jumps when the drive moves again, which is after the hold."""
    legs = (Slide(1.3, 3.0), Hold(30.0), Slide(1.3, 3.0))
    line = a_line(20)
    scene = a_scene(legs, KELVIN, M)
    steps = scene_steps(scene, M)
    end = int(np.flatnonzero(steps.leg == 1)[-1]) + 1  # number of the last step of the hold
    mu = run_pulled(line, scene, Drive(1e5 * scale_of(line)))["trace_mu"]
    assert abs(mu[end]) < 1e-2 * mu[0]
    assert mu[end + 1] > 0.1 * mu[0]


def test_a_slack_spring_is_stretched_before_the_line_slides():
    line = a_line(40)
    result = pulled(line, (Slide(1.0, 8.0),), (0.1,), KELVIN, start="relaxed")
    assert result["trace_drive_force"][0] == 0.0
    early = result["trace_time"] < 0.5
    np.testing.assert_array_less(result["trace_distance"][early], 0.5)


def test_recorded_times_depend_on_the_drive_only():
    scene = a_scene(PULLS, SOLID)
    times = [run_pulled(a_line(20, seed=seed), scene, Drive(0.1))["trace_time"] for seed in (1, 2)]
    np.testing.assert_array_equal(*times)


def test_both_schemes_have_the_same_limit():
    line = a_line(12, m=32)
    result = [
        pulled(line, (Slide(1.3, 2.0), Slide(2.6, 3.0)), (1.0,), m=32, scheme=scheme)
        for scheme in ("exponential", "implicit-euler")
    ]
    np.testing.assert_allclose(result[0]["trace_mu"], result[1]["trace_mu"], atol=0.02)


@ANY_MATERIAL
def test_elements_that_cannot_touch_change_rounding_only(monkeypatch, spectrum):
    """The tolerance is wide because a slider that nearly sticks amplifies rounding."""
    line = a_line(20)

    def traces():
        result = pulled(line, PULLS, (0.3, 0.5, 0.2), spectrum, load=0.03)
        return [result[name] for name in PULLED_TRACES]

    some = traces()
    monkeypatch.setattr(pulled_line, "block_line", pulled_line.element_line)
    for part, every in zip(some, traces(), strict=True):
        np.testing.assert_allclose(part, every, rtol=0.0, atol=1e-8 * np.max(np.abs(every)))
