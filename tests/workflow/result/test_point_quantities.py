"""Quantities of a point: values in SI units, and errors with the covariances of estimates."""

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.workflow.plan import JACKKNIFE_GROUPS
from elastomer_friction.workflow.reduce.blocks import blocks_of, reduction_of
from elastomer_friction.workflow.reduce.complete import completed
from elastomer_friction.workflow.reduce.estimates import reduce_blocks
from elastomer_friction.workflow.reduce.point_quantities import (
    POINT_QUANTITIES,
    PointQuantity,
    quantities_of_points,
)
from elastomer_friction.workflow.result.dataset import build_dataset
from elastomer_friction.workflow.result.variables import VARIABLES, Variable
from elastomer_friction.workflow.simulate.tasks import SCALARS
from tests.support.small import TEXT, small_plan

LENGTH, SHEAR_STRENGTH = 0.01, 4e3
SETTINGS = ('scene.quantities=["steady"]', "grid.hurst=0.7", "grid.spacing=2.5e-3")
SETTINGS += ("grid.normal_force=[100.0, 300.0]", "grid.roughness=[1e-5, 3e-5]")
HALF_SPACE = "scene.body=half-space"
SHARED = ({"normal_force": 100.0, "roughness": 1e-5}, {"normal_force": 300.0, "roughness": 3e-5})


def means_of(variant, groups):
    """Return random block means of the tasks; contact and friction are anticorrelated."""
    rng = np.random.default_rng(groups)
    means = rng.uniform(0.2, 0.4, (len(variant.tasks), groups, len(SCALARS)))
    noise = 0.02 * rng.standard_normal(means.shape[:2])
    means[..., SCALARS.index("contact_fraction")] = 0.6 - means[..., 0] + noise
    return means


def dataset_of(plan, groups, failed=0, label=""):
    """Return the dataset of the block means; the first ``failed`` tasks have failed."""
    (variant,) = (variant for variant in plan.variants if variant.label == label)
    sound = np.arange(failed, len(variant.tasks))
    rows = np.ones((sound.size, groups, plan.widest_row(variant)))
    tasks = [variant.tasks[row] for row in sound]
    means = means_of(variant, groups)[sound]
    estimates = reduce_blocks(blocks_of(reduction_of(variant), tasks, means, rows))
    counts = np.full(len(variant.tasks), groups, np.int32)
    counts[:failed] = 0
    return build_dataset(plan, variant, completed(plan, variant, estimates, sound, counts), {})


def left_out(plan, groups, name, point_task):
    """Return the leave-one-out means of a scalar at all points, group by group."""
    values = means_of(plan.variants[0], groups)[..., SCALARS.index(name)]
    for group in range(groups):
        yield np.delete(values, group, axis=1).mean(axis=1)[point_task]


def jackknife(replicates):
    """Return the jackknife standard error of a list of replicates."""
    values = np.array(replicates)
    return np.sqrt((len(values) - 1) * values.var(axis=0))


@pytest.mark.parametrize(
    ("groups", "tolerance"), [(JACKKNIFE_GROUPS, 1e-12), (8, 0.01)], ids=["all groups", "few"]
)
def test_contact_pressure_is_the_force_over_the_real_area(groups, tolerance):
    plan = small_plan(*SETTINGS, HALF_SPACE)
    data = dataset_of(plan, groups)
    pressure = data.normal_force / (LENGTH**2 * data.contact_fraction)
    xr.testing.assert_allclose(
        data.mean_contact_pressure, pressure.transpose(*plan.study.axes), rtol=1e-14
    )
    force = data.normal_force.values[:, None, None, None, None]
    task = plan.variants[0].point_task
    replicates = [
        force / (LENGTH**2 * share) for share in left_out(plan, groups, "contact_fraction", task)
    ]
    error = data.mean_contact_pressure_error
    np.testing.assert_allclose(error, jackknife(replicates), rtol=tolerance)
    assert error.attrs["units"] == data.mean_contact_pressure.attrs["units"] == "Pa"


