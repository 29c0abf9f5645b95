"""Durable files, retries of disk operations, and the lock of a folder."""

import errno
import fcntl
import os
import re
import signal
import threading
from pathlib import Path

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.system.disk_retry import GRACE_SECONDS, DiskRetry
from elastomer_friction.workflow.system.durable_files import (
    append_durably,
    clear_leftovers,
    refused,
    write_durably,
)
from elastomer_friction.workflow.system.lock import LOCK, hold, holder
from tests.support.python import PATIENCE, standing


def full_disk(*_):
    """Fail like a full disk."""
    raise OSError(errno.ENOSPC, "No space left on device")


@pytest.mark.parametrize("error", [FileNotFoundError, FileExistsError])
@pytest.mark.parametrize("done", [True, False])
def test_a_repeated_rename_counts_if_the_file_has_the_content(tmp_path, monkeypatch, error, done):
    path, rename = tmp_path / "shard.npz", Path.replace
    path.write_bytes(b"old")

    def answered_with_an_error(aside, target):
        if done:
            rename(aside, target)
        raise error(errno.ENOENT, "No such file")

    monkeypatch.setattr("pathlib.Path.replace", answered_with_an_error)
    if done:
        write_durably(path, b"new")
    else:
        with pytest.raises(UserError, match=r"shard\.npz: cannot be written: No such file"):
            write_durably(path, b"new")
    assert path.read_bytes() == (b"new" if done else b"old")


def test_append_to_a_full_disk_is_reported(tmp_path, monkeypatch):
    monkeypatch.setattr(os, "fsync", full_disk)
    with pytest.raises(UserError, match=r"journal: cannot be written: No space left on device$"):
        append_durably(tmp_path / "journal", b"line\n")


def test_only_temporary_files_of_the_given_file_are_removed(tmp_path):
    others = [tmp_path / name for name in ("a.nc", "b.tmp", ".b.csv.17.tmp", ".a.nc")]
    for path in (*others, tmp_path / ".a.nc.17.tmp", tmp_path / ".a.nc.4711.tmp"):
        path.touch()
    clear_leftovers(tmp_path / "a.nc")
    assert sorted(tmp_path.iterdir()) == sorted(others)


TEMPORARY_ERRORS = ["EIO", "ESTALE", "EMFILE", "ENFILE", "ENOSPC", "EDQUOT", "ETIMEDOUT"]


class Disk:
    """A disk that fails with an error until a time of the clock."""

    def __init__(self, clock, path, until, error):
        self.clock, self.path, self.until, self.error = clock, path, until, error
        self.attempts = []

    def __call__(self):
        self.attempts.append(self.clock[0])
        with refused(self.path, "cannot be written:"):
            if self.clock[0] < self.until:
                raise self.error
        return "done"


def disk_retry(clock, seconds, stop=lambda: False):
    """Return a DiskRetry that waits by advancing the clock."""

    def sleep(duration):
        clock[0] += duration

    return DiskRetry(seconds, stop, sleep)


def disk_error(name):
    """Return an error of the disk."""
    number = getattr(errno, name)
    return OSError(number, os.strerror(number))


HDF5 = RuntimeError("NetCDF: HDF error")  # without a reason


@pytest.mark.parametrize("error", [*map(disk_error, TEMPORARY_ERRORS), HDF5], ids=str)
def test_temporary_errors_are_retried_with_a_warning_at_once(tmp_path, clock, capsys, error):
    disk = Disk(clock, tmp_path, clock[0] + 20.0, error)
    assert disk_retry(clock, 600.0)(disk) == "done"
    warning = capsys.readouterr().err
    reason = getattr(error, "strerror", str(error))
    message = f"cannot be written: {reason}; tried again for 10.0 min at most"
    assert warning == f"warning: {tmp_path}: {message}\n"
    gaps = np.diff(disk.attempts)
    assert gaps[:4] == pytest.approx([0.1, 0.2, 0.4, 0.8])
    assert max(gaps) <= 10.0 + 1e-9


@pytest.mark.parametrize(
    ("name", "seconds"),
    [("EACCES", 600.0), ("EROFS", 600.0), ("ENOENT", 600.0), ("ENOTDIR", 600.0), ("EIO", 0.0)],
)
def test_permanent_errors_are_not_retried(tmp_path, clock, capsys, name, seconds):
    """A time limit of zero allows no retry either."""
    disk = Disk(clock, tmp_path, clock[0] + 1.0, disk_error(name))
    with pytest.raises(UserError, match=f"cannot be written: {disk_error(name).strerror}$"):
        disk_retry(clock, seconds)(disk)
    assert len(disk.attempts) == 1
    assert capsys.readouterr().err == ""


