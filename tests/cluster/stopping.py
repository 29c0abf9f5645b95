"""A run that stops itself (SIGSTOP) once two batches are stored: what a test then does is in time.

It reports a silent scheduler after 5 s instead of 30 s (tests/workflow/system/test_watch.py).

python -m tests.cluster.stopping run STUDY ...
"""

import os
import runpy
import signal

from elastomer_friction.workflow.store.store import Store
from elastomer_friction.workflow.system import NO_ANSWER, watch

add = Store.add
stored = []  # numbers of batches


def add_and_stop(store, finished):
    """Store finished batches; stop once there are two of them."""
    add(store, finished)
    stored.append(len(finished))
    if sum(stored[:-1]) < 2 <= sum(stored):
        os.kill(os.getpid(), signal.SIGSTOP)


if __name__ == "__main__":  # worker processes begin with this module too
    Store.add = add_and_stop
    watch.FIRST_LINE_SECONDS[NO_ANSWER] = 5.0
    runpy.run_module("workflow", run_name="__main__", alter_sys=True)
