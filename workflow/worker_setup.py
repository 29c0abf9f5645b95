"""Loaded by every worker process of the embedded cluster when it starts."""

import signal

from distributed import Worker


def dask_setup(worker: Worker) -> None:
    """Leave Ctrl-C to the driver, which lets running batches finish and be stored."""
    del worker
    signal.signal(signal.SIGINT, signal.SIG_IGN)
