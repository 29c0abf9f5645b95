"""Friction of a half-space at the temperature to which it heats the contact."""

import math

import numpy as np
import pytest

from elastomer_friction.kernels import Case, Hold, Quantities, ShiftTable, Slide, Wlf
from elastomer_friction.kernels.drive import DRIVE_ENERGIES, Drive
from elastomer_friction.kernels.half_space.body import HalfSpace
from elastomer_friction.kernels.half_space.cases import run_case
from elastomer_friction.kernels.half_space.heating import Heating
from elastomer_friction.kernels.half_space.hot_sliding import slide_with_heat
from elastomer_friction.kernels.half_space.scenes import (
    run_pulled_on_half_space,
    run_scene_on_half_space,
)
from elastomer_friction.kernels.heat.heat import Heat
from elastomer_friction.kernels.interface.effects import Effects
from elastomer_friction.kernels.interface.shear import ShearLaw, ShearTable
from elastomer_friction.kernels.rheology.forms import form_of
from tests.kernels.half_space.test_limits import rough
from tests.kernels.scene.given import PRONY, a_scene

M, LOAD, SPEED = 4, 0.3, 0.7
STEPS = np.array([1, 3, 9, 20])
WARM = Heat(40.0, 0.5, 0.0, Wlf(8.86, 101.6, 20.0), 20.0, 0.01)


def hot_case(heat, speed=SPEED, ratios=(2.0,)):
    effects = Effects(heat=heat)
    return Case(LOAD, speed, ratios, (STEPS,) * len(ratios), "exponential", PRONY, effects=effects)


def hot_scene(heat, programme, **changes):
    return a_scene(programme, PRONY, M, effects=Effects(heat=heat), **changes)


@pytest.mark.parametrize(
    "heat",
    [
        WARM._replace(warming=1e-14),  # an infinite conductivity
        WARM._replace(shift=ShiftTable(((-300.0, 0.0), (1e5, 0.0)))),  # a constant a_T
    ],
    ids=["conducting", "constant"],
)
def test_heat_that_changes_no_rate_changes_no_number(heat):
    surface = rough(8, M)
    cold, hot = (run_case(surface, hot_case(h), Quantities()) for h in (None, heat))
    for name in ("mu_1", "mu_2", "contact_fraction"):
        np.testing.assert_allclose(getattr(hot, name), getattr(cold, name), rtol=1e-9)
    np.testing.assert_allclose(hot.curves[0], cold.curves[0], rtol=1e-9)
    legs = (Slide(0.7, 2.0), Hold(1.0), Slide(-1.4, 3.3))
    for run, more in ((run_scene_on_half_space, ()), (run_pulled_on_half_space, (Drive(0.3),))):
        cold, hot = (run(surface, hot_scene(h, legs), *more) for h in (None, heat))
        np.testing.assert_allclose(hot["trace_mu"], cold["trace_mu"], rtol=1e-9, atol=1e-12)


def steady(heat, speed=SPEED, surface=None):
    surface = surface or rough(8, M)
    space = HalfSpace.under(form_of(PRONY, "exponential"), surface, LOAD)
    heating = Heating.of(space, Effects(heat=heat), 1.0 / (M * abs(speed)))
    return slide_with_heat(space, PRONY, heating, speed), heating


def test_steady_sliding_is_that_at_the_reduced_speed_and_its_flux_is_its_power():
    hot, heating = steady(WARM._replace(block=3.0))
    warmth, friction = hot.warmth, hot.sliding.mu
    assert 5.0 < warmth.contact - 20.0 < heating.flash(warmth) - 20.0
    shift = 10.0 ** (WARM.shift.decades(warmth.contact) - WARM.shift.decades(20.0))
    np.testing.assert_allclose(hot.slowing, shift, rtol=1e-3)
    cold = run_case(rough(8, M), hot_case(None, SPEED * hot.slowing), Quantities())
    np.testing.assert_allclose(friction, cold.mu_1, rtol=1e-5)
    power = friction * LOAD / 8.0 * SPEED  # per area, E* h^2/(dx tau)
    mean = warmth.rise[0, 0].real / (8 * M) ** 2
    np.testing.assert_allclose(mean, WARM.warming * power * 3.0, rtol=1e-9)
    assert hot.solutions <= 10


def test_a_march_stays_at_the_steady_root_and_comes_to_it_from_rest():
    heat = WARM._replace(diffusivity=20.0, block=2.0)  # soon steady
    root, heating = steady(heat)
    trace = run_scene_on_half_space(rough(8, M), hot_scene(heat, (Slide(SPEED, 8.0),)))
    temperatures = trace["trace_contact_temperature"]
    assert temperatures[0] == root.warmth.contact
    np.testing.assert_allclose(temperatures, root.warmth.contact, atol=0.5)  # K, of a step
    flash = trace["trace_flash_temperature"]
    np.testing.assert_allclose(flash, heating.flash(root.warmth), atol=1.0)
    rest = hot_scene(heat, (Slide(SPEED, 48.0),), start="relaxed")
    trace = run_scene_on_half_space(rough(8, M), rest)
    assert trace["trace_contact_temperature"][0] == 20.0
    for name in ("trace_mu", "trace_contact_temperature"):
        last = trace[name][-8 * M :].mean()
        np.testing.assert_allclose(
            last, {"trace_mu": root.sliding.step_mu}.get(name, root.warmth.contact), rtol=0.02
        )


