"""Clients of local processes, batch jobs, or a running scheduler."""

import asyncio
import contextlib
import importlib.util
import logging
import sys
import tempfile
from collections.abc import Iterator
from typing import Any

import dask
from dask.system import CPU_COUNT
from distributed import Client, LocalCluster
from distributed.core import rpc
from distributed.security import Security
from distributed.utils import sync
from tornado.ioloop import IOLoop

from ..ground import UserError
from ..study import BATCH_SYSTEMS, LOCAL, Cluster
from ..system import THREADS, loop_without_ctrl_c, own_versions, require, say
from .jobs import ADAPT_INTERVAL, job_cluster
from .security import new_security, private_pages, security_of

CONNECT_SECONDS = 10
MUTE_SECONDS = 30  # timeout for a scheduler that accepts connections but does not answer
CLOSE_SECONDS = 2.0  # timeout for closing a client
WORKER_TTL = "25s"  # silence after which dask restarts a worker; also the period of the check


@contextlib.contextmanager
def open_client(
    cluster: Cluster, workers: int | None = None, dashboard: bool = False
) -> Iterator[Client]:
    """Yield a client of the cluster.

    workers : number of local processes; the default is the number of cores. Raises UserError if
    the scheduler does not answer or the batch system refuses the jobs.
    """
    if dashboard and importlib.util.find_spec("bokeh") is None:
        raise UserError(f"--dashboard: needs bokeh; {sys.executable} -m pip install bokeh")
    settings = {
        "distributed.scheduler.worker-ttl": WORKER_TTL,
        "distributed.scheduler.worker-saturation": 1.0,  # no queue on workers, for a quick Ctrl-C
        # These settings of the user would end or hang a run.
        "distributed.scheduler.idle-timeout": None,
        "distributed.scheduler.no-workers-timeout": None,
        "distributed.worker.lifetime.duration": None,
        "distributed.admin.large-graph-warning-threshold": "1GB",  # batches carry measured maps
        "distributed.admin.low-level-log-length": 0,  # otherwise 1000 messages stay in memory
        # By default, event-loop ticks and profiles take a tenth of a core in an idle process.
        "distributed.admin.tick.interval": "1s",
        "distributed.worker.profile.enabled": dashboard,  # only the dashboard shows it
        **{f"distributed.nanny.pre-spawn-environ.{k}": v for k, v in THREADS.items()},
    }
    # Silenced because ``Stream`` reports lost workers in one line.
    for name in ("distributed.client", "distributed.scheduler"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    with contextlib.ExitStack() as stack:
        stack.enter_context(dask.config.set(settings))
        loop = stack.enter_context(loop_without_ctrl_c())
        if cluster.where == LOCAL or cluster.where in BATCH_SYSTEMS:
            local = _local_cluster(loop, workers or CPU_COUNT, dashboard)
            own = local if cluster.where == LOCAL else job_cluster(loop, cluster, dashboard)
            client = sync(loop, _connected, stack.enter_context(own))
        else:
            client = _client_of(loop, cluster)
        stack.callback(sync, loop, _closed, client)
        if dashboard:
            say(f"dashboard: {client.dashboard_link} (visible to all users of this machine)")
        yield client


@contextlib.contextmanager
def _local_cluster(loop: IOLoop, count: int, dashboard: bool) -> Iterator[LocalCluster]:
    """Yield a cluster of local processes, which require the certificate of this run to connect."""
    # Workers import code from this folder, which must therefore belong to this user alone.
    with tempfile.TemporaryDirectory(prefix="elastomer-friction-") as folder:
        security = new_security(folder)
        pages, scheduler_options = private_pages(security, dashboard)
        options: dict[str, Any] = {"n_workers": count, "threads_per_worker": 1}
        options |= {"scheduler_kwargs": scheduler_options, "local_directory": folder}
        options |= {"loop": loop, "security": security, "silence_logs": logging.CRITICAL}
        with dask.config.set(pages), contextlib.ExitStack() as stack:
            try:
                local = stack.enter_context(LocalCluster(**options))
            except (LookupError, RuntimeError, TypeError, ValueError) as error:
                reason = " ".join(str(error).split())
                remedy = "correct the settings of dask (DASK_…, dask.yaml), or free memory"
                raise UserError(f"local workers cannot be started: {reason}; {remedy}") from error
            # Replace any nanny that gave up because its worker was killed during a restart.
            local.adapt(minimum=count, maximum=count, interval=ADAPT_INTERVAL)
            yield local


def _client_of(loop: IOLoop, cluster: Cluster) -> Client:
    """Return a client of a running scheduler.

    Raises UserError if no scheduler answers, or if its versions differ from those here.
    """
    security = security_of(cluster)
    try:  # first, as the client of one version does not connect to every other
        versions = sync(loop, _scheduler_versions, cluster.where, security)
        own = own_versions()
        require({name: own[name] for name in ("dask", "distributed")}, versions, "scheduler")
        return sync(loop, _connected, cluster.where, security)
    # MemoryError: the greeting of another service is misread as a huge message length.
    except (OSError, ValueError, MemoryError) as error:
        accepting = " that accepts the certificates" if security else ""
        text = f"--scheduler {cluster.where}: no scheduler answers there{accepting}"
        raise UserError(text) from error


async def _scheduler_versions(address: str, security: Security | None) -> dict[str, str]:
    """Return the versions of the packages of a scheduler."""
    arguments = security.get_connection_args("client") if security else {}
    async with rpc(address, timeout=CONNECT_SECONDS, connection_args=arguments) as scheduler:
        answer: Any = await asyncio.wait_for(scheduler.versions(), MUTE_SECONDS)
    return dict(answer["packages"])


async def _connected(where: Any, security: Any = None) -> Client:
    """Return a connected client, or close it and raise if no scheduler answers."""
    # If this were the default client, xarray would request locks from it while it connects.
    options = {"timeout": CONNECT_SECONDS, "set_as_default": False, "asynchronous": True}
    client = Client(where, security=security, **options)
    try:  # without a timeout a client waits forever for a stopped scheduler
        return await asyncio.wait_for(client, MUTE_SECONDS)
    except BaseException:
        await _closed(client)
        raise


async def _closed(client: Client) -> None:
    """Close a client, whether or not its scheduler answers.

    A client that is still open when it is garbage-collected may deadlock, as the collection can
    happen while dask holds the lock that closing needs.
    """
    with contextlib.suppress(TimeoutError):
        await client.close(timeout=CLOSE_SECONDS)
    client.status = "closed"
