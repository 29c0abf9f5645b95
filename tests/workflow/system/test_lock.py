"""The lock of a folder: one holder, who is named, and free again when that process is dead."""

import fcntl
import os
import re
import signal

import pytest

from tests.support.runs import PATIENCE, standing
from workflow.errors import UserError
from workflow.system.lock import hold, holder

HOLDER = """
import sys, time
from pathlib import Path
from workflow.system.lock import hold
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


def test_a_second_holder_is_refused_and_told_who_has_it(tmp_path, other):
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


def test_a_file_system_without_locks_is_warned_of(tmp_path, monkeypatch, capsys):
    def no_locks(*_):
        raise OSError(37, "No locks available")

    monkeypatch.setattr(fcntl, "flock", no_locks)
    with hold(tmp_path):
        pass
    assert "cannot be locked (No locks available)" in capsys.readouterr().err


def test_asking_who_holds_it_makes_nothing(tmp_path):
    assert holder(tmp_path / "store") is None
    assert list(tmp_path.iterdir()) == []


def test_folder_that_cannot_be_made_is_reported(tmp_path):
    (tmp_path / "file").write_text("")
    expected = pytest.raises(UserError, match=r"cannot be used for results: Not a directory$")
    with expected, hold(tmp_path / "file" / "store"):
        pass
