"""The command run: its options, what it prints, its exit status."""

import pytest

from elastomer_friction.workflow.cli import main
from elastomer_friction.workflow.cli import run_options as command
from elastomer_friction.workflow.cli.run_options import paced_plan, resume_line
from elastomer_friction.workflow.plan import TYPICAL, Pace
from elastomer_friction.workflow.plan.cost.machine import Machine
from elastomer_friction.workflow.plan.cost.work import PARTS
from tests.support.commands import refusal
from tests.support.small import small_study


def test_run_reports_what_it_did(capsys, study, tmp_path):
    arguments = ["run", study, "--out", str(tmp_path / "mine.nc")]
    assert main(arguments) == 0
    out, err = capsys.readouterr()
    assert out.splitlines()[-1] == str(tmp_path / "mine.nc")
    assert "batches computed" in out
    assert "0 records reused" in out
    assert "core time used" in out
    assert any(line.startswith("fitting: 100%") for line in err.splitlines())
    assert (tmp_path / "mine.nc").is_file()


BAD = "workers=0 workers=-2 max-failures=-1"
BAD += " batch-seconds=0.0 batch-seconds=-1.0 batch-seconds=nan batch-seconds=inf"


@pytest.mark.parametrize("option", BAD.split())
def test_bad_option_of_run_names_it(capsys, study, tmp_path, option):
    message = refusal(capsys, "run", study, f"--{option}", "--out", str(tmp_path))
    assert message.startswith(f"error: --{option.replace('=', ' ')}: must ")


def test_a_scheduler_and_a_batch_system_are_one_too_many(capsys, study):
    said = refusal(capsys, "run", study, "--slurm", "--scheduler", "tcp://127.0.0.1:1")
    assert said == "error: --scheduler and --slurm: only one of them\n"


@pytest.mark.parametrize("option", ["--workers=2", "--batch-seconds=1", "--scheduler=tcp://x:1"])
def test_options_of_the_cluster_are_refused_where_there_is_none(powers, capsys, option):
    assert "is measured in one process" in refusal(capsys, "run", "powers", option)


def test_results_below_a_file_are_refused(capsys, study):
    message = refusal(capsys, "run", study, "--out", f"{study}/results")
    assert "cannot be used for results" in message


def test_how_to_go_on_can_be_typed_again(monkeypatch):
    monkeypatch.setattr("sys.argv", ["workflow", "run", "fig7", "--set", "grid.hurst=[0.3, 0.7]"])
    assert resume_line("interrupted").endswith("run fig7 --set 'grid.hurst=[0.3, 0.7]'")


@pytest.mark.parametrize(
    ("realizations", "known", "measured"), [(4, 0, 0), (10**5, 0, 1), (10**5, 1, 0)]
)
def test_a_machine_is_measured_for_what_takes_longer_than_that(
    monkeypatch, realizations, known, measured
):
    """Unless it is known."""
    asked, fast = [], Machine(Pace(dict.fromkeys(PARTS, (0.5, 1.1))), "fast")
    monkeypatch.setattr(command, "known_machine", lambda: fast if known else None)
    monkeypatch.setattr(command, "this_machine", lambda: asked.append(1) or fast)
    plan = paced_plan(small_study(f"study.realizations={realizations}"))
    assert len(asked) == measured
    assert plan.pace == (fast.pace if known or measured else TYPICAL)
