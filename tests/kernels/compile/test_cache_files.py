"""Cached machine code is used if it is intact, and compiled again if not; no fault is fatal."""

import signal
from pathlib import Path
from threading import Thread

import numba
import pytest
from numba.core import event

from elastomer_friction.kernels.compile import cache
from elastomer_friction.kernels.compile.jit import kernel
from tests.sizes import PLAIN_PYTHON
from tests.support.disks import mounted
from tests.support.python import PATIENCE, printed, standing

CACHE_FOLDER = "elastomer_friction.kernels.compile.cache.CACHE_FOLDER"


def twice(x):
    """Return 2 x; a kernel that compiles fast."""
    return 2.0 * x


@pytest.fixture(autouse=True)
def compiled(monkeypatch):
    """Enable compilation under NUMBA_DISABLE_JIT=1 too."""
    monkeypatch.setattr(numba.config, "DISABLE_JIT", 0)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Use an empty cache folder, and return it."""
    monkeypatch.setattr(CACHE_FOLDER, str(tmp_path))
    return tmp_path


def hits():
    """Compile the kernel as a new process does; return the number of cache hits."""
    compiled = kernel(twice)
    assert compiled(21.0) == 42.0
    return sum(compiled.stats.cache_hits.values())


def test_sound_machine_code_is_used(folder):
    assert [hits(), hits()] == [0, 1]


DAMAGE = {
    "empty": lambda content: b"",
    "truncated": lambda content: content[: len(content) // 2],
    "zeros": lambda content: bytes(len(content)),
    "a flipped bit": lambda content: content[:-40] + bytes([content[-40] ^ 1]) + content[-39:],
}


@pytest.mark.parametrize("damage", DAMAGE)
def test_damaged_machine_code_is_made_again(folder, damage):
    hits()
    (path,) = (path for path in folder.rglob("*") if path.is_file())
    path.write_bytes(DAMAGE[damage](path.read_bytes()))
    assert [hits(), hits()] == [0, 1]


def test_a_full_disk_costs_a_warning(tmp_path, monkeypatch):
    with mounted(tmp_path / "disk", "8k") as disk:
        monkeypatch.setattr(CACHE_FOLDER, str(disk))
        for _ in range(2):
            with pytest.warns(RuntimeWarning, match="not cached: .Errno 28. No space left"):
                assert hits() == 0


def test_without_a_folder_kernels_are_compiled_with_a_warning(monkeypatch):
    monkeypatch.setattr(CACHE_FOLDER, "/nowhere/at/all")
    with pytest.warns(RuntimeWarning, match="not cached: .Errno 2. No such file"):
        assert hits() == 0


def test_two_signatures_of_a_kernel_are_both_kept(folder):
    for expected in (0, 2):
        compiled = kernel(twice)
        assert [compiled(21.0), compiled(21)] == [42.0, 42.0]
        assert sum(compiled.stats.cache_hits.values()) == expected


def test_an_edited_source_file_outside_of_the_package_is_compiled_again(folder, tmp_path):
    actual = []
    for factor in (2, 3):
        source = tmp_path / "toy.py"
        source.write_text(f"def scaled(x):\n    return {factor} * x\n")
        names = {"__name__": "toy"}
        exec(compile(source.read_text(), source, "exec"), names)
        actual.append(kernel(names["scaled"])(7.0))
    assert actual == [14.0, 21.0]


def test_functions_that_differ_in_enclosed_variables_are_not_confused(folder):
    assert [kernel(lambda x, k=k: k * x)(1.0) for k in (2.0, 3.0)] == [2.0, 3.0]

    def scaled(factor):
        return kernel(lambda x: factor * x)

    assert [scaled(2.0)(1.0), scaled(3.0)(1.0)] == [2.0, 3.0]


# Compiles the kernel above, but pauses in the compilation until a file appears.
HOLDER = """
import sys, time
from pathlib import Path
from numba.core import event
from elastomer_friction.kernels.compile import cache
from tests.kernels.compile.test_cache_files import kernel, twice

