"""Runs that are killed or interrupted keep what is finished and resume to the same bytes."""

import os
import signal

import pytest

from tests.workflow.runs import PATIENCE, run, shards, start, wait_for_shards
from tests.workflow.shards import held, reopened
from tests.workflow.small import write_study
from workflow.cli import main
from workflow.store.store import Store, store_folder

LONG = "study.realizations=20"  # 320 batches


def launch(folder):
    """Start a run of many small batches in ``folder``."""
    options = ["--out", str(folder), "--set", LONG, "--workers", "1", "--batch-seconds", "1e-4"]
    return start("run", write_study(folder), *options)


def interrupted(folder, number, whole_group):
    """Return a run that got a signal after its first batches: exit status, stdout, stderr."""
    process = launch(folder)
    try:
        wait_for_shards(process, folder, 2)
        (os.killpg if whole_group else os.kill)(process.pid, number)
        out, err = process.communicate(timeout=PATIENCE)
    finally:
        process.kill()
    return process.returncode, out, err


@pytest.fixture(scope="module")
def expected(scheduler, tmp_path_factory):
    """Return the bytes of the long study, run without interruption."""
    return run(scheduler, tmp_path_factory.mktemp("whole"), LONG).path.read_bytes()


def assert_resumes(scheduler, folder, expected):
    """Assert that a run in ``folder`` recomputes nothing finished and gives the same bytes."""
    before = shards(folder)
    finished = len(held(reopened(store_folder(folder / "small.nc"))))
    assert 2 <= finished < 320
    resumed = run(scheduler, folder, LONG)
    assert resumed.summary.reused == finished
    after = shards(folder)
    assert {name: after[name] for name in before} == before
    assert resumed.path.read_bytes() == expected


def test_a_killed_run_resumes(scheduler, tmp_path, expected):
    status, _, _ = interrupted(tmp_path, signal.SIGKILL, whole_group=False)
    assert status == -signal.SIGKILL
    assert not (tmp_path / "small.nc").exists()
    assert_resumes(scheduler, tmp_path, expected)


def test_ctrl_c_stops_a_run_that_resumes(scheduler, tmp_path, expected, capsys):
    status, out, err = interrupted(tmp_path, signal.SIGINT, whole_group=True)
    assert status == 130
    assert "to resume run again: python -m workflow run" in err.splitlines()[-1]
    assert "Traceback" not in err
    assert not (tmp_path / "small.nc").exists()
    finished = len(held(Store(store_folder(tmp_path / "small.nc"))))  # a record per batch
    assert f"{finished} batches computed" in out
    done = f"done        {finished} of 320 records"
    main(["status", str(tmp_path / "small.toml"), "--out", str(tmp_path), "--set", LONG])
    assert capsys.readouterr().out.startswith(done)
    assert_resumes(scheduler, tmp_path, expected)
