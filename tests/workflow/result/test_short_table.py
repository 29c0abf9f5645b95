"""The table that a run prints: each estimate with its errors, at the points of small results."""

import numpy as np
import xarray as xr

from elastomer_friction.workflow.result import short_table

AXES = ("normal_force", "velocity")


def result(speeds: int) -> xr.Dataset:
    shape = (1, speeds)
    ones = np.ones(shape)
    data = {
        "mu_1": (AXES, 0.25 * ones),
        "mu_1_error": (AXES, 0.01 * ones),
        "mu_1_bias": (AXES, 0.002 * ones),
        "jump": (AXES, np.where(np.arange(speeds) > 0, 0.1, np.nan)[None]),
        "model_ratio": (AXES, 0.5 * ones),
        "resolution_status": (AXES, np.minimum(np.arange(speeds), 1)[None]),
    }
    coords = {
        "normal_force": [0.1],
        "normal_pressure": ("normal_force", [1e5]),
        "velocity": ("velocity", np.arange(1.0, speeds + 1.0), {"units": "m s-1"}),
    }
    return xr.Dataset(data, coords)


def test_every_estimate_has_its_errors_or_says_that_they_are_unknown():
    head, first, second = short_table(result(2))
    assert head.split() == ["velocity", "(m", "s-1)", "mu_1", "jump", "model_ratio"]
    estimate = "0.250 ± 0.010, bias < 0.2 %"
    assert first.split("  ")[0] == "1"
    assert estimate in first
    assert estimate in second
    assert "not determined" in first
    assert "0.1 (error unknown)" in second
    assert first.endswith("unresolved")
    assert second.endswith("0.5 (error unknown)")


def test_results_of_many_points_or_without_estimates_have_no_table():
    assert short_table(result(13)) == []
    assert short_table(result(2).drop_vars(["mu_1", "jump", "model_ratio"])) == []
