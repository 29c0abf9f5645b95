"""Whole runs, real processes, on a disk that refuses: they wait, end in one line, or go on."""

import os
import signal
import subprocess
import sys
import time
from functools import partial

import pytest

from elastomer_friction.workflow.cli import main
from tests.cluster.processes import PATIENCE, said
from tests.support.faulty_disk import faulty_disk
from tests.support.python import ROOT
from tests.support.small import write_study

pytestmark = pytest.mark.cluster


@pytest.fixture(scope="module")
def disk(tmp_path_factory):
    """Return a disk that refuses on demand."""
    return faulty_disk(tmp_path_factory.mktemp("disk"))


@pytest.fixture
def begun(tried, tmp_path):
    """Return what starts a run in one process."""
    return partial(tried, tmp_path)


def assert_whole(run, expected):
    """Assert that a run ends with the result of a sound disk, and nothing was damaged."""
    assert run.whole() == expected
    assert not list(run.folder.glob("**/*.damaged"))
    assert not list(run.folder.glob("**/.*.tmp"))


@pytest.mark.parametrize(  # other faults: tests/hard/test_disk_errors.py
    ("fault", "workers"), [("fsync EIO", ("--workers", "1")), ("open EMFILE", ())]
)
def test_a_run_waits_for_the_disk_and_ends_with_the_same_bytes(
    disk, begun, tmp_path, undisturbed, fault, workers
):
    run = begun(*workers, stopping=True, **disk.environment(f"{fault} {tmp_path / 'store'}/"))
    run.wait_for_its_stop()
    with disk.failing():
        run.go_on()
        run.wait_for(r".*cannot be (written|read): .*; tried again for 10\.0 min at most")
        time.sleep(1.0)
    assert_whole(run, undisturbed)


def test_a_full_disk_ends_a_run_in_one_line_and_it_is_resumed(disk, begun, tmp_path, undisturbed):
    rules = disk.environment(f"write ENOSPC {tmp_path}/store")
    run = begun("--set", "cluster.patience=6", stopping=True, **rules)  # s; a look may count 5
    run.wait_for_its_stop()
    with disk.failing():
        run.go_on()
        status, lines = run.ended()
    assert status == 2
    last = r"error: .*cannot be written: No space left on device; given.*"
    assert said(last, lines[-1:])
    run.again(**rules)
    assert_whole(run, undisturbed)


def test_without_locks_a_run_is_refused_and_with_no_lock_goes_to_its_end(
    disk, begun, tmp_path, undisturbed
):
    rules = disk.environment(f"flock ENOLCK {tmp_path} always")
    run = begun(**rules)
    status, (line,) = run.ended()
    assert status == 2
    assert line.endswith("then add --no-lock")
    run.again("--no-lock", **rules)
    assert_whole(run, undisturbed)


def test_a_result_waits_for_the_disk_too(disk, begun, tmp_path, undisturbed):
    with disk.failing():
        run = begun(**disk.environment(f"write ENOSPC {tmp_path}/.small.nc"))
        run.wait_for(r".*small\.nc: cannot be written: .*; tried again.*")
        time.sleep(1.0)
    assert_whole(run, undisturbed)


def test_a_folder_that_is_not_flushed_and_a_status_that_is_not_written_are_reported(
    disk, begun, tmp_path, undisturbed
):
    rules = f"fsyncdir EINVAL {tmp_path} always", f"open EIO {tmp_path}/.small.status always"
    run = begun(**disk.environment(*rules))
    assert_whole(run, undisturbed)
    assert said(".*cannot flush a folder.*", run.lines()) == 1
    assert said(".*the run continues.*", run.lines()) == 1


@pytest.mark.parametrize("which", ["each", pytest.param("all", marks=pytest.mark.exhaustive)])
def test_each_call_to_the_disk_fails_in_turn(disk, tmp_path, which):
    command = [sys.executable, "-m", "tests.cluster.failing_calls", disk.library, tmp_path, which]
    environment = os.environ | {"LD_PRELOAD": str(disk.library)}
    done = subprocess.run(
        list(map(str, command)), cwd=ROOT, env=environment, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr[-2000:]
    lines = done.stdout.splitlines()
    assert said("case 0", lines) > 10  # some calls are repeated, or do not matter
    assert said("case 2", lines) > 10


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_signals_of_batch_systems_and_terminals_keep_what_is_finished(begun, undisturbed, number):
    usual = signal.signal(number, signal.SIG_DFL)  # inherited; nohup ignores SIGHUP
    try:
        run = begun(stopping=True)
    finally:
        signal.signal(number, usual)
    run.wait_for_its_stop()
    os.kill(run.driver.pid, number)
    run.go_on()
    status, lines = run.ended()
    assert status == 130
    assert said(".*to resume run again.*", lines[-1:])
    run.again()
    assert_whole(run, undisturbed)


LOOK = """
import sys
from pathlib import Path
from elastomer_friction.workflow.system import holder
while True:
    holder(Path(sys.argv[1]))
"""


def test_status_beside_a_starting_run_never_makes_it_fail(tmp_path, capsys):
    """The lock is looked at without a pause, by two processes, while it is taken 300 times.

    One of them may be held up while it looks, for which a run would not wait.
    """
    store = tmp_path / "store"
    store.mkdir()
    (store / "lock").touch()
    command = [sys.executable, "-c", LOOK, str(store)]
    lookers = [subprocess.Popen(command, cwd=ROOT) for _ in range(2)]
    hold = "from pathlib import Path; from elastomer_friction.workflow.system import lock\n"
    hold += f"lock.PROBE_SECONDS = {PATIENCE}\n"
    hold += f"for _ in range(300):\n    with lock.hold(Path({str(store)!r})): pass"
    try:
        time.sleep(2.0)
        done = subprocess.run([sys.executable, "-c", hold], cwd=ROOT, check=False)
    finally:
        for process in lookers:
            process.kill()
            process.wait(timeout=PATIENCE)
    assert done.returncode == 0
    assert main(["status", write_study(tmp_path), "--out", str(tmp_path)]) == 0
    assert "records" in capsys.readouterr().out
