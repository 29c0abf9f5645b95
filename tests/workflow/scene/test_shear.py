"""The shear of the real contact of a half-space: friction is the sum of two parts."""

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.kernels import Bell, ShearLaw, ShearTable, shear_stress
from elastomer_friction.kernels.interface.shear import check_fastest
from elastomer_friction.workflow.plan.plan import make_plan
from elastomer_friction.workflow.reduce.shear_sums import add_shear
from elastomer_friction.workflow.result import body_in_words
from elastomer_friction.workflow.run.grid_run import run_plan
from elastomer_friction.workflow.run.workers import RunOptions
from elastomer_friction.workflow.scene import call
from elastomer_friction.workflow.simulate.tasks import SCALARS
from elastomer_friction.workflow.study.cluster import LOCAL, Cluster
from tests.support.small import small_study
from tests.workflow.scene.scenes import run_on_half_space

PRESSURE, LENGTH, SHORTEST = 2e5, 1e-3, 1.25e-4
SURFACE = {"length": LENGTH, "hurst": 0.8, "roughness": 5e-6, "spacing": 6.25e-5}
MATERIAL = {"shear_modulus": 1e6, "branches": [[5e6, 1e-3]]}
QUANTITIES = ["steady", "trace", "healing", "relaxation", "rate_state", "persson"]
BELL = {"stress": 4e5, "velocity": 0.05, "width": 2.0, "creep_velocity": 1e-5}
MOTION = (
    {"slide": {"velocity": 0.1, "distance": 2e-4}},
    {"slide": {"velocity": 0.2, "distance": 2e-4}},
    {"hold": {"duration": 1e-2}},
    {"slide": {"velocity": -0.2, "distance": 2e-4}},
)


def bell(v):
    """Return the shear stress of BELL at a speed, Pa."""
    return 4e5 * np.exp(-((np.log10(np.maximum(np.abs(v), 1e-5) / 0.05) / 2.0) ** 2))


def run(*programme, **changed):
    scene = {"surface": SURFACE, "material": MATERIAL, "normal_pressure": PRESSURE}
    scene |= {"realizations": 3, "quantities": QUANTITIES}
    return run_on_half_space(programme or MOTION, **(scene | changed))


@pytest.fixture(scope="module")
def bare():
    """Return a scene without shear."""
    return run()


@pytest.fixture(scope="module")
def sheared():
    """Return the same scene with the shear of BELL."""
    return run(shear=BELL)


def test_friction_is_the_sum_of_the_loss_and_the_shear_of_the_real_contact(bare, sheared):
    for name in ("mu_1", "trace_mu", "mu"):
        total = sheared[f"{name}_viscoelastic"] + sheared[f"{name}_shear"]
        np.testing.assert_allclose(sheared[name], total, rtol=1e-12)
        np.testing.assert_array_equal(sheared[f"{name}_viscoelastic"], bare[name])
    expected = bell(0.1) * bare.contact_fraction / PRESSURE
    np.testing.assert_allclose(sheared.mu_1_shear, expected, rtol=1e-9)
    expected = bell(0.1) * bare.area_persson / PRESSURE
    np.testing.assert_allclose(sheared.mu_persson_shear, expected, rtol=1e-9)
    np.testing.assert_allclose(
        sheared.mu_persson_total, bare.mu_persson + sheared.mu_persson_shear, rtol=1e-12
    )


def test_the_direct_effect_is_the_change_of_the_stress_on_the_same_contact(sheared):
    """A contact without a dashpot does not change at once."""
    direct = (bell(0.2) - bell(0.1)) * sheared.contact_fraction / PRESSURE
    start = sheared.mu_shear.values[0] - sheared.mu_1_shear
    np.testing.assert_allclose(start, direct, rtol=1e-9)


def test_shear_opposes_the_motion_and_at_rest_keeps_the_direction_of_the_last_one(sheared):
    area, v = sheared.trace_contact_fraction.values, sheared.trace_velocity.values
    segment = sheared.trace_segment.values
    sign = np.where(segment == 3, -1.0, 1.0)
    np.testing.assert_allclose(sheared.trace_mu_shear, sign * bell(v) * area / PRESSURE, rtol=1e-9)
    held = sheared.trace_mu_shear.values[(segment == 2) & (v == 0.0)]
    assert held.size > 3
    force = sheared.trace_friction_force / sheared.trace_normal_force
    np.testing.assert_allclose(force, sheared.trace_mu, rtol=1e-6)