def test_points_of_one_task_differ_by_their_forces():
    plan = small_plan(*SETTINGS, HALF_SPACE)
    data = dataset_of(plan, 4)
    one, other = (data.sel(point) for point in SHARED)
    grid = plan.study.grid
    index = [
        tuple(grid[axis].index(point[axis]) if axis in point else 0 for axis in plan.study.axes)
        for point in SHARED
    ]
    assert len({int(plan.variants[0].point_task[place]) for place in index}) == 1
    np.testing.assert_array_equal(one.contact_fraction, other.contact_fraction)
    for name in ("mean_contact_pressure", "mean_contact_pressure_error"):
        np.testing.assert_allclose(other[name], 3.0 * one[name], rtol=1e-12)


def test_force_is_that_of_the_variant():
    text = TEXT.partition("[compare")[0] + '[compare.block]\nbody = "half-space"\n'
    text = text.replace("normal_force = [0.04, 0.4]", "normal_pressure = [1e3, 3e3]")
    text = text.replace("length = 0.01", "length = 0.01\nrolloff = 5e-3")  # F_N/L^2 is half
    settings = *SETTINGS[:2], "grid.spacing=1.25e-3", "scene.body=foundation"
    plan = small_plan(*settings, text=text)
    assert plan.study.force_share("block") == 2.0
    data = dataset_of(plan, 4, label="block")
    pressure = (data.mean_contact_pressure * data.contact_fraction).max(
        ["hurst", "spacing", "roughness", "velocity", "velocity_step"]
    )
    np.testing.assert_allclose(pressure, plan.study.pressures, rtol=1e-14)
    assert "mean_contact_pressure" not in dataset_of(plan, 4)


def test_failed_points_and_single_blocks_have_no_error():
    plan = small_plan(*SETTINGS, HALF_SPACE)
    data = dataset_of(plan, 4, failed=1)
    failed = plan.variants[0].point_task == 0
    assert np.array_equal(np.isnan(data.mean_contact_pressure), failed)
    assert np.array_equal(np.isnan(data.mean_contact_pressure_error), failed)
    single = dataset_of(plan, 1)
    assert np.isfinite(single.mean_contact_pressure).all()
    assert np.isnan(single.mean_contact_pressure_error).all()


def test_a_foundation_has_no_contact_pressure_and_no_replicates():
    data = dataset_of(small_plan(*SETTINGS), 4)
    assert "mean_contact_pressure" not in data
    assert not any("replicates" in str(name) for name in data.variables)


@pytest.mark.parametrize("body", ["foundation", "half-space"])
def test_error_includes_the_covariance_of_two_estimates(body, monkeypatch):
    def sheared(points):
        area = points.setting("surface", lambda surface: surface.pressed_area)
        shear = SHEAR_STRENGTH * area * points.estimates["contact_fraction"]
        return points.estimates["mu_1"] + shear / points.parameters["normal_force"]

    monkeypatch.setitem(
        POINT_QUANTITIES, "sheared", PointQuantity(sheared, ("mu_1", "contact_fraction"))
    )
    monkeypatch.setitem(VARIABLES, "sheared", Variable("friction with shear of the contact"))
    plan = small_plan(*SETTINGS, f"scene.body={body}")
    data, task = dataset_of(plan, JACKKNIFE_GROUPS), plan.variants[0].point_task
    scale = (data.roughness / data.spacing).transpose("spacing", "roughness").values
    scale = scale[None, None, :, :, None, None]
    force = data.normal_force.values[:, None, None, None, None]
    pairs = zip(
        left_out(plan, JACKKNIFE_GROUPS, "mu_1", task),
        left_out(plan, JACKKNIFE_GROUPS, "contact_fraction", task),
        strict=True,
    )
    replicates = [mu * scale + SHEAR_STRENGTH * LENGTH**2 * share / force for mu, share in pairs]
    np.testing.assert_allclose(data.sheared_error, jackknife(replicates), rtol=1e-11)
    apart = (
        data.mu_1_error**2
        + (SHEAR_STRENGTH * LENGTH**2 / data.normal_force * data.contact_fraction_error) ** 2
    )
    assert (data.sheared_error**2 < 0.9 * apart).all()  # the estimates are anticorrelated


def test_rows_need_a_quantity_that_supplies_their_estimates():
    assert quantities_of_points(["steady", "jump"], "half-space").keys() == {
        "mean_contact_pressure"
    }
    assert not quantities_of_points(["jump"], "half-space")
