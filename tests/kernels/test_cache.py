"""Where machine code is cached: a folder per state of all sources, of our own."""

import os
import shutil
from pathlib import Path

import numba
import pytest

from kernels import cache
from tests.sizes import PLAIN_PYTHON

HASH = cache.source_hash()


@pytest.fixture
def sources(tmp_path, monkeypatch):
    """Let cache.py believe that the package lives in a copy."""
    copy = tmp_path / "kernels"
    shutil.copytree(Path(cache.__file__).parent, copy, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr(cache, "__file__", str(copy / "cache.py"))
    return copy


def test_hash_does_not_depend_on_the_place(sources):
    assert cache.source_hash() == HASH
    assert len(HASH) == 16
    int(HASH, 16)


def test_an_edit_in_a_room_opens_a_new_folder_and_so_does_a_move_between_rooms(sources):
    (sources / "room").mkdir()
    (sources / "room" / "law.py").write_text("a = 1\n")
    added = cache.source_hash()
    (sources / "room" / "law.py").write_text("a = 2\n")
    edited = cache.source_hash()
    (sources / "room").rename(sources / "rooms")
    assert len({HASH, added, edited, cache.source_hash()}) == 4


@pytest.mark.parametrize("name", ["contact.py", "rheology/kelvin.py", "motion/__init__.py"])
def test_any_edit_opens_a_new_folder(sources, name, monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    before, folder = cache.source_hash(), cache._cache_folder()
    (sources / name).write_text((sources / name).read_text() + "\n# edited\n")
    assert cache.source_hash() != before
    assert cache._cache_folder() != folder


def test_a_renamed_source_opens_a_new_folder(sources):
    before = cache.source_hash()
    (sources / "contact.py").rename(sources / "contact_step.py")
    assert cache.source_hash() != before


def test_cache_folder_is_made_under_the_cache_home(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    folder = Path(cache._cache_folder())
    assert folder.is_dir()
    assert folder == tmp_path / "elastomer-friction" / cache.source_hash()


def test_without_a_cache_home_it_is_a_folder_of_our_own_on_this_machine(monkeypatch, tmp_path):
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(cache.tempfile, "gettempdir", lambda: str(tmp_path))
    folder = Path(cache._cache_folder())
    base = tmp_path / f"elastomer-friction-{os.getuid()}"
    assert folder == base / "elastomer-friction" / cache.source_hash()
    assert base.stat().st_mode & 0o777 == 0o700


def test_machine_code_of_another_user_is_not_run(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(cache.os, "getuid", lambda: 4711)
    folder = Path(cache._cache_folder())
    try:
        assert tmp_path not in folder.parents
    finally:
        folder.rmdir()


def test_a_home_that_cannot_be_written_is_replaced(monkeypatch, tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("not a folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(blocked))
    folder = Path(cache._cache_folder())
    try:
        assert folder.is_dir()
        assert blocked not in folder.parents
    finally:
        folder.rmdir()


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")
def test_numba_caches_in_that_folder():
    expected = os.environ.get("NUMBA_CACHE_DIR") or cache._cache_folder()
    assert str(numba.config.CACHE_DIR) == expected
