"""The command line: commands, options and exit statuses."""

import errno
import json
import re

import pytest

from elastomer_friction.workflow.cli import command_line, main
from elastomer_friction.workflow.cli import commands as cli
from elastomer_friction.workflow.cli.run_options import resume_line
from tests.support.commands import facts, output, refusal
from tests.support.python import printed, python
from tests.support.small import line_text, write_study
from tests.support.sweeps import mostly_exhaustive


@pytest.mark.parametrize("command", ["plan", "run", "status", "figure", "table", "report"])
def test_unknown_study_is_one_line(capsys, command):
    assert "study 'nowhere': must be a study" in refusal(capsys, command, "nowhere")


def test_second_ctrl_c_ends_with_the_status_of_an_interruption(capsys, study, monkeypatch):
    def interrupt(_):
        raise KeyboardInterrupt

    for command, said in (("run", "to resume run again: python -m workflow"), ("plan", "")):
        monkeypatch.setitem(cli.ACTIONS, command, interrupt)
        assert main([command, study]) == 130
        err = capsys.readouterr().err
        assert said in err
        assert ("kept" in err) == bool(said)


@pytest.mark.parametrize(
    ("error", "line"),
    [
        (MemoryError(), "memory of this machine is full: free some"),
        (OSError(errno.ENOMEM, "Cannot allocate memory"), "memory of this machine is full"),
        (OSError(errno.EIO, "Input/output error", "a.nc"), "a.nc: Input/output error; what is st"),
        (OSError(errno.ENFILE, "Too many open files"), "a file: Too many open files; what is st"),
    ],
)
def test_full_memory_and_disk_errors_are_one_line(capsys, monkeypatch, error, line):
    def fail(_):
        raise error

    monkeypatch.setitem(cli.ACTIONS, "plan", fail)
    assert line in refusal(capsys, "plan", "fig2")


def test_other_errors_are_not_taken_for_full_memory(study, monkeypatch):
    def fail(_):
        raise SystemError("bad argument to internal function")

    monkeypatch.setitem(cli.ACTIONS, "plan", fail)
    with pytest.raises(SystemError, match="bad argument"):
        main(["plan", study])


def test_a_path_that_is_not_utf_8_is_one_line_before_anything_is_computed(capsys):
    assert r"r\udce9: must be UTF-8" in refusal(capsys, "run", "fig2", "--out", "r\udce9")


def test_a_missing_folder_for_temporary_files_is_refused(capsys, monkeypatch):
    def missing():
        raise FileNotFoundError(errno.ENOENT, "No usable temporary directory found")

    monkeypatch.setattr(command_line.tempfile, "gettempdir", missing)
    assert "TMPDIR: No usable temporary directory found" in refusal(capsys, "plan", "fig2")


def test_ctrl_c_while_options_are_read_is_one_line(capsys, monkeypatch):
    def interrupted(_):
        raise KeyboardInterrupt

    monkeypatch.setattr(command_line, "command_parser", interrupted)
    assert main(["run", "fig2"]) == 130
    assert capsys.readouterr().err == "aborted before the start\n"


@pytest.mark.parametrize(
    "words", ["--help", "run --help", "prony --help", "plan fig2 --fast", "draw"]
)
def test_help_and_wrong_options_wait_for_no_package(words):
    heavy = "{'numba', 'dask', 'xarray', 'scipy', 'netCDF4', 'matplotlib'}"
    code = (
        "import atexit, sys; from elastomer_friction.workflow.cli import main;"
        f"atexit.register(lambda: print({heavy} & sys.modules.keys(), file=sys.stderr));"
        f"sys.exit(main({words.split()}))"
    )
    done = python("-c", code)
    assert done.returncode == (0 if "--help" in words else 2)
    assert done.stderr.endswith("set()\n")


def test_ctrl_c_in_a_measured_study_does_not_claim_that_work_was_kept(capsys, powers):
    (powers / "helper.py").write_text("def power(base, n):\n    raise KeyboardInterrupt\n")
    assert main(["run", "powers"]) == 130
    err = capsys.readouterr().err
    assert err.endswith("interrupted; nothing was written, an earlier result is as it was\n")
    assert "kept" not in err


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([], "the following arguments are required: command"),
        (["paint", "fig7"], "paint: is not a command; did you mean plan"),
        (["plan"], "the following arguments are required: study"),
        (["plan", "x", "--no"], "unrecognized arguments: --no"),
    ],
)
def test_wrong_usage_is_one_line_that_names_the_help(capsys, arguments, words):
    said = refusal(capsys, *arguments)
    assert words in said
    assert re.search(r"; see python -m workflow( plan)? --help\n$", said)


