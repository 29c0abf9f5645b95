"""Runs that are killed or interrupted keep what is finished and resume to the same bytes."""

import os
import signal

import pytest

from tests.workflow.runs import PATIENCE, run, shards, start, wait_for_shards
from tests.workflow.small import write_study
from workflow import runner
from workflow.cli import main
from workflow.runner import Interrupt

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
    assert 2 <= len(before) < 320
    resumed = run(scheduler, folder, LONG)
    assert resumed.summary.reused == len(before)  # one record each
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
    assert "run again to resume" in err.splitlines()[-1]
    assert "Traceback" not in err
    assert not (tmp_path / "small.nc").exists()
    assert f"{len(shards(tmp_path))} batches computed" in out
    done = f"done        {len(shards(tmp_path))} of 320 records"
    main(["status", str(tmp_path / "small.toml"), "--out", str(tmp_path), "--set", LONG])
    assert capsys.readouterr().out.startswith(done)
    assert_resumes(scheduler, tmp_path, expected)


@pytest.fixture
def clock(monkeypatch):
    """Return a clock that moves when it is told to."""
    now = [100.0]
    monkeypatch.setattr(runner.time, "monotonic", lambda: now[0])
    return now


def test_first_signal_asks_and_a_later_one_aborts(clock, capsys):
    with Interrupt() as interrupt:
        assert not interrupt()
        signal.raise_signal(signal.SIGTERM)
        assert interrupt()
        clock[0] += 10.0
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    assert capsys.readouterr().err.count("\n") == 1


def test_a_signal_that_comes_twice_at_once_is_one(clock, capsys):
    with Interrupt() as interrupt:
        signal.raise_signal(signal.SIGINT)
        clock[0] += 0.01
        signal.raise_signal(signal.SIGTERM)
        assert interrupt()
    assert capsys.readouterr().err.count("\n") == 1


def test_handlers_of_signals_are_put_back():
    before = [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)]
    with Interrupt():
        assert signal.getsignal(signal.SIGTERM) != before[1]
    assert [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)] == before
