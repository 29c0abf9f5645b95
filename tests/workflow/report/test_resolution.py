"""Points whose contacts are not resolved: found for figures, left out of claims, counted."""

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.workflow.reduce import RESOLVED, UNRESOLVED
from elastomer_friction.workflow.report.unresolved import Resolved, not_resolved, without_unresolved

COARSE = 1


@pytest.fixture
def result():
    """Return a result of two Hurst exponents and four velocities."""
    status = np.array([[UNRESOLVED, COARSE, RESOLVED, -1], [RESOLVED] * 4], np.int8)
    over = ("hurst", "velocity")
    return xr.Dataset(
        {
            "resolution_status": (over, status),
            "realizations": (over, np.full((2, 4), 8, np.int32)),
            "mu_1": (over, np.ones((2, 4))),
            "fit_status": (over, np.zeros((2, 4), np.int8)),
            "alpha": ("hurst", np.ones(2)),
        }
    )


def test_points_that_are_coarse_or_unresolved_are_found(result):
    assert not_resolved(result).tolist() == [[True, True, False, False], [False] * 4]


def test_nothing_is_found_where_a_result_does_not_say(result):
    assert not not_resolved(result.drop_vars("resolution_status")).any()
    assert not_resolved(xr.Dataset()).shape == ()


def test_unresolved_points_are_as_if_they_had_failed(result):
    kept, count = without_unresolved(result)
    assert count == 1
    assert np.isnan(kept.mu_1.values[0, 0])
    assert (kept.fit_status.values[0, 0], kept.realizations.values[0, 0]) == (-1, -1)
    assert np.isfinite(kept.mu_1.values).sum() == 7
    assert {name: v.dtype for name, v in kept.items()} == {n: v.dtype for n, v in result.items()}
    assert kept.alpha.values.tolist() == [1.0, 1.0]  # of all velocities


def test_a_result_that_is_resolved_or_does_not_say_is_left_as_it_is(result):
    for same in (result.drop_vars("resolution_status"), result.isel(hurst=[1])):
        assert without_unresolved(same) == (same, 0)


def test_claims_see_resolved_points_and_know_how_many_were_left_out(result):
    results = Resolved({"fig7": result, "fig8": result.isel(hurst=[1])})
    assert (len(results), list(results)) == (2, ["fig7", "fig8"])
    assert results.left_out == {}
    assert np.isnan(results["fig7"].mu_1.values).sum() == 1
    assert results.left_out == {"fig7": 1}
