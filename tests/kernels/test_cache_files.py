"""Machine code on disk: used when it is sound, made again when it is not, never fatal."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.sizes import PLAIN_PYTHON

pytestmark = pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")
ROOT = Path(__file__).resolve().parents[2]
SCRIPT = """
import numpy as np
from kernels import contact
d = contact.solve_indentation(np.array([0.0, 0.5, 1.0]), 1.0, 0.0)
print(d, sum(contact.solve_indentation.stats.cache_hits.values()))
"""


def solve(folder, *options):
    """Solve in a new process with its cache in ``folder``: (numbers, hits of the cache), stderr."""
    process = subprocess.run(
        [sys.executable, *options, "-c", SCRIPT],
        cwd=ROOT,
        env={**os.environ, "NUMBA_CACHE_DIR": str(folder)},
        capture_output=True,
        text=True,
        check=True,
    )
    *found, hits = process.stdout.rsplit(maxsplit=1)
    return found, int(hits), process.stderr


@pytest.fixture(scope="module")
def cold(tmp_path_factory):
    """Return a folder with machine code, and what the process that made it found."""
    folder = tmp_path_factory.mktemp("cache")
    found, hits, _ = solve(folder)
    assert hits == 0
    return folder, found


def files(folder, suffix):
    """Return the files of a cache with a suffix; there are some."""
    found = sorted(folder.rglob(f"*{suffix}"))
    assert found
    return found


def test_sound_machine_code_is_used(cold):
    assert solve(cold[0]) == (cold[1], 1, "")


LAW = """
from typing import NamedTuple
from kernels.rheology.law import reach

class Squared(NamedTuple):
    root: float  # of the decay
    stiffness: float
    lag: float

@reach.of(Squared)
def _reach(law, u):
    return law.root * (law.root * u)
"""
EVERY = """
import sys
import numpy as np
from numba.core.dispatcher import Dispatcher
from kernels import ConstantForce, Kelvin, PrintedForce, State, march, steady_sliding
from kernels.steady import sweep
from law_of_another_file import Squared
z = 1.0 + np.cos(0.3 * np.arange(40))
for law in (Kelvin(0.25, 4.0 / 3.0, 0.5), Squared(0.5, 4.0 / 3.0, 0.5)):
    state, _ = steady_sliding(law, z, 4.0)
    sweep(law, z, state.d, 10, state.w)
    start = State(0.5 * state.w, state.d)  # it has to settle
    for control in (ConstantForce, PrintedForce)[: 2 if law[0] == 0.25 else 1]:
        mu, *_ = march(law, control(4.0), z, np.sin(z), start, np.array([2]), 3.0)
        print(state.d.hex(), float(mu[0]).hex())
modules = [module for name, module in sys.modules.items() if name.startswith("kernels")]
found = {id(v): v for m in modules for v in vars(m).values() if isinstance(v, Dispatcher)}
print(sum(sum(kernel.stats.cache_misses.values()) for kernel in found.values()))
print(sum(len(kernel.stats.cache_hits) for kernel in (steady_sliding, sweep, march)))
"""


def test_a_second_process_compiles_nothing_whatever_the_law_and_the_control(tmp_path):
    """Also a law of a new file, which no file of kernels knows; its numbers are Kelvin's."""
    (tmp_path / "law_of_another_file.py").write_text(LAW)
    path = os.pathsep.join([str(tmp_path), str(ROOT)])
    environment = {**os.environ, "PYTHONPATH": path, "NUMBA_CACHE_DIR": str(tmp_path / "cache")}
    command = [sys.executable, "-c", EVERY]
    first, second = (
        subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        for _ in range(2)
    )
    *numbers, misses, hits = first.stdout.splitlines()
    assert int(misses) > 8
    assert int(hits) == 0
    assert numbers[0] == numbers[2]  # Kelvin under a constant force, and the other law
    assert numbers[0] != numbers[1]
    assert second.stdout.splitlines() == [*numbers, "0", "7"]


TOGETHER = """
from kernels import contact
from kernels.cache import compiling
import numpy as np
with compiling():
    contact.solve_indentation(np.array([0.0, 0.5, 1.0]), 1.0, 0.0)
print(sum(contact.solve_indentation.stats.cache_misses.values()))
"""


def test_of_many_processes_of_a_machine_one_compiles(tmp_path):
    processes = [
        subprocess.Popen(
            [sys.executable, "-c", TOGETHER],
            cwd=ROOT,
            env={**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)},
            stdout=subprocess.PIPE,
            text=True,
        )
        for _ in range(4)
    ]
    misses = [int(process.communicate()[0]) for process in processes]
    assert sorted(misses) == [0, 0, 0, 1]


DAMAGE = {
    "empty": lambda content: b"",
    "truncated": lambda content: content[: len(content) // 2],
    "zeros": lambda content: bytes(len(content)),
    "a flipped bit": lambda content: content[:-40] + bytes([content[-40] ^ 1]) + content[-39:],
}


@pytest.mark.parametrize(
    ("suffix", "damage"),
    [
        (".nbi", "truncated"),
        (".nbi", "zeros"),
        (".nbc", "empty"),
        (".nbc", "truncated"),
        (".nbc", "a flipped bit"),
    ],
)
def test_damaged_machine_code_is_made_again(cold, suffix, damage):
    folder, found = cold
    for path in files(folder, suffix):
        path.write_bytes(DAMAGE[damage](path.read_bytes()))
    assert solve(folder) == (found, 0, "")
    assert solve(folder) == (found, 1, "")


@pytest.fixture
def small_disk(tmp_path):
    """Return a folder on a disk of 16 KiB."""
    mount = ["mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", str(tmp_path)]
    if subprocess.run(mount, capture_output=True).returncode:
        pytest.skip("this process may not mount a small disk")
    yield tmp_path
    subprocess.run(["umount", str(tmp_path)], check=True)


def test_a_full_disk_costs_a_warning(cold, small_disk):
    found, hits, errors = solve(small_disk, "-W", "default")
    assert (found, hits) == (cold[1], 0)
    assert "machine code is not cached: [Errno 28] No space left on device" in errors
    assert solve(small_disk)[:2] == (found, 0)
