"""Whole runs, real processes, on a disk that refuses: they wait, end in one line, or go on."""

import os
import re
import signal
import subprocess
import sys
import time

import pytest

from elastomer_friction.workflow.cli import main
from tests.cluster.processes import PATIENCE, start
from tests.support.faulty_disk import faulty_disk
from tests.support.runs import ROOT
from tests.support.small import write_study

pytestmark = pytest.mark.cluster

OPTIONS = ("--set", "study.realizations=240", "--batch-seconds", "1e-9", "--workers", "1")


@pytest.fixture(scope="module")
def disk(tmp_path_factory):
    """Return a disk that refuses on demand."""
    return faulty_disk(tmp_path_factory.mktemp("disk"))


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    """Return the bytes of the result on a sound disk."""
    folder = tmp_path_factory.mktemp("sound")
    assert begun(folder).wait(timeout=PATIENCE) == 0, said(folder)
    return (folder / "small.nc").read_bytes()


def begun(folder, *options, **environment):
    """Start a run of the small study in a folder."""
    study = write_study(folder)
    arguments = ("workflow", "run", study, "--out", str(folder), *OPTIONS, *options)
    return start(folder / "log", *arguments, **environment)


def said(folder):
    """Return what runs in a folder have said."""
    return (folder / "log").read_text()


def wait_for(folder, words, process):
    """Wait until a run has said something."""
    end = time.monotonic() + PATIENCE
    while not re.search(words, said(folder)):
        assert process.poll() is None, said(folder)
        assert time.monotonic() < end, said(folder)
        time.sleep(0.1)


def wait_for_shards(folder, process):
    """Wait until a shard is stored: the rest of a small study is not long in coming."""
    end = time.monotonic() + PATIENCE
    while not list((folder / "store").glob("*.nc")):
        assert process.poll() is None, said(folder)
        assert time.monotonic() < end, said(folder)
        time.sleep(0.01)


def assert_whole(folder, expected):
    """Assert that the result is that of a sound disk, and nothing was damaged."""
    assert (folder / "small.nc").read_bytes() == expected
    assert "Traceback" not in said(folder)
    assert not list(folder.glob("**/*.damaged"))
    assert not list(folder.glob("**/.*.tmp"))


@pytest.mark.parametrize("fault", ["write ENOSPC", "fsync EIO", "open EMFILE", "write ESTALE"])
def test_a_run_waits_for_the_disk_and_ends_with_the_same_bytes(disk, tmp_path, expected, fault):
    run = begun(tmp_path, **disk.environment(f"{fault} {tmp_path / 'store'}/"))
    wait_for_shards(tmp_path, run)
    with disk.failing():
        wait_for(tmp_path, r"cannot be (written|read): .*; tried again for 10\.0 min", run)
        time.sleep(3.0)
    assert run.wait(timeout=PATIENCE) == 0
    assert_whole(tmp_path, expected)


def test_a_full_disk_ends_a_run_in_one_line_and_it_is_resumed(disk, tmp_path, expected):
    rules = disk.environment(f"write ENOSPC {tmp_path}/store")
    run = begun(tmp_path, "--set", "cluster.patience=2", **rules)
    wait_for_shards(tmp_path, run)
    with disk.failing():
        assert run.wait(timeout=PATIENCE) == 2
    last = said(tmp_path).splitlines()[-1]
    assert re.fullmatch(r"error: .*cannot be written: No space left on device; given.*", last)
    assert begun(tmp_path, **rules).wait(timeout=PATIENCE) == 0
    assert_whole(tmp_path, expected)


def test_without_locks_a_run_is_refused_and_with_no_lock_goes_to_its_end(disk, tmp_path, expected):
    rules = disk.environment(f"flock ENOLCK {tmp_path} always")
    assert begun(tmp_path, **rules).wait(timeout=PATIENCE) == 2
    (line,) = said(tmp_path).splitlines()
    assert line.endswith("go on with --no-lock")
    assert begun(tmp_path, "--no-lock", **rules).wait(timeout=PATIENCE) == 0
    assert_whole(tmp_path, expected)


def test_a_file_system_that_flushes_no_folder_is_said_and_serves(disk, tmp_path, expected):
    rules = disk.environment(f"fsyncdir EINVAL {tmp_path} always")
    assert begun(tmp_path, **rules).wait(timeout=PATIENCE) == 0
    assert said(tmp_path).count("flushes no folder") == 1
    assert_whole(tmp_path, expected)


def test_a_result_waits_for_the_disk_too(disk, tmp_path, expected):
    with disk.failing():
        run = begun(tmp_path, **disk.environment(f"write ENOSPC {tmp_path}/.small.nc"))
        wait_for(tmp_path, r"small\.nc: cannot be written: .*; tried again", run)
        time.sleep(3.0)
    assert run.wait(timeout=PATIENCE) == 0
    assert_whole(tmp_path, expected)


def test_a_status_that_cannot_be_written_ends_nothing(disk, tmp_path, expected):
    rules = disk.environment(f"open EIO {tmp_path}/.small.status always")
    assert begun(tmp_path, **rules).wait(timeout=PATIENCE) == 0
    assert said(tmp_path).count("the run goes on") == 1
    assert_whole(tmp_path, expected)


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP], ids=str)
def test_signals_of_batch_systems_and_terminals_keep_what_is_finished(tmp_path, expected, number):
    run = begun(tmp_path, "--set", "study.realizations=4800")  # it cannot end before the signal
    wait_for_shards(tmp_path, run)
    os.kill(run.pid, number)
    assert run.wait(timeout=PATIENCE) == 130
    assert "to resume run again" in said(tmp_path)
    assert begun(tmp_path).wait(timeout=PATIENCE) == 0
    assert_whole(tmp_path, expected)


LOOK = """
import sys
from pathlib import Path
from elastomer_friction.workflow.system import holder
while True:
    holder(Path(sys.argv[1]))
"""


def test_status_beside_a_starting_run_never_makes_it_fail(tmp_path, capsys):
    """The lock is looked at without a pause, by two processes, while it is taken 300 times."""
    store = tmp_path / "store"
    store.mkdir()
    (store / "lock").touch()
    command = [sys.executable, "-c", LOOK, str(store)]
    lookers = [subprocess.Popen(command, cwd=ROOT) for _ in range(2)]
    hold = "from pathlib import Path; from elastomer_friction.workflow.system import hold\n"
    hold += f"for _ in range(300):\n    with hold(Path({str(store)!r})): pass"
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
