"""The clock of the work stands still while kernels are compiled; garbage waits for their end."""

import gc
import time
from threading import Thread

import numba
import pytest

from elastomer_friction.kernels.compile.clock import computing_seconds, own
from elastomer_friction.kernels.compile.garbage import garbage_collection_paused
from tests.sizes import PLAIN_PYTHON
from tests.support.python import printed


def compile_two():
    """Compile a kernel within another one."""
    inner = numba.njit(lambda x: x + 1.0)
    numba.njit(lambda x: inner(x))(1.0)


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")
def test_it_stands_still_while_kernels_are_compiled():
    lost = own.lost
    with garbage_collection_paused():  # of what other tests have left, which would be work
        began, working = time.thread_time(), computing_seconds()
        compile_two()
        used, whole = computing_seconds() - working, time.thread_time() - began
    assert own.depth == 0
    assert own.lost > lost
    assert 0.0 <= used < 0.5 * whole


def test_it_runs_while_python_works():
    began, working = time.thread_time(), computing_seconds()
    sum(range(200_000))
    end, last = computing_seconds(), time.thread_time()
    assert 0.0 < end - working <= last - began


def test_threads_have_clocks_of_their_own():
    lost = own.lost
    thread = Thread(target=compile_two)
    thread.start()
    thread.join()
    assert own.lost == lost


def fail():
    """Fail while nothing is collected."""
    with garbage_collection_paused():
        assert not gc.isenabled()
        raise ZeroDivisionError


@pytest.mark.parametrize("enabled", [True, False])
def test_the_collector_is_as_it_was_after_an_error_too(enabled):
    usual = gc.isenabled()
    (gc.enable if enabled else gc.disable)()
    try:
        with pytest.raises(ZeroDivisionError):
            fail()
        assert gc.isenabled() == enabled
    finally:
        (gc.enable if usual else gc.disable)()


ENDING = """
import gc
{first}
gc.disable()

class Garbage:
    def __del__(self):
        print("found")

garbage = Garbage()
garbage.own = garbage
del garbage
"""


@pytest.mark.parametrize(
    ("first", "found"), [("", "found\n"), ("import elastomer_friction.kernels.compile.garbage", "")]
)
def test_at_its_end_a_process_looks_for_no_garbage(first, found):
    assert printed("-c", ENDING.format(first=first)) == found