class Slow(event.Listener):
    def on_start(self, event):
        print("compiling", flush=True)
        while not Path(sys.argv[2]).exists():
            time.sleep(0.01)

    def on_end(self, event):
        pass

cache.CACHE_FOLDER = sys.argv[1]
with event.install_listener("numba:compile", Slow()):
    kernel(twice)(21.0)
"""


@pytest.fixture
def holder(folder, tmp_path):
    """Yield a process that compiles the kernel."""
    if PLAIN_PYTHON:
        pytest.skip("NUMBA_DISABLE_JIT=1: nothing compiled")
    with standing(HOLDER, str(folder), str(tmp_path / "go")) as (process, line):
        assert line == "compiling"
        yield process


@pytest.fixture
def waiting(holder):
    """Return (compiling process, thread waiting for the same kernel, cache hits of the thread)."""
    actual = []
    thread = Thread(target=lambda: actual.append(hits()), daemon=True)
    thread.start()
    thread.join(0.3)
    assert thread.is_alive()
    return holder, thread, actual


def test_a_process_waits_for_another_one_and_loads_its_machine_code(waiting, tmp_path):
    _, thread, actual = waiting
    (tmp_path / "go").touch()
    thread.join(PATIENCE)
    assert actual == [1]


def test_a_process_that_dies_while_it_compiles_is_not_waited_for(waiting):
    holder, thread, actual = waiting
    holder.kill()
    thread.join(PATIENCE)
    assert actual == [0]


def test_a_process_that_is_stopped_while_it_compiles_is_not_waited_for_long(holder, monkeypatch):
    monkeypatch.setattr(cache, "LOCK_SECONDS", 0.2)
    holder.send_signal(signal.SIGSTOP)
    assert hits() == 0


def test_other_kernels_are_compiled_meanwhile(holder, monkeypatch):
    monkeypatch.setattr(cache, "LOCK_SECONDS", 1.0)
    with event.install_recorder(cache.WAITING_EVENT) as waits:
        assert kernel(lambda x: x + 1.0)(1.0) == 2.0
    assert waits.buffer == []


def test_machine_code_of_a_wheel_is_used_where_it_lies(folder, tmp_path, monkeypatch):
    hits()
    shipped = Path(folder.rename(tmp_path.with_name("shipped")))
    monkeypatch.setattr(cache, "SHIPPED", shipped)
    tmp_path.mkdir()
    assert hits() == 1
    assert list(tmp_path.iterdir()) == []


LIBRARY_NAMES = ["_finalized", "_finalize_final_module", "_library_class", "_optimize_final_module"]

# Removes a private name of numba, as a later version may do, and calls kernels.
FALLBACK = """
import builtins, sys
missing, usual = sys.argv[1], builtins.hasattr
builtins.hasattr = lambda owner, name: name != missing and usual(owner, name)
from elastomer_friction.kernels.compile import jit
if missing in vars(jit._LinkedLibrary):
    delattr(jit._LinkedLibrary, missing)
if missing == "_library_class":
    from numba.core.codegen import JITCodeLibrary, JITCPUCodegen
    JITCPUCodegen.create_library = lambda codegen, name: JITCodeLibrary(codegen, name)
from tests.kernels.compile.test_jit import PAIR, both, first_of, twice
assert both(PAIR) == (213.0, 1)
assert twice(PAIR) == 426.0
assert first_of(PAIR) == 3.0
print(sum(sum(k.stats.cache_hits.values()) for k in (both, twice, first_of)))
"""


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")
@pytest.mark.parametrize("name", ["", "_cache", "_nrt", *LIBRARY_NAMES])
def test_without_a_private_name_of_numba_kernels_are_compiled_and_cached(tmp_path, name):
    hits = ["0\n"] if name in LIBRARY_NAMES else ["0\n", "3\n"]  # the cache uses other names
    environment = {"NUMBA_CACHE_DIR": str(tmp_path)}
    assert [printed("-c", FALLBACK, name, **environment) for _ in hits] == hits
