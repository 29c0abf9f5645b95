"""Worker processes of a test: their state, and their replacements."""

import contextlib
import os
import signal
import time

import psutil
import pytest

from tests.cluster.processes import workers_of
from tests.support.python import PATIENCE


def facts():
    """Return (process id, whether SIGINT is blocked, environment) of this worker."""
    blocked = signal.pthread_sigmask(signal.SIG_BLOCK, ())
    return os.getpid(), signal.SIGINT in blocked, dict(os.environ)


def started_again(client, killed):
    """Return the facts of the worker that replaces a killed one, without its process id."""
    for _ in range(int(10 * PATIENCE)):
        with contextlib.suppress(OSError):  # the killed worker is still registered
            for pid, *rest in client.run(facts).values():
                if pid != killed:
                    return rest
        time.sleep(0.1)
    return pytest.fail("no worker was started again")


def starting(known):
    """Return the process id of a new worker of this process, one that is not in ``known``."""
    for _ in range(int(20 * PATIENCE)):
        for pid in set(workers_of(psutil.Process())) - known:
            return pid
        time.sleep(0.05)
    return pytest.fail("no worker was started again")
