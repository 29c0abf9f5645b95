"""The lock of a folder: one holder, who is named, and free again when that process is dead."""

import errno
import fcntl
import os
import re
import signal
import threading

import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.system.lock import LOCK, hold, holder
from tests.support.runs import PATIENCE, standing

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
    with standing(HOLDER, str(tmp_path)) as (process, said):
        assert said == "held"
        yield process


def test_a_second_holder_is_refused_and_told_who_has_it(tmp_path, other, monkeypatch):
    monkeypatch.setattr("elastomer_friction.workflow.system.lock.GLANCE_SECONDS", 0.1)
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


def test_a_file_system_without_locks_is_refused_unless_one_does_without(tmp_path, monkeypatch):
    def no_locks(*_):
        raise OSError(errno.ENOLCK, "No locks available")

    monkeypatch.setattr(fcntl, "flock", no_locks)
    with pytest.raises(UserError) as error, hold(tmp_path):
        pass
    assert str(error.value) == (
        f"{tmp_path}: cannot be locked (No locks available); see to it that no other run uses it, "
        "then go on with --no-lock"
    )
    assert holder(tmp_path) is None
    with hold(tmp_path, without=True):
        assert f"process {os.getpid()} on " in holder(tmp_path)  # it lives


def test_a_folder_that_cannot_be_flushed_is_said_once(tmp_path, monkeypatch, capsys):
    def refuse(_):
        raise OSError(errno.EINVAL, "Invalid argument")

    monkeypatch.setattr(os, "fsync", refuse)
    with hold(tmp_path):
        pass
    said = capsys.readouterr().err
    assert said.startswith(f"note: {tmp_path}: the file system flushes no folder")
    assert said.count("\n") == 1


def test_who_looks_at_the_lock_keeps_nobody_from_it(tmp_path):
    with hold(tmp_path):
        pass
    with (tmp_path / LOCK).open() as file:
        fcntl.flock(file, fcntl.LOCK_SH)
        leave = threading.Timer(0.3, file.close)
        leave.start()
        with hold(tmp_path):
            leave.join()


def test_asking_who_holds_it_makes_nothing(tmp_path):
    assert holder(tmp_path / "store") is None
    assert list(tmp_path.iterdir()) == []


def test_folder_that_cannot_be_made_is_reported(tmp_path):
    (tmp_path / "file").write_text("")
    expected = pytest.raises(UserError, match=r"cannot be used for results: Not a directory$")
    with expected, hold(tmp_path / "file" / "store"):
        pass
