"""All machine code is there after loading; a second process compiles half of it."""

import signal
import subprocess
from pathlib import Path

import numba
import pytest
from numba.core import event

from elastomer_friction.kernels import Quantities, loading
from elastomer_friction.kernels.compile.cache import WAITING_EVENT
from tests.sizes import PLAIN_PYTHON
from tests.support.python import printed

ROOT = Path(__file__).resolve().parents[2]
compiled_only = pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")

HALF = """
import sys
from elastomer_friction.kernels import Quantities, loading
from elastomer_friction.kernels.quick.march.active import active_march
from elastomer_friction.kernels.quick.relaxation import plain_relaxations
from elastomer_friction.kernels.quick.steady.spans import add_rises
from elastomer_friction.kernels.quick.steady.stack import stack_of

rate = sys.argv[1] == "1"
own = plain_relaxations, add_rises, stack_of, *([active_march] if rate else [])
loading.load_half("exponential", rate)
before = [kernel.signatures[:] for kernel in own]
assert [len(signatures) for signatures in before] == [1] * len(own), before
loading.load("implicit-euler", Quantities(indentation_rate=rate))
assert [kernel.signatures[:] for kernel in own] == before
"""


@compiled_only
@pytest.mark.parametrize("rate", ["1", "0"])
def test_the_second_process_compiles_what_the_first_one_needs(rate):
    printed("-c", HALF, rate)


@pytest.fixture
def helped(monkeypatch):
    """Let the second process only wait, as if there were two cores; return all that started."""
    started = []
    real = subprocess.Popen

    def start(command, **others):
        assert command[1:4] == ["-m", "elastomer_friction.kernels.loading", "exponential"]
        started.append(real(["sleep", "0.2" if not started else "600"], **others))
        return started[-1]

    monkeypatch.setattr(loading.subprocess, "Popen", start)
    monkeypatch.setattr(loading, "_cores", lambda: 2)
    return started


def compile_something():
    """Compile two kernels."""
    for number in (1, 2):
        numba.njit(lambda x: x + number)(1.0)  # noqa: B023


@compiled_only
def test_it_is_started_once_and_waited_for_where_anything_is_compiled(helped):
    with loading._helped("exponential", Quantities()):
        assert helped == []
        compile_something()
        assert len(helped) == 1
    assert helped[0].returncode == 0
    with (
        event.install_recorder(WAITING_EVENT) as waits,
        loading._helped("exponential", Quantities()),
    ):
        pass
    assert len(helped) == 1
    assert waits.buffer == []  # all was found: nobody is waited for


@compiled_only
def test_it_ends_with_the_first_one(helped):
    def interrupted():
        compile_something()
        raise KeyboardInterrupt

    with loading._helped("exponential", Quantities()):
        compile_something()
    with pytest.raises(KeyboardInterrupt), loading._helped("exponential", Quantities()):
        interrupted()
    assert [each.returncode for each in helped] == [0, -signal.SIGKILL]


@compiled_only
@pytest.mark.parametrize(("asked", "cores"), [(Quantities(relaxation=False), 2), (Quantities(), 1)])
def test_there_is_none_where_nothing_marches_and_on_one_core(helped, monkeypatch, asked, cores):
    monkeypatch.setattr(loading, "_cores", lambda: cores)
    with loading._helped("exponential", asked):
        compile_something()
    assert helped == []


COLD = """
import numba, time
from numba.core import event
from elastomer_friction.kernels import Quantities, loading
began = time.thread_time()
with event.install_recorder("numba:compile") as found:
    loading.load("exponential", Quantities())
own = {record.data["dispatcher"].py_func.__name__ for _, record in found.buffer}
print(*sorted(own), sep="\\n")
"""


@compiled_only
@pytest.mark.exhaustive
def test_two_processes_fill_an_empty_cache_together(tmp_path):
    found = [printed("-c", COLD, NUMBA_CACHE_DIR=str(tmp_path)).split() for _ in range(2)]
    assert "slide_on" in found[0]
    assert loading._cores() == 1 or not {"active_march", "march", "stack_of"} & set(found[0])
    assert found[1] == []
