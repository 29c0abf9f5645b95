"""The clock of computing time does not run while kernels are compiled."""

import time

import numba
import pytest

from elastomer_friction.kernels.compile.clock import computing_seconds
from elastomer_friction.workflow.ground import garbage_collection_paused
from tests.sizes import PLAIN_PYTHON


def compile_two():
    """Compile a kernel within another one."""
    inner = numba.njit(lambda x: x + 1.0)
    numba.njit(lambda x: inner(x))(1.0)


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")
def test_it_stands_still_while_kernels_are_compiled():
    with garbage_collection_paused():  # garbage of other tests would count as computing
        start, computing = time.thread_time(), computing_seconds()
        compile_two()
        used, total = computing_seconds() - computing, time.thread_time() - start
    assert 0.0 <= used < 0.5 * total
