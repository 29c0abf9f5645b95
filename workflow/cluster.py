"""Where batches run: an embedded LocalCluster or a scheduler that is already there."""

import contextlib
import os
import signal
from collections.abc import Iterator

import dask
from distributed import Client, LocalCluster

from workflow.errors import UserError

CONNECT_SECONDS = 10
# Kernels allocate the same large arrays again and again: keep them in the process. With
# dask's own setting (trim at 64 KiB) page faults cost as much time as the kernels.
MALLOC = {"MALLOC_TRIM_THRESHOLD_": 2**28, "MALLOC_MMAP_THRESHOLD_": 2**25}


@contextlib.contextmanager
def open_client(scheduler: str | None, workers: int | None) -> Iterator[Client]:
    """Yield a client of ``scheduler`` ("tcp://host:port"), or of single-threaded processes here.

    Raises UserError when the scheduler does not answer.
    """
    if scheduler:
        try:
            client = Client(scheduler, timeout=CONNECT_SECONDS)
        except (OSError, ValueError) as error:
            raise UserError(f"--scheduler {scheduler}: no scheduler answers there") from error
        with client:
            yield client
        return
    settings = {
        "distributed.worker.preload": ["workflow.worker_setup"],
        "distributed.scheduler.worker-saturation": 1.0,  # none waits on a worker: Ctrl-C ends soon
    }
    for name, value in MALLOC.items():
        settings[f"distributed.nanny.pre-spawn-environ.{name}"] = value
    with (
        dask.config.set(settings),
        _local_cluster(workers) as cluster,
        Client(cluster) as client,
    ):
        yield client


@contextlib.contextmanager
def _local_cluster(workers: int | None) -> Iterator[LocalCluster]:
    # Ctrl-C reaches the whole process group: worker processes must be born ignoring it.
    previous = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        cluster = LocalCluster(
            n_workers=workers or _cores(),
            threads_per_worker=1,
            processes=True,
            dashboard_address="127.0.0.1:0",  # any free port: 8787 may be taken
        )
    finally:
        signal.signal(signal.SIGINT, previous)
    with cluster:
        yield cluster


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
