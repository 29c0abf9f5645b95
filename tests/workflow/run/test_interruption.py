"""Runs that are killed or interrupted keep what is finished and resume to the same bytes."""

import os
import signal

import pytest

from elastomer_friction.workflow.cli import main
from elastomer_friction.workflow.store.store import Store, store_folder
from tests.cluster.processes import Trial, end
from tests.support.runs import run, shards
from tests.support.shards import held, reopened

LONG, RECORDS = "study.realizations=120", 480  # a batch each


def ended(folder, number, *options):
    """Return the exit status of a long run whose process group got a signal early, and its log."""
    trial = Trial(folder, "--set", LONG, *options, stopping=True)
    try:
        trial.wait_for_its_stop()
        os.killpg(trial.driver.pid, number)
        trial.go_on()
        status, lines = trial.ended()
    finally:
        end(trial.driver)
    assert not (folder / "small.nc").exists()
    return status, "\n".join(lines)


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    """Return the bytes of the long study, run without interruption."""
    return run(tmp_path_factory.mktemp("whole"), LONG).path.read_bytes()


def assert_resumes(folder, expected):
    """Assert that a run in ``folder`` recomputes nothing finished and gives the same bytes."""
    before = shards(folder)
    finished = len(held(reopened(store_folder(folder / "small.nc"))))
    assert 2 <= finished < RECORDS
    resumed = run(folder, LONG)
    assert resumed.summary.reused == finished
    after = shards(folder)
    assert {name: after[name] for name in before} == before
    assert resumed.path.read_bytes() == expected


def test_a_killed_run_resumes(scheduler, tmp_path, expected):
    status, _ = ended(tmp_path, signal.SIGKILL, "--scheduler", scheduler)
    assert status == -signal.SIGKILL
    assert_resumes(tmp_path, expected)


HERE = pytest.param((), id="here")
ON_A_WORKER = pytest.param(("--workers", "1"), id="on a worker", marks=pytest.mark.exhaustive)


@pytest.mark.parametrize("options", [HERE, ON_A_WORKER])
def test_ctrl_c_stops_a_run_that_resumes(tmp_path, expected, capsys, options):
    status, said = ended(tmp_path, signal.SIGINT, *options)
    assert status == 130
    assert "to resume run again: python -m workflow run" in said.splitlines()[-1]
    assert "Traceback" not in said
    finished = len(held(Store(store_folder(tmp_path / "small.nc"))))  # a record per batch
    assert f"{finished} batches computed" in said
    done = f"done        {finished} of {RECORDS} records"
    main(["status", str(tmp_path / "small.toml"), "--out", str(tmp_path), "--set", LONG])
    assert capsys.readouterr().out.startswith(done)
    assert_resumes(tmp_path, expected)
