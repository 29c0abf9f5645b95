"""The coefficient table: one row per grid point, the numbers of the netCDF file."""

import pandas as pd
import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.report.csv_tables import write_table
from elastomer_friction.workflow.study.axes import AXES
from elastomer_friction.workflow.study.read import read_study


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
    names = {name for name in dataset.variables if dataset[name].dims == AXES}
    assert set(table.columns) >= names | set(AXES)

    for _, row in table.iterrows():
        point = dataset.sel({axis: row[axis] for axis in AXES}, method="nearest")
        for name in ("mu_1", "jump", "indentation", "relaxation_rate_error"):
            assert row[name] == pytest.approx(point[name].item(), rel=1e-9, nan_ok=True)
    coarse, row = finished.load("coarse").stack(point=AXES), both[both.variant == "coarse"]
    assert row.mu_1.to_numpy() == pytest.approx(coarse.mu_1.values, rel=1e-9)


def test_exponents_and_the_units_of_columns_are_tables_of_their_own(shown, finished):
    dataset = finished.load()
    table, exponents, columns = map(
        pd.read_csv, write_table(finished.plan.study, shown / "small.nc")
    )
    assert list(exponents.hurst) == [*dataset.hurst.values] * 2
    assert exponents.alpha[:2].to_numpy() == pytest.approx(dataset.alpha.values, nan_ok=True)
    assert set(columns.column) == set(table.columns) | set(exponents.columns)
    said = columns.set_index("column")
    assert said.unit["indentation"] == "m"
    assert said.meaning["jump"] == "instantaneous jump of the coefficient of friction"


def test_a_measured_study_without_a_table_says_so(powers, tmp_path):
    measure = powers / "measure.py"
    measure.write_text(measure.read_text().partition("def table")[0])
    with pytest.raises(UserError, match=r"^study 'powers': has no table$"):
        write_table(read_study("powers"), tmp_path / "powers.nc")
