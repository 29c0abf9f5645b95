"""A measured study is run: all its groups with their origin, or nothing at all."""

import json
import os

import netCDF4
import pytest
import xarray as xr

from elastomer_friction.workflow.cli import main
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.run.measurement import run_measured
from elastomer_friction.workflow.study.read import read_study


def test_all_groups_are_written_with_their_origin(powers, tmp_path, capsys):
    said = run_measured(read_study("powers"), tmp_path / "powers.nc")
    shown = capsys.readouterr()
    assert "powers      3\n" in shown.err  # the outline
    assert not shown.out  # it is for the summary
    assert said[0] == "largest 4"
    assert said[-1].endswith("of core time used, 2 s predicted")
    groups = xr.open_groups(tmp_path / "powers.nc")
    assert groups["/"].found.values.tolist() == [1.0, 2.0, 4.0]
    assert groups["/seed"].seed == 5
    for group in ("/", "/seed"):
        assert groups[group].attrs["seed"] == 5
        assert json.loads(groups[group].attrs["study"])["measure"]["powers"] == 3
        groups[group].close()


def test_a_measured_result_that_was_edited_is_named(powers, tmp_path, capsys):
    study, result = str(powers / "study.toml"), tmp_path / "out" / "powers.nc"
    commands = (["table", study, "--out", str(result.parent)], ["verify", str(result.parent)])
    run_measured(read_study(study), result)
    assert [main(command) for command in commands] == [0, 0]
    note = "was changed or replaced since a run wrote it"
    assert note not in "".join(capsys.readouterr())
    with netCDF4.Dataset(result, "a") as file:
        file["found"][:] = 2.0 * file["found"][:]
    assert [main(command) for command in commands] == [0, 3]
    out, err = capsys.readouterr()
    assert f"fault       {result}: {note}" in out
    assert f"note: {result}: {note}" in err
    run_measured(read_study(study), result)
    assert [main(command) for command in commands] == [0, 0]


def test_an_interrupted_measurement_leaves_the_earlier_result(powers, tmp_path):
    result = tmp_path / "powers.nc"
    run_measured(read_study("powers"), result)
    before = result.read_bytes()
    (powers / "helper.py").write_text("def power(base, n):\n    raise KeyboardInterrupt\n")
    with pytest.raises(KeyboardInterrupt):
        run_measured(read_study("powers"), result)
    assert result.read_bytes() == before


def test_nothing_is_measured_where_the_result_could_not_be_written(powers, tmp_path):
    (powers / "helper.py").write_text("def power(base, n):\n    raise AssertionError\n")
    (tmp_path / "powers.nc").mkdir()
    with pytest.raises(UserError, match=r"powers\.nc: cannot be written: it is not a regular file"):
        run_measured(read_study("powers"), tmp_path / "powers.nc")


def test_core_time_is_that_of_processors_not_of_the_clock(powers, tmp_path, monkeypatch):
    hours = iter(range(9))
    monkeypatch.setattr(os, "times", lambda: (1.0, 2.0, 3.0, 4.0, 3600.0 * next(hours)))
    said = run_measured(read_study("powers"), tmp_path / "powers.nc")
    assert said[-1].startswith("0 s of core time used")
