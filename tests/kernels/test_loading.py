"""Loading provides all machine code of a case; a second process compiles half of it."""

import signal
import subprocess
import sys

import pytest

from elastomer_friction.kernels import Quantities, loading
from tests.sizes import PLAIN_PYTHON
from tests.support.python import printed

compiled_only = pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")

MARCHES = """
from elastomer_friction.kernels import Quantities, loading
from elastomer_friction.kernels.quick.march.active import active_march
from elastomer_friction.kernels.quick.relaxation import plain_relaxations
from elastomer_friction.kernels.quick.steady.spans import add_rises, stack_of

kernels = plain_relaxations, add_rises, stack_of, active_march
loading.load_marches("exponential")
before = [kernel.signatures[:] for kernel in kernels]
assert [len(signatures) for signatures in before] == [1] * len(kernels), before
loading.load("implicit-euler", Quantities())
assert [kernel.signatures[:] for kernel in kernels] == before
"""


@compiled_only
def test_the_second_process_compiles_what_the_first_one_needs():
    printed("-c", MARCHES)


@pytest.fixture
def helpers(monkeypatch, tmp_path):
    """Make loading compute nothing and helpers only wait; return the list of started helpers."""
    started = []
    usual = subprocess.Popen

    def start(command, **options):
        assert command[:3] == [sys.executable, "-m", "elastomer_friction.kernels.loading"]
        started.append(usual(["sleep", "600"], **options))
        return started[-1]

    monkeypatch.setattr(loading, "CACHE_FOLDER", str(tmp_path))
    monkeypatch.setattr(loading.subprocess, "Popen", start)
    monkeypatch.setattr(loading, "run_cases", lambda *_: None)
    return started


def test_it_is_started_once_for_a_cache_folder_and_ends_with_the_first_one(helpers):
    for _ in range(2):
        loading.load("exponential", Quantities())
    assert [helper.returncode for helper in helpers] == [-signal.SIGKILL]


def test_it_ends_with_an_interrupted_one(helpers, monkeypatch):
    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(loading, "run_cases", interrupted)
    with pytest.raises(KeyboardInterrupt):
        loading.load("exponential", Quantities())
    assert [helper.returncode for helper in helpers] == [-signal.SIGKILL]


@pytest.mark.parametrize(
    "requested", [Quantities(relaxation=False), Quantities(indentation_rate=False)]
)
def test_there_is_none_if_it_has_nothing_to_compile(helpers, requested):
    loading.load("exponential", requested)
    assert helpers == []


def test_there_is_none_if_the_cache_is_read_only(helpers, monkeypatch):
    monkeypatch.setattr(loading, "CACHE_FOLDER", "/nowhere/at/all")
    loading.load("exponential", Quantities())
    assert helpers == []


COLD = """
from numba.core import event
from elastomer_friction.kernels import Quantities, loading
with event.install_recorder("numba:compile") as found:
    loading.load("exponential", Quantities())
names = {record.data["dispatcher"].py_func.__name__ for _, record in found.buffer}
print(*sorted(names), sep="\\n")
"""


@compiled_only
@pytest.mark.exhaustive
def test_two_processes_fill_an_empty_cache_together(tmp_path):
    first, second = (printed("-c", COLD, NUMBA_CACHE_DIR=str(tmp_path)).split() for _ in range(2))
    assert "slide_on_lines" in first
    assert not {"active_march", "march"} & set(first)
    assert second == []