def test_reversal_reverses_friction_and_keeps_the_temperature():
    surface = rough(8, M)
    mirrored = surface._replace(
        z=np.roll(surface.z[:, ::-1], 1, 1).copy(),
        slope=-np.roll(surface.slope[:, ::-1], 1, 1).copy(),
    )
    (forward, _), (backward, _) = steady(WARM), steady(WARM, -SPEED, mirrored)
    np.testing.assert_allclose(backward.sliding.mu, -forward.sliding.mu, rtol=1e-5)
    np.testing.assert_allclose(backward.warmth.contact, forward.warmth.contact, rtol=1e-5)


def test_a_step_that_warms_by_more_than_a_kelvin_is_taken_at_its_mean_temperature():
    heat = WARM._replace(warming=2000.0)
    scene = hot_scene(heat, (Slide(SPEED, 3.0),), start="relaxed")
    trace = run_scene_on_half_space(rough(8, M), scene)
    means = trace["trace_contact_temperature"]
    assert means[1] > 35.0  # the first step warms by 36 K
    fine = run_scene_on_half_space(
        rough(8, 2 * M),
        a_scene((Slide(SPEED, 3.0),), PRONY, 2 * M, start="relaxed", effects=scene.effects),
    )
    assert abs(means[-1] / fine["trace_contact_temperature"][-1] - 1.0) < 0.05


def test_a_temperature_beyond_a_table_of_shifts_is_refused_with_speed_and_temperature():
    heat = WARM._replace(warming=2000.0, shift=ShiftTable(((0.0, 2.0), (30.0, -1.0))))
    with pytest.raises(
        ValueError, match=r"at v = 0.007 m/s the contact reaches [\d.]+ °C.*0 to 30 °C"
    ):
        run_case(rough(8, M), hot_case(heat), Quantities(jump=False, relaxation=False))
    with pytest.raises(ValueError, match=r"heat: at v = 0.007 m/s"):
        run_scene_on_half_space(rough(8, M), hot_scene(heat, (Slide(SPEED, 3.0),), start="relaxed"))


def test_rates_after_a_step_are_those_of_the_warm_rubber():
    hot, _ = steady(WARM)
    outcome = run_case(rough(8, M), hot_case(WARM), Quantities(initial_rate=True))
    cold = run_case(rough(8, M), hot_case(None, SPEED * hot.slowing), Quantities(initial_rate=True))
    np.testing.assert_allclose(outcome.initial_rate, cold.initial_rate / hot.slowing, rtol=1e-3)
    assert 0.0 < outcome.mu_2[0] != cold.mu_2[0]


def test_a_drive_with_shear_and_heat_has_the_limits_of_each_and_loses_no_energy():
    """Of friction beyond the viscoelastic part, shear is tau A; at rest it is at most that."""
    surface, stress = rough(8, M), 0.1
    legs = (Slide(0.7, 3.0), Hold(1.0), Slide(1.4, 3.0))

    def pulled(stress, heat):
        shear = None if stress is None else ShearLaw(ShearTable((math.inf,), (stress,)))
        effects, requested = Effects(shear, heat=heat), ("trace", "energy")
        scene = a_scene(legs, PRONY, M, start="relaxed", effects=effects, requested=requested)
        return run_pulled_on_half_space(surface, scene, Drive(0.3))

    def assert_equal_friction(result, expected, tolerance):
        force = expected["trace_friction_force"]
        atol = tolerance * np.ptp(force)
        np.testing.assert_allclose(result["trace_friction_force"], force, rtol=0.0, atol=atol)

    both, without_shear = pulled(stress, WARM), pulled(None, WARM)
    conducting = WARM._replace(warming=1e-14)
    assert_equal_friction(pulled(stress, conducting), pulled(stress, None), 1e-4)
    assert_equal_friction(pulled(0.0, WARM), without_shear, 1e-4)
    assert both["trace_contact_temperature"][-1] > without_shear["trace_contact_temperature"][-1]
    part = both["trace_friction_force"] / both["trace_normal_force"] - both["trace_mu"]
    largest = stress * both["trace_contact_fraction"] * 8.0 / LOAD
    assert (np.abs(part) < 1.01 * largest).all()
    assert np.isclose(part, largest, rtol=0.01).mean() > 0.3
    driven, friction, spring, kinetic, damper, error = (both[name][-1] for name in DRIVE_ENERGIES)
    assert kinetic == damper == error == 0.0
    assert driven == pytest.approx(friction + spring, rel=1e-4)
