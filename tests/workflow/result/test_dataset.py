"""The dataset of a result: dims, units, scaling to SI, provenance."""

import json

import numpy as np
import pytest

from tests.support.curves import assembled
from workflow.reduce.fits import FITTED, NOT_FINITE
from workflow.result.variables import VARIABLES
from workflow.study.grid import AXES

PLAN, ESTIMATES, DATASET = assembled()
_, _, WITH_MODELS = assembled(
    'scene.quantities=["steady", "jump", "relaxation", "models"]', "grid.hurst=0.3"
)
ALWAYS = {"rms_slope", "speed_ratio", "realizations", "steps_per_spacing"}
ACCURACY = {"accuracy_reached", "accuracy_status", "bias_bound"}  # run/test_rounds.py
HURST_FITS = {"alpha", "alpha_free", "alpha_prefactor", "alpha_scatter", "alpha_points"}


def test_all_six_dims_are_there_in_order():
    for name, variable in DATASET.data_vars.items():
        if not str(name).startswith("alpha"):
            assert variable.dims[:6] == AXES
            assert variable.dims[6:] in ((), ("sample",))


def test_coordinates_are_the_axes_of_the_study():
    for axis in AXES:
        assert DATASET[axis].values.tolist() == list(PLAN.study.grid[axis])
    assert DATASET["sample"].values.tolist() == list(range(16))


def test_every_name_is_declared_and_every_declared_name_is_there():
    names = {str(name).removesuffix("_error") for name in WITH_MODELS.data_vars}
    assert names == set(VARIABLES) - ACCURACY


@pytest.mark.parametrize(
    ("asked", "expected"),
    [
        ("steady", "mu_1 mu_2 indentation contact_fraction"),
        ("jump", "jump"),
        ("relaxation", "mu deviation relaxation_rate relaxation_rate_free amplitude"),
    ],
)
def test_only_what_was_asked_for_is_there(asked, expected):
    _, _, dataset = assembled(f'scene.quantities=["{asked}"]')
    names = set(expected.split())
    names |= {f"{name}_error" for name in names} | ALWAYS
    if asked == "relaxation":
        names |= {"time", "fit_status", "fit_window", "fit_quality"} | HURST_FITS
        names |= {"alpha_error", "alpha_free_error", "alpha_prefactor_error"}
    assert {str(name) for name in dataset.data_vars} == names
    assert ("sample" in dataset.dims) == (asked == "relaxation")


def test_every_variable_has_units_and_a_long_name():
    for variable in WITH_MODELS.variables.values():
        assert variable.attrs["units"]
        assert variable.attrs["long_name"]


def test_every_estimate_points_to_its_error():
    for name, variable in WITH_MODELS.data_vars.items():
        error = f"{name}_error"
        expected = error if error in WITH_MODELS else None
        assert variable.attrs.get("ancillary_variables") == expected


def test_every_error_is_described_like_its_estimate():
    errors = [name for name in WITH_MODELS.data_vars if str(name).endswith("_error")]
    assert len(errors) > 10
    for name in errors:
        error, estimate = WITH_MODELS[name], WITH_MODELS[name.removesuffix("_error")]
        assert error.attrs["units"] == estimate.attrs["units"]
        assert error.attrs["long_name"] == f"standard error of {estimate.attrs['long_name']}"


def test_fit_status_explains_its_codes():
    attributes = DATASET["fit_status"].attrs
    meanings = attributes["flag_meanings"].split()
    assert meanings[:3] == ["fitted", "no_relaxation", "not_exponential"]
    assert list(attributes["flag_values"]) == list(range(NOT_FINITE + 1))
    assert len(meanings) == NOT_FINITE + 1
    for meaning in meanings[1:]:
        assert f"{meaning}: " in attributes["comment"]


def expected_at(name, point):
    """Return the dimensionless estimate at a grid point, and h and dx there."""
    place = tuple(PLAN.study.grid[axis].index(point[axis]) for axis in AXES)
    return ESTIMATES[name][PLAN.point_task[place]], point["roughness"], point["spacing"]


POINTS = [
    dict(zip(AXES, values, strict=True))
    for values in [(0.3, 0.04, 1e-4, 1e-5, 0.02, 0.2), (0.7, 1.2, 2e-4, 3e-5, 0.5, 0.2)]
]
SLOPES = ["mu_1", "mu_2", "jump", "amplitude", "rms_slope", "mu", "mu_1_error", "mu_error"]


@pytest.mark.parametrize("point", POINTS)
@pytest.mark.parametrize("name", SLOPES)
def test_friction_and_slope_scale_with_h_over_dx(name, point):
    value, h, dx = expected_at(name, point)
    np.testing.assert_allclose(DATASET[name].sel(point).values, value * h / dx, rtol=1e-12)


@pytest.mark.parametrize("point", POINTS)
@pytest.mark.parametrize("name", ["indentation", "indentation_error"])
def test_indentation_scales_with_h(name, point):
    value, h, _ = expected_at(name, point)
    assert DATASET[name].sel(point).item() == pytest.approx(value * h, rel=1e-12)


@pytest.mark.parametrize("point", POINTS)
@pytest.mark.parametrize("name", ["relaxation_rate", "contact_fraction", "time", "fit_status"])
def test_rates_shares_and_times_are_dimensionless(name, point):
    value, _, _ = expected_at(name, point)
    assert np.array_equal(DATASET[name].sel(point).values, value, equal_nan=True)


def test_speed_ratio_is_that_of_the_point():
    velocity, spacing = DATASET.velocity, DATASET.spacing
    expected = np.pi * velocity * 1e-3 / spacing
    np.testing.assert_allclose(DATASET.speed_ratio, expected.broadcast_like(DATASET.speed_ratio))


def test_power_law_uses_fitted_points_beyond_one_only():
    x = DATASET.speed_ratio.values[0]
    fitted = DATASET.fit_status.values[0] == FITTED
    distinct = np.unique(PLAN.point_task[0][(x > 1.0) & fitted])
    assert 3 <= distinct.size < np.unique(PLAN.point_task[0]).size
    assert DATASET.alpha_points.values[0] == distinct.size
    assert np.isfinite(DATASET.alpha).all()


def test_provenance_is_in_the_attributes():
    attributes = DATASET.attrs
    assert json.loads(attributes["study"]) == json.loads(PLAN.study.text)
    assert (attributes["seed"], attributes["scheme"]) == (1, "exponential")
    assert attributes["Conventions"] == "CF-1.8"
    assert f"numpy {np.__version__}" in attributes["versions"]