@pytest.mark.parametrize("text", ["5%", "0.05"])
def test_an_accuracy_on_the_command_line_is_the_setting(capsys, study, text):
    by_option = output(capsys, "plan", study, "--accuracy", text)
    assert by_option == output(capsys, "plan", study, "--set", "numerics.accuracy=0.05")
    assert by_option != output(capsys, "plan", study)


def test_a_result_of_another_accuracy_is_not_drawn(capsys, study, finished):
    said = refusal(capsys, "table", study, "--accuracy", "5%", "--out", str(finished.path))
    assert "other settings than requested: numerics.accuracy" in said
    assert not finished.path.with_suffix(".csv").exists()


def test_plan_and_status_as_data(capsys, study, tmp_path):
    out = tmp_path / "out"
    planned = json.loads(output(capsys, "plan", study, "--json", "--out", str(out)))
    assert planned["axes"]["hurst"] == [0.3, 0.7]
    assert (planned["points"], planned["variants"]) == (8, ["", "coarse"])
    assert planned["result"] == str(out / "small.nc")
    assert planned["settings"] == study
    low, high = planned["predicted_core_seconds_interval"]
    assert low <= planned["predicted_core_seconds"] <= high
    found = json.loads(output(capsys, "status", study, "--json", "--out", str(out)))
    assert (found["records"], found["records_done"], found["written"]) == (64, 0, False)
    assert found["state"] == "not running"
    assert not out.exists()  # nothing is computed, nothing written


OF_FILES = """
[study]
seed = 1
[material]
shear_modulus = 1e7
branches_file = "branches.csv"
shifts_file = "shifts.csv"
temperature = 20
[surface]
file = "holes.csv"
gaps = "fill"
[scene]
control = "indentation"
indentation_file = "d.csv"
quantities = ["trace"]
programme = [{file = "velocity.csv"}]
"""


def test_a_plan_as_data_describes_each_file_read(capsys, tmp_path):
    path = write_study(tmp_path, OF_FILES)
    (tmp_path / "d.csv").write_text("time (ms), d (um)\n0, 1\n5, 2\n")
    (tmp_path / "holes.csv").write_text(line_text((1, "nan", 2, -3, 4, 5, -2, 3, 1, -2)))
    planned = json.loads(output(capsys, "plan", path, "--json"))
    read = {each.pop("what"): each for each in planned["read"]}
    assert list(read) == ["lines", "branches", "shifts", "programme", "indentation"]
    assert {"lines": 1, "samples": [20], "step": 1e-6}.items() <= read["lines"].items()
    assert 1e-9 < read["lines"]["roughness"] < 1e-8
    assert 1e-3 < read["lines"]["rms_slope"] < 1e-1
    assert "fill" in read["lines"]["told"]
    assert "column 0 modulus as a modulus in Pa" in read["branches"]["told"]
    assert "column 1 d as an indentation in um" in read["indentation"]["told"]
    shown = output(capsys, "plan", path)
    assert all(each["told"] in shown for each in read.values())


def test_a_missing_value_of_a_plan_is_null(capsys, powers):
    measured = json.loads(output(capsys, "plan", "measured_line", "--scale", "smoke", "--json"))
    assert measured["axes"]["hurst"] == [None]
    shown = output(capsys, "plan", "measured_line", "--scale", "smoke")
    assert re.search(r"^  hurst +1  of the surface$", shown, re.MULTILINE)
    assert json.loads(output(capsys, "plan", "powers", "--json"))["predicted_core_seconds"] == 1.5
    assert json.loads(output(capsys, "status", "powers", "--json"))["written"] is False


@mostly_exhaustive(
    ("typed", "expected"),
    [("plan fig", {f"fig{n}" for n in range(2, 9)} | {"fig7_half_space"})],
    [("st", {"status", "studies"})],
)
def test_a_shell_completes_commands_and_names_of_studies(tmp_path, typed, expected):
    pytest.importorskip("argcomplete")
    line = f"elastomer-friction {typed}"
    asked = {"COMP_LINE": line, "COMP_POINT": str(len(line)), "_ARGCOMPLETE": "1"}
    printed("-m", "workflow", **asked, _ARGCOMPLETE_STDOUT_FILENAME=str(tmp_path / "found"))
    found = (tmp_path / "found").read_text().replace("\013", " ").split()
    assert {word.strip() for word in found} == expected


