"""Folder of cached machine code: one per version of the sources, private to the user."""

import os
import shutil
from pathlib import Path
from types import SimpleNamespace

import numba
import pytest

from elastomer_friction.kernels.compile import cache

HASH = cache.source_hash()


@pytest.fixture
def sources(tmp_path, monkeypatch):
    """Make cache.py use a copy of the package, and return the folder of the copy."""
    copy = tmp_path / "kernels"
    shutil.copytree(
        Path(cache.__file__).parents[1], copy, ignore=shutil.ignore_patterns("__pycache__")
    )
    monkeypatch.setattr(cache, "__file__", str(copy / "compile" / "cache.py"))
    return copy


@pytest.fixture
def home(tmp_path, monkeypatch):
    """Set XDG_CACHE_HOME to a folder that does not exist yet, and return it."""
    folder = tmp_path / "home"
    monkeypatch.delenv("NUMBA_CACHE_DIR", raising=False)
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
    "a file": lambda top: edited(top / "loading.py"),
    "a file of a room": lambda top: edited(top / "rheology" / "kelvin.py"),
    "the list of a room": lambda top: edited(top / "motion" / "__init__.py"),
    "a name": lambda top: (top / "loading.py").rename(top / "load.py"),
    "the name of a room": lambda top: (top / "motion").rename(top / "motions"),
    "a new file": lambda top: (top / "rheology" / "maxwell.py").write_text("a = 1\n"),
}


@pytest.mark.parametrize("edit", EDITS)
def test_any_edit_opens_a_new_folder(sources, edit, home):
    folder = cache.cache_folder()
    EDITS[edit](sources)
    assert cache.source_hash() != HASH
    assert cache.cache_folder() != folder


def test_cache_folder_is_made_under_the_cache_home_for_us_alone(home):
    folder = Path(cache.cache_folder())
    assert folder == home / "elastomer-friction" / HASH
    assert {path.stat().st_mode & 0o777 for path in (folder, folder.parent, home)} == {0o700}


def test_a_folder_of_numba_s_own_variable_is_preferred(home, monkeypatch, tmp_path):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "numba"))
    assert Path(cache.cache_folder()) == tmp_path / "numba" / "elastomer-friction" / HASH


def test_without_a_cache_home_it_is_a_folder_of_our_own_on_this_machine(
    home, monkeypatch, tmp_path
):
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setattr(cache.tempfile, "gettempdir", lambda: str(tmp_path))
    base = tmp_path / f"elastomer-friction-{os.getuid()}"
    assert Path(cache.cache_folder()) == base / "elastomer-friction" / HASH
    assert base.stat().st_mode & 0o777 == 0o700


@pytest.fixture
def shipped(tmp_path, monkeypatch):
    """Simulate an installation from a wheel with machine code."""
    (tmp_path / "shipped" / cache.COMPILER).mkdir(parents=True)
    monkeypatch.setattr(cache, "SHIPPED", tmp_path / "shipped")


LEFT = {"": cache.V3, "a user's choice": "generic", "fma": None, "another numba": None}


@pytest.mark.parametrize("lacking", LEFT)
def test_machine_code_of_a_wheel_serves_who_has_that_processor_and_numba(
    shipped, monkeypatch, lacking
):
    for name in ("NUMBA_CPU_NAME", "NUMBA_CPU_FEATURES"):
        monkeypatch.setenv(name, "generic")  # so that the variable is restored after this test
        if lacking != "a user's choice":
            del os.environ[name]
    monkeypatch.setattr(numba.config, "reload_config", lambda: None)
    monkeypatch.setattr(cache, "COMPILER", "numba0" if "numba" in lacking else cache.COMPILER)
    features = {name: name != lacking for name in cache.V3_FEATURES}
    monkeypatch.setattr(cache, "get_host_cpu_features", lambda: features)
    cache.select_processor()
    assert os.environ.get("NUMBA_CPU_NAME") == LEFT[lacking]
    monkeypatch.setattr(cache, "get_host_cpu_features", dict)  # as on a node without these features
    cache.select_processor()
    assert os.environ.get("NUMBA_CPU_NAME") != cache.V3


