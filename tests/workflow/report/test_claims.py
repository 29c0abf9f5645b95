"""Verdicts on points with resolved contacts, and the table of all points."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.reduce.resolution import COARSE, RESOLVED, UNRESOLVED
from elastomer_friction.workflow.report.claims import (
    evaluate,
    judge,
    judge_factor,
    known_claims,
    mean_error,
)
from elastomer_friction.workflow.report.csv_tables import write_table
from elastomer_friction.workflow.report.unresolved import not_resolved, without_unresolved
from elastomer_friction.workflow.study.axes import COMMON_AXES
from elastomer_friction.workflow.study.read import read_study
from tests.support.synthetic import result, with_alpha, with_rates

CLAIMS = known_claims()


def test_claims_without_their_study_are_left_out():
    assert evaluate(CLAIMS, {}) == []
    assert evaluate(CLAIMS, {"fig7": result()}) == []  # no estimates at all
    dataset = result()
    both = with_alpha(with_rates(dataset, dataset.speed_ratio), 1.0 - dataset.hurst)
    actual = evaluate(CLAIMS, {"fig7": both})
    assert 0 < len(actual) < len(CLAIMS)
    assert all(text for claim in actual for text in claim)


def test_claims_leave_unresolved_points_out_and_say_how_many():
    dataset = result()
    dataset = with_rates(dataset, dataset.speed_ratio ** (1.0 - dataset.hurst))
    status = np.full(dataset.rms_slope.shape, RESOLVED, np.int8)
    status.flat[-3:] = UNRESOLVED  # the fastest of the smooth line
    wrong = dataset.relaxation_rate.where(status != UNRESOLVED, 1e3)
    spoilt = dataset.assign(
        relaxation_rate=wrong, resolution_status=(dataset.rms_slope.dims, status)
    )
    sound = {claim.text: claim.found for claim in evaluate(CLAIMS, {"fig7": dataset})}
    actual = {claim.text: claim.found for claim in evaluate(CLAIMS, {"fig7": spoilt})}
    assert len(actual) == len(sound) > 0
    message = "; 3 points with unresolved contacts left out"
    assert all(text.endswith(message) for text in actual.values())
    assert not any("left out" in text for text in sound.values())
    assert not any("1e+03" in text or "1000" in text for text in actual.values())


def test_deviations_within_two_errors_are_chance():
    assert judge(0.05, 0.03) == "holds"
    assert judge(0.05, 0.02) == "holds within 5 %"
    assert judge(0.05, 0.2) == "cannot be judged: the error is too large"
    assert judge(np.nan) == "cannot be judged: the error is too large"
    assert judge_factor(np.array([0.5, 2.0])) == "holds within a factor 2"


def test_errors_of_points_on_the_same_lines_do_not_average_out():
    error = result().speed_ratio * 0.0 + 0.1  # 2 H, one spacing, 14 points each
    np.testing.assert_allclose(mean_error(error), 0.1 / np.sqrt(2.0))
    np.testing.assert_allclose(mean_error(error.isel(hurst=[0])), 0.1)


@pytest.fixture
def partly():
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


def test_the_mask_of_unresolved_points_follows_the_status(partly):
    assert not_resolved(partly).tolist() == [[True, True, False, False], [False] * 4]
    assert not not_resolved(partly.drop_vars("resolution_status")).any()
    assert not_resolved(xr.Dataset()).shape == ()


def test_unresolved_points_are_as_if_they_had_failed(partly):
    kept, count = without_unresolved(partly)
    assert count == 1
    assert np.isnan(kept.mu_1.values[0, 0])
    assert (kept.fit_status.values[0, 0], kept.realizations.values[0, 0]) == (-1, -1)
    assert np.isfinite(kept.mu_1.values).sum() == 7
    assert {name: v.dtype for name, v in kept.items()} == {n: v.dtype for n, v in partly.items()}
    assert kept.alpha.values.tolist() == [1.0, 1.0]  # of all velocities


def test_results_without_unresolved_points_or_status_are_unchanged(partly):
    for same in (partly.drop_vars("resolution_status"), partly.isel(hurst=[1])):
        assert without_unresolved(same) == (same, 0)


def test_every_point_is_a_row_of_the_estimates_of_the_result(shown, finished):
    dataset, study = finished.load(), finished.plan.study
    paths = write_table(study, shown / "small.nc")
    assert [path.name for path in paths] == [
        "small.csv",
        "small-exponents.csv",
        "small-columns.csv",
    ]
    both = pd.read_csv(paths[0])
    assert set(both.variant) == {"study", "coarse"}
    table = both[both.variant == "study"]
    assert len(table) == len(both) / 2 == finished.plan.points
    names = {name for name in dataset.variables if dataset[name].dims == COMMON_AXES}
    assert set(table.columns) >= names | set(COMMON_AXES)

    for _, row in table.iterrows():
        point = dataset.sel({axis: row[axis] for axis in COMMON_AXES}, method="nearest")
        for name in ("mu_1", "jump", "indentation", "relaxation_rate_error"):
            assert row[name] == pytest.approx(point[name].item(), rel=1e-9, nan_ok=True)
    coarse, row = finished.load("coarse").stack(point=COMMON_AXES), both[both.variant == "coarse"]
    assert row.mu_1.to_numpy() == pytest.approx(coarse.mu_1.values, rel=1e-9)


def test_exponents_and_the_units_of_columns_are_tables_of_their_own(shown, finished):
    dataset = finished.load()
    table, exponents, columns = map(
        pd.read_csv, write_table(finished.plan.study, shown / "small.nc")
    )
    assert list(exponents.hurst) == [*dataset.hurst.values] * 2
    assert exponents.alpha[:2].to_numpy() == pytest.approx(dataset.alpha.values, nan_ok=True)
    assert set(columns.column) == set(table.columns) | set(exponents.columns)
    message = columns.set_index("column")
    assert message.unit["indentation"] == "m"
    assert message.meaning["jump"] == "instantaneous jump of the coefficient of friction"


def test_a_measured_study_without_a_table_is_refused(powers, tmp_path):
    measure = powers / "measure.py"
    measure.write_text(measure.read_text().partition("def table")[0])
    with pytest.raises(UserError, match=r"^study 'powers': has no table$"):
        write_table(read_study("powers"), tmp_path / "powers.nc")
