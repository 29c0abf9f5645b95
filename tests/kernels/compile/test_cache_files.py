"""Machine code on disk: used when it is sound, made again when it is not, never fatal."""

import contextlib
import fcntl
import itertools
import signal
import time
from concurrent.futures import ThreadPoolExecutor
from threading import Thread

import numba
import pytest

from elastomer_friction.kernels.compile.cache import (
    CheckedCache,
    _CheckedFile,
    compile_in_turn,
    take_turn,
)
from elastomer_friction.kernels.compile.jit import kernel
from tests.support.disks import mounted
from tests.support.python import PATIENCE, standing


def twice(x):
    """A kernel that is compiled in no time."""
    return 2.0 * x


@pytest.fixture(autouse=True)
def compiled(monkeypatch):
    """Compile under NUMBA_DISABLE_JIT=1 too."""
    monkeypatch.setattr(numba.config, "DISABLE_JIT", 0)


@pytest.fixture
def cache(tmp_path, monkeypatch):
    """Let machine code be kept in an empty folder."""
    monkeypatch.setattr("elastomer_friction.kernels.compile.cache.CACHE_FOLDER", str(tmp_path))
    return tmp_path


def hits():
    """Compile the kernel as a new process does; return how often machine code was found."""
    compiled = kernel(twice)
    assert compiled(21.0) == 42.0
    return sum(compiled.stats.cache_hits.values())


def test_sound_machine_code_is_used(cache):
    assert [hits(), hits()] == [0, 1]


DAMAGE = {
    "empty": lambda content: b"",
    "truncated": lambda content: content[: len(content) // 2],
    "zeros": lambda content: bytes(len(content)),
    "a flipped bit": lambda content: content[:-40] + bytes([content[-40] ^ 1]) + content[-39:],
}


@pytest.mark.parametrize(
    ("suffix", "damage"),
    # What a flipped bit does to an index depends on where it falls.
    [*itertools.product([".nbi", ".nbc"], list(DAMAGE)[:3]), (".nbc", "a flipped bit")],
)
def test_damaged_machine_code_is_made_again(cache, suffix, damage):
    hits()
    (path,) = cache.rglob(f"*{suffix}")
    path.write_bytes(DAMAGE[damage](path.read_bytes()))
    assert [hits(), hits()] == [0, 1]


def test_a_full_disk_costs_a_warning(tmp_path, monkeypatch):
    with mounted(tmp_path / "disk", "8k") as disk:
        monkeypatch.setattr("elastomer_friction.kernels.compile.cache.CACHE_FOLDER", str(disk))
        for _ in range(2):
            with pytest.warns(RuntimeWarning, match="not cached: .Errno 28. No space left"):
                assert hits() == 0


def test_two_that_keep_machine_code_at_once_lose_none(cache, monkeypatch):
    save, save_index, kept = CheckedCache.save_overload, _CheckedFile._save_index, []
    monkeypatch.setattr(CheckedCache, "save_overload", lambda *version: kept.append(version))
    assert [kernel(twice)(21.0), kernel(twice)(21)] == [42.0, 42.0]

    def late(file, overloads):
        time.sleep(0.2)  # time enough for the other to read the index as it is now
        save_index(file, overloads)

    monkeypatch.setattr(_CheckedFile, "_save_index", late)
    with ThreadPoolExecutor() as threads:
        list(threads.map(lambda version: save(*version), kept))
    again = kernel(twice)
    assert [again(21.0), again(21)] == [42.0, 42.0]
    assert sum(again.stats.cache_hits.values()) == 2


def test_one_process_of_a_machine_at_a_time_compiles(cache):
    with (cache / "lock").open("w") as other:
        with compile_in_turn():
            assert hits() == 0
            with pytest.raises(BlockingIOError):
                fcntl.flock(other, fcntl.LOCK_EX | fcntl.LOCK_NB)
        fcntl.flock(other, fcntl.LOCK_EX | fcntl.LOCK_NB)


def test_who_finds_all_machine_code_waits_for_nobody(cache):
    hits()
    with (cache / "lock").open("w") as other:
        fcntl.flock(other, fcntl.LOCK_EX | fcntl.LOCK_NB)
        with compile_in_turn():
            assert hits() == 1


def test_who_has_waited_finds_what_the_other_has_compiled(cache, monkeypatch):
    """What is missing is looked for again, now that the other one is done."""

    def other_compiles(name):
        monkeypatch.undo()
        monkeypatch.setattr("elastomer_friction.kernels.compile.cache.CACHE_FOLDER", str(cache))
        monkeypatch.setattr(numba.config, "DISABLE_JIT", 0)
        assert (name, hits()) == ("lock", 0)
        return contextlib.nullcontext()

    monkeypatch.setattr("elastomer_friction.kernels.compile.cache._one_process", other_compiles)
    with compile_in_turn():
        assert hits() == 1


HOLDER = """
import sys, time
from elastomer_friction.kernels.compile import cache
cache.CACHE_FOLDER = sys.argv[1]
with cache.compile_in_turn():
    cache.take_turn()
    print("holds it", flush=True)
    time.sleep(600)
"""


def test_a_process_that_was_stopped_while_it_compiled_is_not_waited_for(cache):
    """As long as it runs, it is."""

    def compile_too():
        with compile_in_turn():
            take_turn()

    with standing(HOLDER, str(cache)) as (holder, _):
        waiting = Thread(target=compile_too, daemon=True)
        waiting.start()
        waiting.join(0.2)
        assert waiting.is_alive()
        holder.send_signal(signal.SIGSTOP)
        waiting.join(PATIENCE)
        assert not waiting.is_alive()


def test_without_a_folder_to_lock_each_compiles_for_itself(monkeypatch):
    monkeypatch.setattr("elastomer_friction.kernels.compile.cache.CACHE_FOLDER", "/nowhere/at/all")
    with compile_in_turn():
        assert take_turn()
        assert not take_turn()
