"""A measured study is run: all its groups with their origin, or nothing at all."""

import json

import pytest
import xarray as xr

from workflow.run.measured import run_measured
from workflow.study.read import read_study


def test_all_groups_are_written_with_their_origin(powers, tmp_path):
    said = run_measured(read_study("powers"), tmp_path / "powers.nc").splitlines()
    assert said[0] == "largest 4"
    assert said[-1].endswith("of core time used, 2 s predicted")
    groups = xr.open_groups(tmp_path / "powers.nc")
    assert groups["/"].found.values.tolist() == [1.0, 2.0, 4.0]
    assert groups["/seed"].seed == 5
    for group in ("/", "/seed"):
        assert groups[group].attrs["seed"] == 5
        assert json.loads(groups[group].attrs["study"])["measure"]["powers"] == 3
        groups[group].close()


def test_an_interrupted_measurement_leaves_the_earlier_result(powers, tmp_path):
    result = tmp_path / "powers.nc"
    run_measured(read_study("powers"), result)
    before = result.read_bytes()
    (powers / "helper.py").write_text("def power(base, n):\n    raise KeyboardInterrupt\n")
    with pytest.raises(KeyboardInterrupt):
        run_measured(read_study("powers"), result)
    assert result.read_bytes() == before
