"""Files are written whole or not at all, and a disk that refuses is reported."""

import errno
import os

import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.system.durable import (
    append_durably,
    clear_leftovers,
    write_durably,
)


def full_disk(*_):
    """Fail like a full disk."""
    raise OSError(errno.ENOSPC, "No space left on device")


def test_failure_leaves_the_old_file_as_it_was(tmp_path, monkeypatch):
    path = tmp_path / "shard.nc"
    write_durably(path, b"old")
    monkeypatch.setattr("pathlib.Path.replace", full_disk)
    with pytest.raises(UserError, match=r"shard\.nc: cannot be written: No space left"):
        write_durably(path, b"new")
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


def test_file_is_flushed_before_it_gets_its_name(tmp_path, monkeypatch):
    path = tmp_path / "shard.nc"
    seen = []
    monkeypatch.setattr(os, "fsync", lambda _: seen.append(path.exists()))
    write_durably(path, b"content")
    assert seen == [False, True]  # the file, then its folder


def test_what_is_appended_is_flushed(tmp_path, monkeypatch):
    path = tmp_path / "journal"
    seen = []
    monkeypatch.setattr(os, "fsync", lambda _: seen.append(path.read_bytes()))
    append_durably(path, b"one\n")
    append_durably(path, b"two\n")
    assert seen == [b"one\n"] * 2 + [b"one\ntwo\n"] * 2


def test_append_to_a_full_disk_is_reported(tmp_path, monkeypatch):
    monkeypatch.setattr(os, "fsync", full_disk)
    with pytest.raises(UserError, match=r"journal: cannot be written: No space left on device$"):
        append_durably(tmp_path / "journal", b"line\n")


def test_leftovers_of_one_file_are_removed_and_nothing_else(tmp_path):
    kept = [tmp_path / name for name in ("a.nc", "b.tmp", ".b.csv.17.tmp", ".a.nc")]
    for path in (*kept, tmp_path / ".a.nc.17.tmp", tmp_path / ".a.nc.4711.tmp"):
        path.touch()
    clear_leftovers(tmp_path / "a.nc")
    assert sorted(tmp_path.iterdir()) == sorted(kept)