def test_after_giving_up_operations_are_tried_once_until_the_disk_is_back(tmp_path, clock, capsys):
    began, retry = clock[0], disk_retry(clock, 300.0)
    with pytest.raises(UserError, match=r"No space left on device; given up after 5\.0 min$"):
        retry(Disk(clock, tmp_path, began + 1e6, disk_error("ENOSPC")))
    assert clock[0] - began == pytest.approx(300.0)
    assert capsys.readouterr().err.count("\n") == 5  # at once, after 30, 60, 120 and 240 s
    disk = Disk(clock, tmp_path, began + 1e6, disk_error("ENOSPC"))
    with pytest.raises(UserError):
        retry(disk)
    assert len(disk.attempts) == 1
    assert retry(lambda: "done") == "done"
    assert retry(Disk(clock, tmp_path, clock[0] + 20.0, disk_error("ENOSPC"))) == "done"


def test_a_process_that_is_to_stop_retries_for_a_short_time(tmp_path, clock):
    began = clock[0]
    retry = disk_retry(clock, 600.0, lambda: clock[0] > began + 40.0)
    with pytest.raises(UserError, match="given up after"):
        retry(Disk(clock, tmp_path, began + 1e6, disk_error("EIO")))
    assert clock[0] - began < 40.0 + GRACE_SECONDS + 1.0


HOLDER = """
import sys, time
from pathlib import Path
from elastomer_friction.workflow.system.lock import hold
with hold(Path(sys.argv[1])):
    print("held", flush=True)
    time.sleep(600)
"""


@pytest.fixture
def other(tmp_path):
    """Return another process that holds the lock of tmp_path."""
    with standing(HOLDER, str(tmp_path)) as (process, line):
        assert line == "held"
        yield process


def test_a_second_holder_is_refused_with_the_name_of_the_first(tmp_path, other, monkeypatch):
    monkeypatch.setattr("elastomer_friction.workflow.system.lock.PROBE_SECONDS", 0.1)
    who = rf"process {other.pid} on \S+ since \d{{4}}-\d\d-\d\d \d\d:\d\d:\d\d\S+"
    line = rf"{re.escape(str(tmp_path))}: in use by {who}; one run at a time"
    with pytest.raises(UserError) as error, hold(tmp_path):
        pass
    assert re.fullmatch(line, str(error.value))
    assert re.fullmatch(who, holder(tmp_path))


def test_the_lock_dies_with_its_holder_and_is_free_after_an_error(tmp_path, other):
    other.send_signal(signal.SIGKILL)
    other.wait(timeout=PATIENCE)
    assert holder(tmp_path) is None
    with hold(tmp_path):
        assert f"process {os.getpid()} on " in holder(tmp_path)
    with pytest.raises(KeyError), hold(tmp_path):
        raise KeyError
    assert holder(tmp_path) is None


def test_a_file_system_without_locks_is_refused_by_default(tmp_path, monkeypatch):
    def no_locks(*_):
        raise OSError(errno.ENOLCK, "No locks available")

    monkeypatch.setattr(fcntl, "flock", no_locks)
    with pytest.raises(UserError) as error, hold(tmp_path):
        pass
    assert str(error.value) == (
        f"{tmp_path}: cannot be locked (No locks available); make sure that no other run uses it, "
        "then add --no-lock"
    )
    assert holder(tmp_path) is None
    with hold(tmp_path, without=True):
        assert f"process {os.getpid()} on " in holder(tmp_path)


def test_a_folder_that_cannot_be_flushed_is_noted_once(tmp_path, monkeypatch, capsys):
    def refuse(_):
        raise OSError(errno.EINVAL, "Invalid argument")

    monkeypatch.setattr(os, "fsync", refuse)
    with hold(tmp_path):
        pass
    note = capsys.readouterr().err
    assert note.startswith(f"note: {tmp_path}: the file system cannot flush a folder")
    assert note.count("\n") == 1


def test_probing_the_lock_does_not_prevent_its_acquisition(tmp_path, monkeypatch):
    monkeypatch.setattr("elastomer_friction.workflow.system.lock.PROBE_SECONDS", PATIENCE)
    with hold(tmp_path):
        pass
    with (tmp_path / LOCK).open() as file:
        fcntl.flock(file, fcntl.LOCK_SH)
        leave = threading.Timer(0.3, file.close)
        leave.start()
        with hold(tmp_path):
            leave.join()


def test_probing_the_lock_creates_no_file(tmp_path):
    assert holder(tmp_path / "store") is None
    assert list(tmp_path.iterdir()) == []


def test_folder_that_cannot_be_made_is_reported(tmp_path):
    (tmp_path / "file").write_text("")
    expected = pytest.raises(UserError, match=r"cannot be used for results: Not a directory$")
    with expected, hold(tmp_path / "file" / "store"):
        pass