def test_the_mean_over_cycles_contains_the_shear_of_every_step():
    """Friction is that of a trace of every step; loops of equal cycles have its mean."""
    shake = {"oscillate": {"amplitude": 2e-5, "frequency": 300.0, "cycles": 2, "velocity": 0.01}}
    changes = {"quantities": ["steady", "trace", "cycle_mean"], "realizations": 2}
    changes["numerics"] = {"steps_per_spacing": 2, "trace": 1}
    without, shaken = (run(shake, **changes, **shear) for shear in ({}, {"shear": BELL}))
    loss = without.mu_cycle_mean
    np.testing.assert_allclose(shaken.mu_cycle_mean_viscoelastic, loss, rtol=1e-12)
    assert float(shaken.mu_cycle_mean_shear_error) > 0.0
    averaged = shaken.trace_time.values > 1.0 / 300.0 + 1e-9
    dt = np.diff(shaken.trace_time.values, prepend=0.0)[averaged]
    expected = np.average(shaken.trace_mu_shear.values[averaged], weights=dt)
    assert float(shaken.mu_cycle_mean_shear) == pytest.approx(expected, rel=0.02)
    share = shaken.mu_cycle_mean / shaken.mu_1
    assert float(shaken.mu_cycle_share) == pytest.approx(float(share), rel=1e-12)


def test_an_accuracy_counts_the_total_friction(tmp_path):
    small = ("surface.length=1.6e-3", "numerics.accuracy=0.1", 'scene.quantities=["steady"]')
    plan = make_plan(small_study("scene.body=half-space", "scene.shear.stress=1e6", *small))
    run_plan(plan, tmp_path / "small.nc", RunOptions(Cluster(LOCAL)))
    with xr.open_dataset(tmp_path / "small.nc") as dataset:
        assert (dataset.accuracy_status == 1).all()
        reached = dataset.mu_1_error / dataset.mu_1 + dataset.mu_1_bias
        assert (reached <= 0.1).all()
        assert (dataset.mu_1_shear > 0.0).all()


def test_no_stress_gives_the_bits_of_no_table(bare):
    nothing = run(shear={"stress": 0.0})
    for name in bare.data_vars:
        np.testing.assert_array_equal(nothing[name], bare[name], err_msg=str(name))


@pytest.fixture(scope="module")
def full():
    """Return a scene in full contact."""
    return run(surface=SURFACE | {"roughness": 1e-8}, shear={"stress": 7e4}, realizations=2)


def test_a_result_states_slope_and_shortest_wave_and_an_area_without_a_cutoff(full):
    words = body_in_words(full)
    assert f"rms slope {float(full.rms_slope):.3g}, with waves down to {SHORTEST:.3g} m" in words
    assert "1 of the nominal area" in words
    assert "no surface.cutoff" in words
    cut = {"cutoff": 2 * SHORTEST, "roughness": 1e-8}
    known = run(surface=SURFACE | cut, shear={"stress": 7e4}, quantities=["steady"])
    assert f"with waves down to {2 * SHORTEST:.3g} m." in body_in_words(known)


def test_full_contact_shears_with_the_stress_over_the_pressure(full):
    np.testing.assert_allclose(full.mu_1_shear, 7e4 / PRESSURE, rtol=1e-12)
    assert float(full.mu_1_shear_error) == 0.0


def test_a_sphere_shears_with_the_area_of_hertz():
    n, radius, length = 96, 1e-2, 1e-3
    x = (np.arange(n) + 0.5) / n * length - 0.5 * length
    heights = (x[:, None] ** 2 + x**2) / (2.0 * radius)  # it touches with its lowest point
    force = (
        4.0 / 3.0 * 4e6 * (1.5e-4) ** 3 / radius
    )  # E* = 4 G; the radius of the contact is 0.15 mm
    slow = {"slide": {"velocity": 1e-6, "distance": 1e-5}}
    sphere = call.run(
        profile=heights,
        length=length,
        material={"shear_modulus": 1e6, "branches": [[1e5, 1e-3]]},
        normal_force=force,
        body="half-space",
        programme=[slow],
        quantities=["steady"],
        shear={"stress": 1e5},
    )
    assert float(sphere.mu_1_shear) == pytest.approx(1e5 * np.pi * (1.5e-4) ** 2 / force, rel=0.03)


def test_the_error_of_a_sum_contains_the_covariance_of_its_parts(sheared):
    """If the loss of each block falls by the shear it gains, all blocks have one total."""
    task = make_plan(small_study("scene.body=half-space", "scene.shear.stress=1e6")).variants[0]
    task = task.tasks[0]
    scalars = np.ones((1, 5, len(SCALARS)))
    scalars[..., SCALARS.index("contact_fraction")] = np.linspace(0.1, 0.2, 5)
    values = {"contact_2": np.ones((1, 5)), "contact_step": np.ones((1, 5, 2))}
    (_, _, parts) = add_shear([task], scalars, values, np.empty((1, 0)))
    scalars[..., SCALARS.index("mu_1")] = 3.0 - parts["mu_1_shear"]
    total, _, _ = add_shear([task], scalars, values, np.empty((1, 0)))
    np.testing.assert_allclose(total[..., SCALARS.index("mu_1")], 3.0, rtol=1e-12)
    spread = np.hypot(sheared.mu_1_shear_error, sheared.mu_1_viscoelastic_error)
    assert 0.0 < float(sheared.mu_1_error) != pytest.approx(float(spread), rel=1e-3)