def test_run_reports_what_it_did(capsys, study, tmp_path):
    arguments = ["run", study, "--out", str(tmp_path / "mine.nc")]
    assert main(arguments) == 0
    out, err = capsys.readouterr()
    assert out.splitlines()[-1] == str(tmp_path / "mine.nc")
    assert "batches computed" in out
    assert "0 records reused" in out
    assert "core time used" in out
    assert [line[:15] for line in err.splitlines()].count("computing: 100%") == 1
    assert (tmp_path / "mine.nc").is_file()


BAD = "workers=0 workers=-2 max-failures=-1"
BAD += " batch-seconds=0.0 batch-seconds=-1.0 batch-seconds=nan batch-seconds=inf"


@pytest.mark.parametrize(
    ("options", "words"),
    [
        *((f"--{each}", f"--{each.replace('=', ' ')}: must ") for each in BAD.split()),
        ("--slurm --scheduler tcp://x:1", "--scheduler and --slurm: only one of them\n"),
        ("--accuracy fine", "--accuracy fine: must be a number such as 1% or 0.01\n"),
        ("--accuracy 200%", "numerics.accuracy = 2.0: must lie between"),
    ],
)
def test_bad_options_of_run_are_named(capsys, study, tmp_path, options, words):
    said = refusal(capsys, "run", study, *options.split(), "--out", str(tmp_path))
    assert said.startswith(f"error: {words}")


@pytest.mark.parametrize("option", ["--workers=2", "--batch-seconds=1", "--scheduler=tcp://x:1"])
def test_options_of_the_cluster_are_refused_where_there_is_none(powers, capsys, option):
    assert "is measured in one process" in refusal(capsys, "run", "powers", option)


def test_the_command_to_resume_can_be_typed(monkeypatch):
    monkeypatch.setattr("sys.argv", ["workflow", "run", "fig7", "--set", "grid.hurst=[0.3, 0.7]"])
    assert resume_line("interrupted").endswith("run fig7 --set 'grid.hurst=[0.3, 0.7]'")


def test_status_before_a_run(capsys, study, tmp_path):
    found = facts(output(capsys, "status", study, "--out", str(tmp_path / "out")))
    assert found["done"] == "done        0 of 64 records (problem x block)"
    assert "core-hours, predicted" in found["remaining"]
    assert found["run"] == "run         not running"
    assert found["result"].endswith("small.nc (not written yet)")
    assert not (tmp_path / "out").exists()


def test_status_after_a_run(capsys, study, finished):
    found = facts(output(capsys, "status", study, "--out", str(finished.path)))
    assert found["done"].startswith("done        64 of 64 records")
    assert found["failed"] == "failed      0 problems"
    assert found["remaining"].startswith("remaining   0 core-hours")
    assert found["run"].startswith("run         finished, 20")
    assert found["result"] == f"result      {finished.path}"


def test_a_measured_study_is_planned_run_and_shown_by_the_same_commands(capsys, powers):
    results = powers.parents[1] / "results"
    planned = output(capsys, "plan", "powers")
    assert "powers: Powers of two\n" in planned
    assert "powers      3\n" in planned
    assert re.search(r"^predicted   about [\d.]+ to [\d.]+ core-seconds$", planned, re.MULTILINE)
    assert "not written yet" in output(capsys, "status", "powers")
    for command in ("figure", "table"):
        assert "powers.nc: not found" in refusal(capsys, command, "powers")
    assert main(["run", "powers"]) == 0
    out, err = capsys.readouterr()
    assert (out.splitlines()[0], out.splitlines()[-1]) == ("largest 4", "results/powers.nc")
    assert "measuring: 100%" in err
    assert "not written yet" not in output(capsys, "status", "powers")
    drawn = output(capsys, "figure", "powers").split()
    assert drawn == ["results/powers.png", "results/powers.pdf"]
    output(capsys, "table", "powers")
    assert (results / "powers.csv").read_text() == "found\n1\n2\n4\n"
