"""The command line: which commands there are, what they are told, and their exit status."""

import pytest

from tests.support.commands import output, refusal
from tests.support.runs import PATIENCE, start
from workflow.cli import commands as cli
from workflow.cli import main


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
        monkeypatch.setitem(cli.COMMANDS, command, interrupt)
        assert main([command, study]) == 130
        err = capsys.readouterr().err
        assert said in err
        assert ("kept" in err) == bool(said)


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
