"""A run that stops itself (SIGSTOP) once two batches are stored: what a test then does is in time.

python -m tests.cluster.stopping run STUDY ...
"""

import os
import runpy
import signal

from elastomer_friction.workflow.store.store import Store

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
    runpy.run_module("workflow", run_name="__main__", alter_sys=True)
