"""The command line: what it prints, and its exit status."""

import pytest

from tests.workflow.runs import PATIENCE, start
from tests.workflow.small import TEXT, write_study
from workflow.cli import commands as cli
from workflow.cli import main


@pytest.fixture
def study(tmp_path):
    """Return the path of the small study."""
    return write_study(tmp_path)


def output(capsys, *arguments):
    """Return what a command that succeeds prints to stdout."""
    assert main(list(arguments)) == 0
    out, err = capsys.readouterr()
    assert err == ""
    return out


def complaint(capsys, *arguments):
    """Return the one line on stderr of a command that fails."""
    assert main(list(arguments)) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("error: ")
    assert err.count("\n") == 1
    assert err.endswith("\n")
    return err


def facts(text):
    """Return the lines of a plan by their first word."""
    return {line.split()[0]: line for line in text.splitlines()}


def test_plan_prints_points_problems_and_realizations(capsys, study):
    settings = ["--set", "grid.roughness=[1e-5, 1e-6]", "--set", "grid.normal_force=[0.04, 0.4]"]
    found = facts(output(capsys, "plan", study, *settings))
    assert found["points"].split() == ["points", "16"]
    assert found["problems"].startswith("problems    12 distinct dimensionless problems (1.33 ")
    assert found["realizations"] == "realizations 4 each, 96 in all"
    assert found["variants"].split(maxsplit=1)[1] == "study, coarse"


def test_plan_prints_the_axes(capsys, study):
    found = facts(output(capsys, "plan", study, "--scale", "wide"))
    assert found["normal_force"].split() == ["normal_force", "3", "0.04", "...", "4"]
    assert found["spacing"].split() == ["spacing", "1", "0.0001"]


def test_plan_says_which_effects_are_simulated(capsys, study):
    everything = output(capsys, "plan", study)
    assert everything.count("not simulated") == 1  # models
    assert "indentation rate in the force: kept" in everything
    settings = ["--set", 'scene.quantities=["steady"]', "--set", "scene.indentation_rate=false"]
    steady = output(capsys, "plan", study, *settings)
    assert "simulated     steady sliding" in steady
    assert "not simulated jump at t0+" in steady
    assert "not simulated relaxation after the jump" in steady
    assert "indentation rate in the force: dropped" in steady


def test_plan_predicts_time_and_memory(capsys, study):
    found = facts(output(capsys, "plan", study, "--set", "study.realizations=100000"))
    assert "of one core" in found["predicted"]
    assert found["predicted"].split()[2] in ("min", "h")
    assert int(found["memory"].split()[1]) > 100
    assert found["memory"].endswith("samples")


def test_plan_computes_and_writes_nothing(capsys, study, tmp_path):
    found = facts(output(capsys, "plan", study, "--out", str(tmp_path / "out")))
    assert found["result"].split()[1] == str(tmp_path / "out" / "small.nc")
    assert not (tmp_path / "out").exists()


def test_status_before_a_run(capsys, study, tmp_path):
    found = facts(output(capsys, "status", study, "--out", str(tmp_path / "out")))
    assert found["done"] == "done        0 of 64 records (problem x block)"
    assert found["waiting"] == "waiting     64 records"
    assert "core-hours, predicted" in found["remaining"]
    assert found["run"] == "run         not running"
    assert found["result"].endswith("small.nc (not written yet)")
    assert not (tmp_path / "out").exists()


def test_status_after_a_run(capsys, study, finished):
    found = facts(output(capsys, "status", study, "--out", str(finished.path)))
    assert found["done"].startswith("done        64 of 64 records")
    assert found["waiting"] == "waiting     0 records"
    assert found["failed"] == "failed      0 problems"
    assert found["remaining"].startswith("remaining   0 core-hours")
    assert found["run"].startswith("run         finished, 20")
    assert found["result"] == f"result      {finished.path}"


def test_run_reports_what_it_did(capsys, study, scheduler, tmp_path):
    arguments = ["run", study, "--out", str(tmp_path / "mine.nc"), "--scheduler", scheduler]
    assert main(arguments) == 0
    out, err = capsys.readouterr()
    assert out.splitlines()[-1] == str(tmp_path / "mine.nc")
    assert "batches computed" in out
    assert "0 records reused" in out
    assert "core time used" in out
    assert any(line.startswith("fitting: 100%") for line in err.splitlines())
    assert (tmp_path / "mine.nc").is_file()


