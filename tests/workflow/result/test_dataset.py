"""The dataset of a result: dims, units, scaling to SI, provenance."""

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.workflow.plan.error_laws import LAWS
from elastomer_friction.workflow.reduce.fits import FITTED
from elastomer_friction.workflow.result.dataset import build_dataset
from elastomer_friction.workflow.result.provenance import provenance
from elastomer_friction.workflow.result.variables import VARIABLES, Scaling
from elastomer_friction.workflow.study.axes import COMMON_AXES
from tests.support.curves import assembled

ALWAYS = {"rms_slope", "speed_ratio", "realizations", "steps_per_spacing", "degrees_of_freedom"}
ALWAYS |= {"bias_bound", "resolution_status", "samples_per_contact", "samples_per_contact_error"}
HURST_FITS = {"alpha", "alpha_free", "alpha_prefactor", "alpha_scatter", "alpha_points"}
HURST_FITS |= {"alpha_bias", "alpha_free_bias", "alpha_unresolved"}


def test_all_six_dims_are_there_in_order_with_the_axes_of_the_study(made, dataset):
    for name, variable in dataset.data_vars.items():
        if not str(name).startswith("alpha"):
            assert variable.dims[:6] == COMMON_AXES
            assert variable.dims[6:] in ((), ("sample",))
    for axis in COMMON_AXES:
        assert dataset[axis].values.tolist() == list(made[0].study.grid[axis])
    assert dataset["sample"].values.tolist() == list(range(16))


@pytest.mark.parametrize(
    ("quantity", "expected"),
    [
        ("steady", "mu_1 mu_2 indentation contact_fraction"),
        ("jump", "jump"),
        ("relaxation", "mu deviation relaxation_rate relaxation_rate_free amplitude"),
    ],
)
def test_only_requested_variables_are_present(quantity, expected):
    _, _, dataset = assembled(f'scene.quantities=["{quantity}"]')
    names = set(expected.split())
    biases = {f"{name}_bias" for name in names & LAWS.keys()}
    names |= {f"{name}_error" for name in names} | biases | ALWAYS
    if quantity == "relaxation":
        names |= {"time", "time_s", "fit_status", "fit_window", "fit_quality"} | HURST_FITS
        names |= {"alpha_error", "alpha_free_error", "alpha_prefactor_error"}
    known = {"tau", "shear_modulus", "length", "q_max"}
    assert {str(name) for name in dataset.variables.keys() - dataset.dims} == names | known
    assert ("sample" in dataset.dims) == (quantity == "relaxation")


POINTS = [
    dict(zip(COMMON_AXES, values, strict=True))
    for values in [(0.3, 0.04, 1e-4, 1e-5, 0.02, 0.2), (0.7, 1.2, 2e-4, 3e-5, 0.5, 0.2)]
]
SCALES = {
    "mu_1 mu_2 jump amplitude rms_slope mu mu_1_error mu_error": lambda h, dx: h / dx,
    "indentation indentation_error": lambda h, dx: h,
    "relaxation_rate contact_fraction time fit_status": lambda h, dx: 1.0,
}


@pytest.mark.parametrize("point", POINTS)
@pytest.mark.parametrize("names", SCALES)
def test_estimates_get_their_scale(made, dataset, names, point):
    plan, estimates, _ = made
    task = plan.variants[0].point_task[
        tuple(plan.study.grid[axis].index(point[axis]) for axis in COMMON_AXES)
    ]
    scale = SCALES[names](point["roughness"], point["spacing"])
    for name in names.split():
        actual, expected = dataset[name].sel(point).values, estimates[name][task] * scale
        np.testing.assert_allclose(actual, expected, rtol=1e-12, err_msg=name)


def test_a_variable_may_scale_with_any_axes(made, monkeypatch):
    plan, estimates, _ = made
    power = Scaling("1", {"normal_force": 1, "velocity": 2, "spacing": -1})
    monkeypatch.setitem(VARIABLES, "mu_1", VARIABLES["mu_1"]._replace(scaling=power))
    dataset = build_dataset(plan, plan.variants[0], estimates, {})
    for name in ("mu_1", "mu_1_error"):
        plain = xr.DataArray(estimates[name][plan.variants[0].point_task], dims=COMMON_AXES)
        expected = plain * (dataset.normal_force * dataset.velocity**2 / dataset.spacing)
        np.testing.assert_allclose(dataset[name], expected)


def test_power_law_uses_fitted_points_beyond_one_only(made, dataset):
    x = dataset.speed_ratio.values[0]
    fitted = dataset.fit_status.values[0] == FITTED
    distinct = np.unique(made[0].variants[0].point_task[0][(x > 1.0) & fitted])
    assert 3 <= distinct.size < np.unique(made[0].variants[0].point_task[0]).size
    assert dataset.alpha_points.values[0] == distinct.size
    assert np.isfinite(dataset.alpha).all()


def test_provenance_is_in_the_attributes(made, dataset):
    study = made[0].study
    assert provenance(study, study.variants[""]).items() <= dataset.attrs.items()
    assert dataset.attrs["Conventions"] == "CF-1.8"


def test_an_estimate_that_differs_from_its_declaration_is_refused(made):
    plan, estimates, _ = made
    variant = plan.variants[0]
    with pytest.raises(TypeError, match="realizations is of type float64, but declared as int32"):
        build_dataset(plan, variant, estimates | {"realizations": estimates["mu_1"]}, {})
    with pytest.raises(KeyError, match="nothing_we_know"):
        build_dataset(plan, variant, estimates | {"nothing_we_know": estimates["mu_1"]}, {})
