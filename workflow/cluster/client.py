"""The client of what computes: processes of this machine, jobs, or a scheduler that is there."""

import contextlib
import importlib.util
import logging
import signal
import sys
from collections.abc import Iterator

import dask
from dask.system import CPU_COUNT
from distributed import Client, LocalCluster

from workflow.cluster.jobs import job_cluster
from workflow.errors import UserError
from workflow.study import BATCH_SYSTEMS, LOCAL, Cluster
from workflow.system import WORKER_ENVIRONMENT

CONNECT_SECONDS = 10


@contextlib.contextmanager
def open_client(
    cluster: Cluster, workers: int | None = None, dashboard: bool = False
) -> Iterator[Client]:
    """Yield a client of the cluster; ``workers`` is the number of processes of this machine.

    Raises UserError when a scheduler does not answer or a batch system refuses.
    """
    if dashboard and importlib.util.find_spec("bokeh") is None:
        raise UserError("--dashboard: needs bokeh; install it beside this package")
    settings = {
        "distributed.worker.preload": ["workflow.cluster.worker"],
        "distributed.scheduler.worker-saturation": 1.0,  # none waits on a worker: Ctrl-C ends soon
        **{f"distributed.nanny.pre-spawn-environ.{k}": v for k, v in WORKER_ENVIRONMENT.items()},
    }
    # A lost scheduler is said in one line, by the flow.
    logging.getLogger("distributed.client").setLevel(logging.CRITICAL)
    with contextlib.ExitStack() as stack:
        stack.enter_context(dask.config.set(settings))
        if cluster.where == LOCAL:
            client = Client(stack.enter_context(_local_cluster(workers)))
        elif cluster.where in BATCH_SYSTEMS:
            client = Client(stack.enter_context(job_cluster(cluster)))
        else:
            try:
                client = Client(cluster.where, timeout=CONNECT_SECONDS)
            except (OSError, ValueError) as error:
                text = f"--scheduler {cluster.where}: no scheduler answers there"
                raise UserError(text) from error
        stack.enter_context(client)
        if dashboard:
            print(f"dashboard: {client.dashboard_link}", file=sys.stderr)
        yield client


def _local_cluster(workers: int | None) -> LocalCluster:
    # Ctrl-C reaches the whole process group: worker processes must be born ignoring it.
    previous = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        return LocalCluster(
            n_workers=workers or CPU_COUNT,
            threads_per_worker=1,
            processes=True,
            dashboard_address="127.0.0.1:0",  # any free port: 8787 may be taken
        )
    finally:
        signal.signal(signal.SIGINT, previous)
