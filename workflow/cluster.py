"""The client of whatever computes: processes of this machine, SLURM's jobs, a scheduler there."""

import contextlib
import importlib.util
import logging
import os
import signal
import sys
from collections.abc import Iterator
from typing import Any

import dask
from distributed import Client, LocalCluster

from workflow.errors import UserError
from workflow.place import LOCAL, SLURM, Place
from workflow.slurm import PINNED, slurm_cluster

CONNECT_SECONDS = 10
# Kernels allocate the same large arrays again and again: keep them in the process. With
# dask's own setting (trim at 64 KiB) page faults cost as much time as the kernels.
MALLOC = {"MALLOC_TRIM_THRESHOLD_": str(2**28), "MALLOC_MMAP_THRESHOLD_": str(2**25)}


@contextlib.contextmanager
def open_client(
    place: Place, workers: int | None = None, dashboard: bool = False
) -> Iterator[Client]:
    """Yield a client of the place; ``workers`` is the number of processes of this machine.

    Raises UserError when a scheduler does not answer or a batch system refuses.
    """
    if dashboard and importlib.util.find_spec("bokeh") is None:
        raise UserError("--dashboard: needs bokeh; install it beside this package")
    settings: dict[str, Any] = {
        "distributed.worker.preload": ["workflow.worker_setup"],
        "distributed.scheduler.worker-saturation": 1.0,  # none waits on a worker: Ctrl-C ends soon
    }
    pinned = {f"{name}_NUM_THREADS": 1 for name in PINNED}
    for name, value in (MALLOC | pinned).items():
        settings[f"distributed.nanny.pre-spawn-environ.{name}"] = value
    # A lost scheduler is said in one line, by the flow.
    logging.getLogger("distributed.client").setLevel(logging.CRITICAL)
    with contextlib.ExitStack() as stack:
        stack.enter_context(dask.config.set(settings))
        if place.where == LOCAL:
            client = Client(stack.enter_context(_local_cluster(workers)))
        elif place.where == SLURM:
            client = Client(stack.enter_context(slurm_cluster(place, MALLOC)))
        else:
            client = _connected(place.where)
        stack.enter_context(client)
        if dashboard:
            print(f"dashboard: {client.dashboard_link}", file=sys.stderr)
        yield client


def _connected(address: str) -> Client:
    try:
        return Client(address, timeout=CONNECT_SECONDS)
    except (OSError, ValueError) as error:
        raise UserError(f"--scheduler {address}: no scheduler answers there") from error


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
