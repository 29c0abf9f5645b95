"""Compilation: where machine code is cached, and that it computes what Python computes."""

import os
import shutil
from pathlib import Path

import numba
import numpy as np
import pytest

from kernels import contact, friction, jit, relaxation, steady
from tests.lines import random_line
from tests.sizes import PLAIN_PYTHON

KERNELS = (
    contact.overlap,
    contact.solve_indentation,
    friction.quadrature,
    friction.lagged_slope,
    friction.step_average,
    relaxation.touchable,
    relaxation.march,
    steady.sweep,
    steady.steady_sliding,
)
compiled_only = pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")


@pytest.fixture
def sources(tmp_path, monkeypatch):
    """Let jit.py believe that the package lives in a copy."""
    copy = tmp_path / "kernels"
    shutil.copytree(Path(jit.__file__).parent, copy, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr(jit, "__file__", str(copy / "jit.py"))
    return copy


def test_hash_is_reproducible_and_independent_of_the_place(sources):
    moved = jit.source_hash()
    assert moved == jit.source_hash()
    assert len(moved) == 16
    int(moved, 16)


@pytest.mark.parametrize("name", ["contact.py", "jit.py", "__init__.py"])
def test_any_edit_opens_a_new_folder(sources, name, monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    before, folder = jit.source_hash(), jit._cache_folder()
    (sources / name).write_text((sources / name).read_text() + "\n# edited\n")
    assert jit.source_hash() != before
    assert jit._cache_folder() != folder


def test_a_renamed_source_opens_a_new_folder(sources):
    before = jit.source_hash()
    (sources / "contact.py").rename(sources / "contact_step.py")
    assert jit.source_hash() != before


def test_cache_folder_is_made_under_the_cache_home(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    folder = Path(jit._cache_folder())
    assert folder.is_dir()
    assert folder == tmp_path / "elastomer-friction" / jit.source_hash()


def test_without_a_cache_home_it_is_a_folder_of_our_own_on_this_machine(monkeypatch, tmp_path):
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(jit.tempfile, "gettempdir", lambda: str(tmp_path))
    folder = Path(jit._cache_folder())
    base = tmp_path / f"elastomer-friction-{os.getuid()}"
    assert folder == base / "elastomer-friction" / jit.source_hash()
    assert base.stat().st_mode & 0o777 == 0o700


def test_machine_code_of_another_user_is_not_run(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(jit.os, "getuid", lambda: 4711)
    folder = Path(jit._cache_folder())
    try:
        assert tmp_path not in folder.parents
    finally:
        folder.rmdir()


def test_a_home_that_cannot_be_written_is_replaced(monkeypatch, tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("not a folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(blocked))
    folder = Path(jit._cache_folder())
    try:
        assert folder.is_dir()
        assert blocked not in folder.parents
    finally:
        folder.rmdir()


@compiled_only
def test_numba_caches_in_that_folder():
    expected = os.environ.get("NUMBA_CACHE_DIR") or jit._cache_folder()
    assert str(numba.config.CACHE_DIR) == expected


@compiled_only
@pytest.mark.parametrize("kernel", KERNELS, ids=lambda k: k.__name__)
def test_kernels_release_the_interpreter(kernel):
    """A scheduler must be able to talk to a worker while a kernel runs."""
    assert kernel.targetoptions["nogil"] is True


@compiled_only
def test_machine_code_computes_what_python_computes():
    z, slope = random_line(61, 0.7, 1, seed=4)
    w, d, sweeps = steady.steady_sliding(z, 3.0, 0.4, 1.0 / 0.6)
    w_plain, d_plain, sweeps_plain = steady.steady_sliding.py_func(z, 3.0, 0.4, 1.0 / 0.6)
    # Only the order of sums may differ by vectorization.
    np.testing.assert_allclose(w, w_plain, rtol=1e-14, atol=1e-14)
    assert d == pytest.approx(d_plain, rel=1e-14)
    assert abs(sweeps - sweeps_plain) <= 1
    found = friction.quadrature(z, slope, w, d, 1.0, 1.1, 3.0)
    plain = friction.quadrature.py_func(z, slope, w, d, 1.0, 1.1, 3.0)
    assert found == pytest.approx(plain, rel=1e-13, abs=1e-13)
