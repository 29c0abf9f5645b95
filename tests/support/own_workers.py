"""Worker processes that a test has started: what they say of themselves, what replaces them."""

import contextlib
import os
import signal
import time

import psutil
import pytest

from tests.cluster.processes import workers_of
from tests.support.python import PATIENCE


def facts():
    """Return what a worker says of itself."""
    blocked = signal.pthread_sigmask(signal.SIG_BLOCK, ())
    return os.getpid(), signal.SIGINT in blocked, dict(os.environ)


def started_again(client, killed):
    """Return the facts of the worker that takes the place of a killed one."""
    for _ in range(int(10 * PATIENCE)):
        with contextlib.suppress(OSError):  # the killed one is still known
            for pid, *rest in client.run(facts).values():
                if pid != killed:
                    return rest
        time.sleep(0.1)
    return pytest.fail("no worker was started again")


def starting(known):
    """Return a worker process of ours that has just been started, as it is not known."""
    for _ in range(int(20 * PATIENCE)):
        for pid in set(workers_of(psutil.Process())) - known:
            return pid
        time.sleep(0.05)
    return pytest.fail("no worker was started again")
