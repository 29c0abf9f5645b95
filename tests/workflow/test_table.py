"""The coefficient table: one row per grid point, the numbers of the netCDF file."""

import pandas as pd
import pytest

from tests.workflow.small import small_study, write_study
from workflow.cli import main
from workflow.errors import UserError
from workflow.report.table import write_grid_table
from workflow.study.grid import AXES


@pytest.fixture(scope="module")
def table(finished, tmp_path_factory):
    """Return the table of the small study."""
    copy = tmp_path_factory.mktemp("table") / "small.nc"
    copy.write_bytes(finished.path.read_bytes())
    return pd.read_csv(write_grid_table(finished.plan.study, copy))


def test_one_row_per_point_and_one_column_per_estimate(table, finished):
    dataset = finished.load()
    assert len(table) == finished.plan.points
    names = {name for name in dataset.data_vars if dataset[name].dims == AXES}
    assert set(table.columns) == names | set(AXES)


def test_numbers_are_those_of_the_result(table, finished):
    dataset = finished.load()
    for _, row in table.iterrows():
        point = dataset.sel({axis: row[axis] for axis in AXES}, method="nearest")
        for name in ("mu_1", "jump", "indentation", "relaxation_rate_error"):
            assert row[name] == pytest.approx(point[name].item(), rel=1e-9, nan_ok=True)


def test_table_before_the_run_is_refused(tmp_path, capsys):
    with pytest.raises(UserError, match=r"small\.nc: not found; first run: python"):
        write_grid_table(small_study(), tmp_path / "small.nc")
    assert main(["table", write_study(tmp_path), "--out", str(tmp_path)]) == 2
    assert capsys.readouterr().err.startswith("error: ")
