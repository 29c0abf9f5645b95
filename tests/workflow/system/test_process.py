"""Signals that ask a run to stop, and memory that a process keeps."""

import os
import signal
import subprocess
import sys

import pytest

from elastomer_friction.workflow.system.process import Interrupt


def test_first_signal_asks_even_if_it_comes_twice_at_once_and_a_later_one_aborts(clock, capsys):
    numbers = signal.SIGINT, signal.SIGTERM, signal.SIGHUP
    handlers = [signal.getsignal(number) for number in numbers]
    with Interrupt() as interrupt:
        assert not interrupt()
        signal.raise_signal(signal.SIGTERM)
        clock[0] += 0.01
        signal.raise_signal(signal.SIGINT)
        assert interrupt()
        clock[0] += 10.0
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    assert capsys.readouterr().err.count("\n") == 1
    assert [signal.getsignal(number) for number in numbers] == handlers


def test_a_terminal_that_hangs_up_asks_too_unless_nohup_ignores_it(capsys):
    before = signal.signal(signal.SIGHUP, signal.SIG_DFL)  # the tests may run under nohup
    try:
        with Interrupt() as interrupt:
            signal.raise_signal(signal.SIGHUP)
            assert interrupt()
        signal.signal(signal.SIGHUP, signal.SIG_IGN)
        with Interrupt() as interrupt:
            signal.raise_signal(signal.SIGHUP)
            assert not interrupt()
    finally:
        signal.signal(signal.SIGHUP, before)
    assert "stopping" in capsys.readouterr().err


FAULTS = """
import resource
import numpy as np
from elastomer_friction.workflow.system.process import keep_memory
if {kept}:
    assert keep_memory()
for _ in range(50):
    before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    a = [np.ones(1_000_000) for _ in range(5)]  # 40 MB, in arrays of 8
    del a
    print(resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="only the GNU C library can be told")
def test_memory_of_large_arrays_stays_in_the_process():
    def faults(kept, **environment):
        """Return how many pages the last of many rounds has asked for, if memory is kept or not."""
        code = [sys.executable, "-c", FAULTS.format(kept=kept)]
        done = subprocess.run(code, env=os.environ | environment, capture_output=True, check=True)
        return int(done.stdout.split()[-1])

    assert faults(kept=True, MALLOC_TRIM_THRESHOLD_="65536") < 10  # as dask sets it for workers
    assert faults(kept=False, MALLOC_TRIM_THRESHOLD_="65536") > 1000
