"""Measured studies: planned, run, drawn, tabled and reported like any other."""

import json

import pytest
import xarray as xr

from workflow.cli import main
from workflow.study.measured import Measured
from workflow.study.read import read_study

STUDY = """
[study]
title = "Powers of two"
seed = 5
[measure]
powers = 3
base = 2.0
[scales.smoke.measure]
powers = 1
"""
MEASURE = """
from functools import partial
import pandas as pd
import xarray as xr
from workflow.study.checks import integer, positive
from .helper import power

SETTINGS = {"powers": partial(integer, least=1), "base": positive}

def outline(settings):
    return [f"powers      {settings['powers']}"], 0.5 * settings["powers"]

def measure(settings, seed, advance):
    found = []
    for exponent in range(settings["powers"]):
        found.append(power(settings["base"], exponent))
        advance(0.5)
    return {"": xr.Dataset({"found": ("n", found)}), "seed": xr.Dataset({"seed": seed})}

def summary(groups):
    return [f"largest {float(groups[''].found.max()):g}"]

def table(groups):
    return pd.DataFrame({"found": groups[""].found.values})
"""
FIGURE = """
from matplotlib import pyplot as plt
from .helper import power

def draw(groups):
    figure, ax = plt.subplots()
    ax.plot(groups[""].found)
    return figure
"""


@pytest.fixture
def study(tmp_path, monkeypatch):
    """Return the folder of a measured study under studies/ of the working folder."""
    folder = tmp_path / "studies" / "powers"
    folder.mkdir(parents=True)
    (folder / "study.toml").write_text(STUDY)
    (folder / "measure.py").write_text(MEASURE)
    (folder / "figure.py").write_text(FIGURE)
    (folder / "helper.py").write_text("def power(base, n):\n    return base**n\n")
    monkeypatch.chdir(tmp_path)
    return folder


def refused(capsys, *words):
    """Return the one line with which a command is refused."""
    assert main(list(words)) == 2
    out, error = capsys.readouterr()
    assert out == ""
    assert error.count("\n") == 1
    return error


def test_plan_says_what_would_be_measured_and_how_long(study, capsys):
    assert main(["plan", "powers"]) == 0
    text = capsys.readouterr().out
    assert "powers: Powers of two" in text
    assert "powers      3" in text
    assert "predicted   2 s of one core" in text


def test_run_writes_all_groups_with_their_origin(study, capsys):
    assert main(["run", "powers"]) == 0
    out = capsys.readouterr().out.splitlines()
    assert (out[0], out[-1]) == ("largest 4", "results/powers.nc")
    groups = xr.open_groups("results/powers.nc")
    assert groups["/"].found.values.tolist() == [1.0, 2.0, 4.0]
    assert groups["/seed"].seed == 5
    for group in ("/", "/seed"):
        assert groups[group].attrs["seed"] == 5
        assert json.loads(groups[group].attrs["study"])["measure"]["powers"] == 3
        groups[group].close()


def test_scale_and_set_apply(study):
    assert read_study("powers", "smoke").settings == {"powers": 1, "base": 2.0}
    assert read_study("powers", "smoke", ["measure.base=3"]).settings["base"] == 3.0
    assert isinstance(read_study(str(study / "study.toml")), Measured)


def test_status_says_whether_the_result_is_there(study, capsys):
    assert main(["status", "powers"]) == 0
    assert "not written yet" in capsys.readouterr().out
    main(["run", "powers", "--scale", "smoke"])
    assert main(["status", "powers"]) == 0
    assert "not written yet" not in capsys.readouterr().out


def test_figure_table_and_report(study, capsys):
    assert main(["figure", "powers"]) == 2
    assert main(["table", "powers"]) == 2
    assert main(["run", "powers"]) == 0
    for command in ("figure", "table"):
        assert main([command, "powers"]) == 0
    assert (study.parents[1] / "results" / "powers.csv").read_text() == "found\n1\n2\n4\n"
    assert main(["report", "powers"]) == 0
    page = (study.parents[1] / "results" / "report.html").read_text()
    assert "Powers of two" in page
    assert "<td>base</td><td>2.0</td>" in page
    assert "Time stepping" not in page


@pytest.mark.parametrize(
    ("setting", "line"),
    [
        ("measure.other=1", "measure.other: unknown key; known are powers, base"),
        ("measure.powers=0", "measure.powers = 0: must be a whole number, at least 1"),
        ("measure=1", "measure = 1: must be a table"),
        ("study.realizations=9", "study.realizations: unknown key; known are title, seed"),
        ("grid.hurst=0.5", "grid: unknown key; known are study, measure"),
        ("study.seed=-1", "study.seed = -1: must be a whole number, at least 0"),
    ],
)
def test_wrong_settings_are_refused_in_one_line(study, capsys, setting, line):
    assert refused(capsys, "plan", "powers", "--set", setting) == f"error: {line}\n"


def test_a_missing_setting_is_named(study, capsys):
    (study / "study.toml").write_text("[measure]\npowers = 2\n")
    assert refused(capsys, "run", "powers") == "error: measure.base: missing\n"


def test_a_missing_script_is_named(study, capsys):
    (study / "measure.py").unlink()
    assert "measure.py: not found" in refused(capsys, "run", "powers")


@pytest.mark.parametrize("option", ["--workers=2", "--batch-seconds=1", "--scheduler=tcp://x:1"])
def test_options_of_the_cluster_are_refused(study, capsys, option):
    assert "is measured in one process" in refused(capsys, "run", "powers", option)


def test_a_study_without_a_table_says_so(study, capsys):
    (study / "measure.py").write_text(MEASURE.partition("def table")[0])
    main(["run", "powers"])
    capsys.readouterr()
    assert "has no table" in refused(capsys, "table", "powers")


def test_an_interrupted_measurement_leaves_the_earlier_result(study, capsys):
    assert main(["run", "powers"]) == 0
    before = (study.parents[1] / "results" / "powers.nc").read_bytes()
    (study / "helper.py").write_text("def power(base, n):\n    raise KeyboardInterrupt\n")
    assert main(["run", "powers"]) == 130
    assert (study.parents[1] / "results" / "powers.nc").read_bytes() == before


def test_an_edited_script_is_loaded_anew(study):
    assert main(["run", "powers"]) == 0
    (study / "helper.py").write_text("def power(base, n):\n    return -1.0 # edited\n")
    assert main(["run", "powers"]) == 0
    with xr.open_dataset("results/powers.nc") as data:
        assert data.found.values.tolist() == [-1.0] * 3