def test_a_dead_scheduler_is_one_line(capsys, study, tmp_path, impatient):
    address = ("--scheduler", "tcp://127.0.0.1:1", "--out", str(tmp_path))
    assert "tcp://127.0.0.1:1: no scheduler answers" in complaint(capsys, "run", study, *address)


def test_bad_input_is_one_line_in_a_process_of_its_own(study):
    process = start("plan", study, "--set", "grid.hurst=1.2")
    out, err = process.communicate(timeout=PATIENCE)
    assert (process.returncode, out) == (2, "")
    assert err == "error: grid.hurst = 1.2: must lie between 0 and 1\n"


@pytest.mark.parametrize("command", ["plan", "run", "status", "figure"])
def test_unknown_study_is_one_line(capsys, command):
    assert "study 'nowhere': not among" in complaint(capsys, command, "nowhere")


@pytest.mark.parametrize(
    ("option", "value"),
    [
        ("--workers", "0"),
        ("--workers", "-2"),
        ("--max-failures", "-1"),
        ("--batch-seconds", "0.0"),
        ("--batch-seconds", "-1.0"),
        ("--batch-seconds", "nan"),
    ],
)
def test_bad_option_of_run_names_it(capsys, study, tmp_path, option, value):
    message = complaint(capsys, "run", study, f"{option}={value}", "--out", str(tmp_path))
    assert message.startswith(f"error: {option} {value}: must ")


def test_endless_batches_are_refused(capsys, study, scheduler, tmp_path):
    options = ("--batch-seconds", "inf", "--out", str(tmp_path), "--scheduler", scheduler)
    assert "--batch-seconds" in complaint(capsys, "run", study, *options)


def test_results_below_a_file_are_refused(capsys, study):
    message = complaint(capsys, "run", study, "--out", f"{study}/results")
    assert "cannot be used for results" in message


def test_figure_before_the_run_says_what_to_do(capsys, tmp_path):
    message = complaint(capsys, "figure", "fig7", "--out", str(tmp_path))
    assert "fig7.nc: not found; first run: python -m workflow run fig7" in message


def test_figure_of_a_study_without_a_script(capsys, study, finished):
    arguments = ("figure", study, "--out", str(finished.path))
    assert "figure.py: not found" in complaint(capsys, *arguments)


def test_second_ctrl_c_ends_with_the_status_of_an_interruption(capsys, study, monkeypatch):
    def interrupt(_):
        raise KeyboardInterrupt

    monkeypatch.setitem(cli.COMMANDS, "plan", interrupt)
    assert main(["plan", study]) == 130
    assert "to resume run again: python -m workflow" in capsys.readouterr().err


@pytest.mark.parametrize("arguments", [[], ["paint", "fig7"], ["plan"], ["plan", "x", "--no"]])
def test_wrong_usage_has_exit_status_two(capsys, arguments):
    with pytest.raises(SystemExit) as error:
        main(arguments)
    assert error.value.code == 2
    assert "usage: python -m workflow" in capsys.readouterr().err


def test_a_line_too_long_is_one_line(capsys, tmp_path):
    path = write_study(tmp_path, TEXT.replace("velocity = [0.03, 0.1]", "velocity = 1e-9"))
    assert "samples per line" in complaint(capsys, "plan", path)


@pytest.mark.parametrize("text", ["5%", "0.05"])
def test_an_accuracy_on_the_command_line_is_the_setting(capsys, study, text):
    by_option = output(capsys, "plan", study, "--accuracy", text)
    assert by_option == output(capsys, "plan", study, "--set", "numerics.accuracy=0.05")
    assert by_option != output(capsys, "plan", study)


def test_an_accuracy_that_is_no_number_is_refused(capsys, study):
    expected = "error: --accuracy fine: must be a number such as 1% or 0.01\n"
    assert complaint(capsys, "plan", study, "--accuracy", "fine") == expected
    assert "numerics.accuracy = 2.0: must lie between" in complaint(
        capsys, "plan", study, "--accuracy", "200%"
    )


def test_a_result_of_another_accuracy_is_not_drawn(capsys, study, tmp_path):
    out = ("--out", str(tmp_path))
    assert main(["run", study, "--workers", "1", *out]) == 0
    capsys.readouterr()
    assert "other settings than asked for: numerics.accuracy" in complaint(
        capsys, "table", study, "--accuracy", "5%", *out
    )