@pytest.mark.parametrize("shape", ["bell", "table"])
def test_a_hotter_contact_shears_as_a_slower_one(shape):
    curve = (
        Bell(2.0, 3.0, 1.5) if shape == "bell" else ShearTable((1.0, 10.0, 1e3), (1.0, 4.0, 2.0))
    )
    law, v = ShearLaw(curve, 0.0, 5000.0, 300.0), np.array([-5.0, 2.0, 20.0])
    shift = np.exp(5000.0 * (1.0 / 320.0 - 1.0 / 300.0))
    assert shift < 1.0
    np.testing.assert_allclose(shear_stress(law, v, 320.0), shear_stress(law, v * shift))
    np.testing.assert_allclose(shear_stress(law, v[::-1]), shear_stress(law, -v)[::-1])


def test_a_table_keeps_its_first_stress_below_it_and_refuses_speeds_above_it():
    law = ShearLaw(ShearTable((1.0, 10.0), (3.0, 5.0)))
    np.testing.assert_allclose(shear_stress(law, np.array([0.0, 0.1, 10.0**0.5])), [3.0, 3.0, 4.0])
    with pytest.raises(ValueError, match="last row"):
        check_fastest(law, -10.1)


def test_another_stress_takes_the_stored_records(tmp_path):
    """At any pressure and roughness: the grid has points of equal F/h, which are one problem."""
    grid = ("grid.roughness=[1e-6, 2e-6]", "grid.normal_force=[100.0, 200.0]", "grid.hurst=0.7")
    small = ("surface.length=1.6e-3", "study.realizations=2", "numerics.steps_per_spacing=1")
    common = (
        *grid,
        *small,
        "scene.body=half-space",
        "grid.velocity=0.1",
        "compare.coarse.shear=false",
    )
    results = []
    for stress in (1e4, 3e4):
        plan = make_plan(small_study(*common, f"scene.shear.stress={stress}"))
        summary = run_plan(plan, tmp_path / "small.nc", RunOptions(Cluster(LOCAL)))
        assert (summary.batches == 0) == bool(results)
        assert len(plan.variants[0].rows) == 3  # of four points, two of equal F/h
        with xr.open_dataset(tmp_path / "small.nc") as dataset:
            results.append(dataset.load())
    once, thrice = results
    np.testing.assert_allclose(thrice.mu_1_shear, 3.0 * once.mu_1_shear, rtol=1e-9)
    np.testing.assert_array_equal(thrice.mu_1_viscoelastic, once.mu_1_viscoelastic)
    area = once.normal_force / 1.6e-3**2
    expected = 1e4 * once.contact_fraction / area
    np.testing.assert_allclose(*xr.broadcast(once.mu_1_shear, expected), rtol=1e-9)


PULLS = (
    {"pull": {"velocity": 0.1, "distance": 3e-4}},
    {"pull": {"velocity": 0.0, "duration": 1e-2}},
    {"pull": {"velocity": -0.1, "distance": 6e-4}},
)


def pulled(shear):
    """Return a slider on a spring that is pulled, held, and pulled back."""
    asked = {"quantities": ["steady", "trace"], "realizations": 1, "start": "relaxed"}
    return run(*PULLS, shear=shear, drive={"stiffness": 2000.0}, **asked)


def test_a_slider_at_rest_sticks_up_to_the_static_shear_and_shears_as_the_drive_demands():
    """A constant stress is dry friction: what the spring demands, at most that of the contact."""
    actual = pulled({"stress": 1e5})
    v, force = actual.trace_velocity.values, actual.trace_drive_force.values
    np.testing.assert_allclose(force, actual.trace_friction_force, atol=1e-4 * np.abs(force).max())
    most = 1e5 * actual.trace_contact_fraction.values / PRESSURE
    shear, stuck = actual.trace_mu_shear.values, v == 0.0
    assert np.all(np.abs(shear[stuck]) <= most[stuck])
    moves = np.abs(v) > 0.09  # of the 0.1 m/s of the drive
    np.testing.assert_allclose(shear[moves], np.sign(v[moves]) * most[moves], rtol=1e-3)
    held = (actual.trace_segment.values == 1) & stuck
    np.testing.assert_allclose(force[held], force[held][0], rtol=1e-6)
    assert most[held][-1] > 1.5 * most[held][0]  # the contact ages
    early = np.arange(1, np.flatnonzero(~stuck)[0])
    stretch = 0.1 * actual.trace_time.values[early]
    np.testing.assert_allclose(force[early], 2000.0 * stretch, rtol=0.05)


def test_a_slider_that_moves_shears_at_its_own_speed_against_it():
    actual = pulled(BELL)
    v, shear = actual.trace_velocity.values, actual.trace_mu_shear.values
    moves = np.abs(v) > 0.02
    assert (v[moves] > 0.0).any()
    assert (v[moves] < 0.0).any()
    expected = np.sign(v) * bell(v) * actual.trace_contact_fraction.values / PRESSURE
    np.testing.assert_allclose(shear[moves], expected[moves], rtol=0.1)