def open_to_the_group(home):
    """Create a home and a cache folder with group write access, as umask 002 does."""
    folder = home / "elastomer-friction"
    folder.mkdir(parents=True)
    (folder / "planted").write_text("who knows what")
    for path in (home, folder):
        path.chmod(0o775)
    return folder


def linked(home):
    """Make the home a link, as if it were on another disk."""
    real = home.with_name("real")
    real.mkdir(mode=0o755)
    home.symlink_to(real)
    return real / "elastomer-friction"


def linked_within(home):
    """Make the cache folder in the home a link."""
    real = home.with_name("real")
    real.mkdir(mode=0o755)
    home.mkdir()
    (home / "elastomer-friction").symlink_to(real)
    return real


@pytest.mark.parametrize("made", [open_to_the_group, linked, linked_within])
def test_usual_homes_work_and_the_folder_is_ours_alone_from_then_on(home, made):
    folder = made(home)
    previous = os.umask(0o002)
    try:
        assert Path(cache.cache_folder()) == folder / HASH
    finally:
        os.umask(previous)
    assert folder.stat().st_mode & 0o777 == 0o700
    assert [path.name for path in folder.iterdir()] == [HASH]


def made(folder, mode=0o755, owner=-1):
    """Create a folder with a mode and an owner; return it."""
    folder.mkdir()
    folder.chmod(mode)
    os.chown(folder, owner, -1)
    return folder


OTHER_USER = 54321
# The owner of a sticky folder may rename folders in it.
UNSAFE = {
    "a file": lambda home: home.write_text("not a folder"),
    "open to all": lambda home: made(home, 0o777),
    "in a folder open to all": lambda home: made(home).parent.chmod(0o777),
    "a link to a folder open to all": lambda home: home.symlink_to(
        made(home.with_name("real"), 0o777)
    ),
    "of another user": lambda home: made(home, owner=OTHER_USER),
    "sticky, of another user": lambda home: made(home, 0o1777, OTHER_USER),
    "sticky, with our folder of another user": lambda home: made(
        made(home, 0o1777) / cache.CACHE_NAME, owner=OTHER_USER
    ),
}


@pytest.mark.parametrize("spoil", UNSAFE)
def test_machine_code_of_others_is_not_run(home, monkeypatch, capsys, spoil):
    """A private folder is used instead, with one line on stderr; child processes use it too."""
    if "user" in spoil and os.getuid() != 0:
        pytest.skip("only root can give a folder away")
    UNSAFE[spoil](home)
    monkeypatch.setattr(cache.atexit, "register", lambda *_, **__: None)
    folder = Path(cache.cache_folder())
    private = folder.parents[1]
    assert home.parent not in folder.parents
    assert private.stat().st_mode & 0o777 == 0o700
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith(f"machine code is kept for this run alone: {home.parent}")
    assert Path(cache.cache_folder()) == folder  # as in a child process
    assert capsys.readouterr().err == ""
    os.environ.pop("NUMBA_CACHE_DIR")
    shutil.rmtree(private)


@pytest.mark.skipif(os.getuid() != 0, reason="only root can give a folder away")
def test_temporary_files_in_a_folder_of_another_user_are_no_place_for_it(
    home, monkeypatch, tmp_path
):
    UNSAFE["sticky, of another user"](home)
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setattr(cache.tempfile, "tempdir", str(home))
    private = Path(cache.cache_folder()).parents[1]
    assert home not in private.parents
    assert list(home.glob(f"{cache.CACHE_NAME}-[!0]*")) == []
    os.environ.pop("NUMBA_CACHE_DIR")


@pytest.mark.parametrize("setting", cache.CODE_SETTINGS)
def test_machine_code_of_other_settings_of_numba_is_another_file(monkeypatch, setting):
    codegen = SimpleNamespace(magic_tuple=lambda: ("a processor",))
    kernel = cache.KernelCache(edited)
    name = kernel._file_name("a signature", codegen)
    monkeypatch.setattr(numba.config, setting, 7)
    assert kernel._file_name("a signature", codegen) != name
