"""The coefficient table: one row per grid point, the numbers of the netCDF file."""

import pandas as pd
import pytest

from workflow.errors import UserError
from workflow.report.table import write_grid_table, write_measured_table
from workflow.study.grid import AXES
from workflow.study.read import read_study


def test_every_point_is_a_row_of_the_estimates_of_the_result(shown, finished):
    dataset, study = finished.load(), finished.plan.study
    table = pd.read_csv(write_grid_table(study, shown / "small.nc"))
    assert len(table) == finished.plan.points
    names = {name for name in dataset.data_vars if dataset[name].dims == AXES}
    assert set(table.columns) == names | set(AXES)

    for _, row in table.iterrows():
        point = dataset.sel({axis: row[axis] for axis in AXES}, method="nearest")
        for name in ("mu_1", "jump", "indentation", "relaxation_rate_error"):
            assert row[name] == pytest.approx(point[name].item(), rel=1e-9, nan_ok=True)


def test_a_measured_study_without_a_table_says_so(powers, tmp_path):
    measure = powers / "measure.py"
    measure.write_text(measure.read_text().partition("def table")[0])
    with pytest.raises(UserError, match=r"^study 'powers': has no table$"):
        write_measured_table(read_study("powers"), tmp_path / "powers.nc")
