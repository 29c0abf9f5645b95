"""Hash of the code in the key of stored numbers, and machine code before the first batch."""

import ast
import shutil
from pathlib import Path

import numba
import pytest

from elastomer_friction.workflow.simulate.code_hash import (
    CODE_HASH,
    FOLDERS,
    cached_code_hash,
    code_hash,
)
from tests.support.imports import module_of
from tests.support.python import printed

FOLDER = "elastomer_friction.kernels.compile.cache.CACHE_FOLDER"
HASHED = [path for folder in FOLDERS for path in folder.rglob("*.py")]
WORKFLOW = "elastomer_friction.workflow"
BEYOND = (WORKFLOW, "elastomer_friction.studies", "tests")
# Names of this program in hashed files that no number depends on.
FROM_SYSTEM = ("Maker", "keep_memory", "peak_bytes", "this_maker")
NO_NUMBERS = {
    f"{WORKFLOW}.ground.public_names",
    f"{WORKFLOW}.ground.UserError",
    *(f"{WORKFLOW}.system.{name}" for name in FROM_SYSTEM),
}


def imported(path):
    """Return the dotted names that a file imports, inside functions too."""
    names = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names |= {f"{module_of(node, path)}.{alias.name}" for alias in node.names}
    return names


@pytest.mark.parametrize("path", HASHED, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_hashed_files_import_only_hashed_files_of_this_program(path):
    ours = {name for name in imported(path) if name.startswith(BEYOND)}
    assert {n for n in ours if not n.startswith(f"{WORKFLOW}.simulate.")} <= NO_NUMBERS


EDITS = {
    "the steps of a curve": ("recorded_steps.py", "np.linspace", "np.geomspace"),
    "a number": ("rheology/spectrum.py", "1e-10", "1e-11"),
    "an operator": ("kernels/model/steady.py", "w[j] = free", "w[j] = -free"),
    "a body chosen by type": (
        "kelvin.py",
        "@free_displacement.register(Kelvin)",
        "@free_displacement.register(State)",
    ),
    "a default": ("self_affine.py", '= "modal"', '= "integral"'),
    "a flag of the compiler": ("jit.py", '"numpy"', '"python"'),
}
NO_EDITS = {
    "a docstring": (
        "kernels/model/steady.py",
        '"""Steady sliding under',
        '"""Sliding steadily under',
    ),
    "a comment": ("rheology/spectrum.py", "# Shortest step", "# The shortest step"),
    "an empty line": ("tasks.py", "\nclass Problem", "\n\nclass Problem"),
    "brackets": ("recorded_steps.py", "return (steps - ", "return ((steps) - "),
}
EDITED = {name for name, *_ in (EDITS | NO_EDITS).values()}


def copies(folder, ignore):
    """Return copies of the hashed folders without the files to ignore."""
    copied = tuple(folder / hashed.name for hashed in FOLDERS)
    for hashed, copy in zip(FOLDERS, copied, strict=True):
        shutil.copytree(hashed, copy, ignore=ignore)
    return copied


def test_copies_have_the_same_hash(tmp_path):
    assert code_hash(copies(tmp_path, shutil.ignore_patterns("__pycache__"))) == CODE_HASH


def not_edited(folder, names):
    """Return the files of a folder that no test edits: parsing all takes too long."""
    paths = [Path(folder, name) for name in names]
    needed = {p for p in paths if any(p.as_posix().endswith(f"/{name}") for name in EDITED)}
    return {path.name for path in paths if path not in needed and not path.is_dir()}


@pytest.fixture
def copied(tmp_path):
    """Return copies of the hashed folders with only the files that tests edit."""
    return copies(tmp_path, not_edited)


@pytest.fixture
def before(copied):
    """Return the hash of the unchanged copies."""
    return code_hash(copied)


def edited(folders, name, old, new):
    """Replace text in a copied file and return the hash."""
    files = [path for folder in folders for path in folder.rglob("*.py")]
    (path,) = [path for path in files if path.as_posix().endswith(f"/{name}")]
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new), encoding="utf-8")
    return code_hash(folders)


@pytest.mark.parametrize("name", EDITS)
def test_any_edit_of_a_computation_changes_the_hash(copied, before, name):
    assert edited(copied, *EDITS[name]) != before


def test_an_additional_file_changes_the_hash(copied, before):
    (copied[0] / "more.py").write_text("", encoding="utf-8")
    assert code_hash(copied) != before


def test_a_renamed_file_changes_the_hash(copied, before):
    (copied[1] / "recorded_steps.py").rename(copied[1] / "recorded_steps2.py")
    assert code_hash(copied) != before


@pytest.mark.parametrize("name", NO_EDITS)
def test_words_and_layout_do_not_change_the_hash(copied, before, name):
    assert edited(copied, *NO_EDITS[name]) == before


def test_the_hash_is_cached_until_a_byte_changes_or_the_cache_is_damaged(tmp_path, monkeypatch):
    assert cached_code_hash() == code_hash() == CODE_HASH
    folder, cache = tmp_path / "room", tmp_path / "cache"
    for path in (folder, cache):
        path.mkdir()
    monkeypatch.setattr(FOLDER, str(cache))
    source = folder / "a.py"
    for text in ("x = 1\n", "x = 1  # one\n", "x = 2\n"):
        source.write_text(text)
        assert cached_code_hash((folder,)) == cached_code_hash((folder,)) == code_hash((folder,))
    files = list(cache.iterdir())
    assert len(files) == 3
    for spoilt in (b"", b"0123", b"\xff" * 16, b"x" * 16):
        for file in files:
            file.write_bytes(spoilt)
        assert cached_code_hash((folder,)) == code_hash((folder,))
    monkeypatch.setattr(
        "elastomer_friction.kernels.compile.cache.CACHE_FOLDER", str(tmp_path / "nowhere")
    )
    assert cached_code_hash((folder,)) == code_hash((folder,))


NOTHING_NEW = """
import sys, types
from numba.core.dispatcher import Dispatcher
from tests.support.small import cut_batches, small_plan
from elastomer_friction.workflow.simulate.realizations import block_means, load_kernels

def compiled():
    signatures = {}
    for name, module in list(sys.modules.items()):
        if name.startswith("elastomer_friction.kernels"):
            for kernel in vars(module).values():
                if isinstance(kernel, Dispatcher):
                    signatures[kernel.py_func.__qualname__] = len(kernel.signatures)
    return signatures

wide = ["grid.hurst=[0.0, 0.7]", "grid.normal_force=[0.004, 0.04, 0.4, 40.0]",
        "grid.velocity=[0.03, 0.3, 3.0, 30.0]", "study.realizations=8"]
for batch in cut_batches(small_plan(*wide), set(), 1e9):
    load_kernels("foundation", batch.scheme, batch.quantities)
    before = compiled()
    block_means(batch)
    after = compiled()
    assert len(before) > 20
    new = {name for name in after if after[name] != before.get(name)}
    assert not new, new
"""


@pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled")
def test_a_batch_compiles_nothing_after_its_kernels_are_loaded():
    """The time to compile would count as that of the work."""
    printed("-c", NOTHING_NEW)
