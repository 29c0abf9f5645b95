"""The command line: which commands there are, what they are told, and their exit status."""

import json
import os
import subprocess
import sys

import pytest

from elastomer_friction.workflow.cli import commands as cli
from elastomer_friction.workflow.cli import main
from tests.support.commands import output, refusal
from tests.support.runs import PATIENCE, ROOT, start
from tests.support.sweeps import mostly_exhaustive


@pytest.mark.exhaustive  # in this process every refusal is asked for
def test_bad_input_is_one_line_in_a_process_of_its_own(study):
    process = start("plan", study, "--set", "grid.hurst=1.2")
    out, err = process.communicate(timeout=PATIENCE)
    assert (process.returncode, out) == (2, "")
    assert err == "error: grid.hurst = 1.2: must lie between 0 and 1\n"


@pytest.mark.parametrize("command", ["plan", "run", "status", "figure", "table", "report"])
def test_unknown_study_is_one_line(capsys, command):
    assert "study 'nowhere': not among" in refusal(capsys, command, "nowhere")


def test_second_ctrl_c_ends_with_the_status_of_an_interruption(capsys, study, monkeypatch):
    def interrupt(_):
        raise KeyboardInterrupt

    for command, said in (("run", "to resume run again: python -m workflow"), ("plan", "")):
        monkeypatch.setitem(cli.COMMANDS, command, cli.COMMANDS[command]._replace(run=interrupt))
        assert main([command, study]) == 130
        err = capsys.readouterr().err
        assert said in err
        assert ("kept" in err) == bool(said)


def test_ctrl_c_while_options_are_read_is_one_line(capsys, monkeypatch):
    def interrupted():
        raise KeyboardInterrupt

    monkeypatch.setattr(cli, "command_parser", interrupted)
    assert main(["run", "fig2"]) == 130
    assert capsys.readouterr().err == "interrupted\n"


def test_ctrl_c_in_a_measured_study_does_not_claim_that_work_was_kept(capsys, powers):
    (powers / "helper.py").write_text("def power(base, n):\n    raise KeyboardInterrupt\n")
    assert main(["run", "powers"]) == 130
    err = capsys.readouterr().err
    assert err.endswith("interrupted; nothing was written, an earlier result is as it was\n")
    assert "kept" not in err


@pytest.mark.parametrize("arguments", [[], ["paint", "fig7"], ["plan"], ["plan", "x", "--no"]])
def test_wrong_usage_has_exit_status_two(capsys, arguments):
    with pytest.raises(SystemExit) as error:
        main(arguments)
    assert error.value.code == 2
    assert "usage: python -m workflow" in capsys.readouterr().err


@pytest.mark.parametrize("text", ["5%", "0.05"])
def test_an_accuracy_on_the_command_line_is_the_setting(capsys, study, text):
    by_option = output(capsys, "plan", study, "--accuracy", text)
    assert by_option == output(capsys, "plan", study, "--set", "numerics.accuracy=0.05")
    assert by_option != output(capsys, "plan", study)


def test_an_accuracy_that_is_no_number_is_refused(capsys, study):
    expected = "error: --accuracy fine: must be a number such as 1% or 0.01\n"
    assert refusal(capsys, "plan", study, "--accuracy", "fine") == expected
    said = refusal(capsys, "plan", study, "--accuracy", "200%")
    assert "numerics.accuracy = 2.0: must lie between" in said


def test_a_result_of_another_accuracy_is_not_drawn(capsys, study, finished):
    said = refusal(capsys, "table", study, "--accuracy", "5%", "--out", str(finished.path))
    assert "other settings than asked for: numerics.accuracy" in said
    assert not finished.path.with_suffix(".csv").exists()


def test_plan_and_status_as_data(capsys, study, tmp_path):
    planned = json.loads(output(capsys, "plan", study, "--json", "--out", str(tmp_path)))
    assert planned["axes"]["hurst"] == [0.3, 0.7]
    assert (planned["points"], planned["variants"]) == (8, ["", "coarse"])
    assert planned["result"] == str(tmp_path / "small.nc")
    assert planned["settings"] == study
    low, high = planned["predicted_core_seconds_interval"]
    assert low <= planned["predicted_core_seconds"] <= high
    found = json.loads(output(capsys, "status", study, "--json", "--out", str(tmp_path)))
    assert (found["records"], found["records_done"], found["written"]) == (64, 0, False)
    assert found["state"] == "not running"


def test_a_value_that_a_plan_has_not_is_null(capsys, powers):
    measured = json.loads(output(capsys, "plan", "measured_line", "--scale", "smoke", "--json"))
    assert measured["axes"]["hurst"] == [None]
    assert json.loads(output(capsys, "plan", "powers", "--json"))["predicted_core_seconds"] == 1.5
    assert json.loads(output(capsys, "status", "powers", "--json"))["written"] is False


@mostly_exhaustive(
    ("typed", "expected"),
    [("plan fig", {f"fig{n}" for n in range(2, 9)})],
    [("st", {"status", "studies"})],
)
def test_a_shell_completes_commands_and_names_of_studies(tmp_path, typed, expected):
    pytest.importorskip("argcomplete")
    line = f"elastomer-friction {typed}"
    done = subprocess.run(
        [sys.executable, "-m", "workflow"],
        env={
            **os.environ,
            "_ARGCOMPLETE": "1",
            "_ARGCOMPLETE_STDOUT_FILENAME": str(tmp_path / "found"),
            "COMP_LINE": line,
            "COMP_POINT": str(len(line)),
        },
        cwd=ROOT,
        timeout=PATIENCE,
        check=True,
    )
    assert done.returncode == 0
    found = (tmp_path / "found").read_text().replace("\013", " ").split()
    assert {word.strip() for word in found} == expected
