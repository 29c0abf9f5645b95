"""Where machine code is cached: a folder per state of all sources, of our own."""

import os
import shutil
from pathlib import Path

import numba
import pytest

from kernels import cache, march
from kernels.jit import kernel
from tests.sizes import PLAIN_PYTHON

HASH = cache.source_hash()


@pytest.fixture
def sources(tmp_path, monkeypatch):
    """Let cache.py believe that the package lives in a copy."""
    copy = tmp_path / "kernels"
    shutil.copytree(Path(cache.__file__).parent, copy, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr(cache, "__file__", str(copy / "cache.py"))
    return copy


@pytest.fixture
def home(tmp_path, monkeypatch):
    """Return the home of caches."""
    folder = tmp_path / "home"
    monkeypatch.setenv("XDG_CACHE_HOME", str(folder))
    return folder


def test_hash_does_not_depend_on_the_place(sources):
    assert cache.source_hash() == HASH
    assert len(HASH) == 16
    int(HASH, 16)


def edited(path):
    """Add a line to a file."""
    path.write_text(path.read_text() + "\n# edited\n")


EDITS = {
    "a file": lambda top: edited(top / "contact.py"),
    "a file of a room": lambda top: edited(top / "rheology" / "kelvin.py"),
    "the list of a room": lambda top: edited(top / "motion" / "__init__.py"),
    "a name": lambda top: (top / "contact.py").rename(top / "contact_step.py"),
    "the name of a room": lambda top: (top / "motion").rename(top / "motions"),
    "a new file": lambda top: (top / "rheology" / "maxwell.py").write_text("a = 1\n"),
}


@pytest.mark.parametrize("edit", EDITS)
def test_any_edit_opens_a_new_folder(sources, edit, home):
    folder = cache._cache_folder()
    EDITS[edit](sources)
    assert cache.source_hash() != HASH
    assert cache._cache_folder() != folder


def test_cache_folder_is_made_under_the_cache_home(home):
    folder = Path(cache._cache_folder())
    assert folder.is_dir()
    assert folder == home / "elastomer-friction" / HASH


def test_without_a_cache_home_it_is_a_folder_of_our_own_on_this_machine(monkeypatch, tmp_path):
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(cache.tempfile, "gettempdir", lambda: str(tmp_path))
    base = tmp_path / f"elastomer-friction-{os.getuid()}"
    assert Path(cache._cache_folder()) == base / "elastomer-friction" / HASH
    assert base.stat().st_mode & 0o777 == 0o700


@pytest.mark.parametrize("blocked", ["by a file", "by another user"])
def test_a_home_that_is_not_ours_to_write_is_replaced(monkeypatch, home, blocked):
    """Machine code of another user is not run."""
    if blocked == "by a file":
        home.write_text("not a folder")
    else:
        monkeypatch.setattr(cache.os, "getuid", lambda: 4711)
    folder = Path(cache._cache_folder())
    assert home not in folder.parents
    folder.rmdir()


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")
def test_numba_caches_in_that_folder_whatever_it_forgets(monkeypatch):
    assert (os.environ.get("NUMBA_CACHE_DIR") or cache._cache_folder()) == cache.FOLDER
    monkeypatch.setenv("NUMBA_ANYTHING", "1")
    numba.config.reload_config()
    late = kernel(test_hash_does_not_depend_on_the_place)
    assert {Path(k._cache.cache_path).parent for k in (march, late)} == {Path(cache.FOLDER)}
