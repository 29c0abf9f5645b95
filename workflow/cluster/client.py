"""The client of what computes: processes of this machine, jobs, or a scheduler that is there."""

import asyncio
import concurrent.futures
import contextlib
import importlib.util
import logging
import signal
import tempfile
import threading
from collections.abc import Iterator
from multiprocessing import resource_tracker
from typing import Any

import dask
from dask.system import CPU_COUNT
from distributed import Client, Nanny, Scheduler, SpecCluster
from distributed.system import MEMORY_LIMIT
from distributed.utils import sync
from tornado.ioloop import IOLoop

from ..ground import UserError
from ..study import BATCH_SYSTEMS, LOCAL, Cluster
from ..system import THREADS, Watch, say
from .jobs import ADAPT_SECONDS, job_cluster
from .security import ENCRYPTED, no_pages, own_security, scheduler_options, security_of

CONNECT_SECONDS = 10
MUTE_SECONDS = 30  # for a scheduler that takes connections and says nothing
CLOSE_SECONDS = 2.0  # for a scheduler to say goodbye
SILENT_WORKER = "25s"  # after which dask starts a worker anew; it looks so often, and needs 5 s
HERE = "127.0.0.1"


@contextlib.contextmanager
def open_client(
    cluster: Cluster,
    workers: int | None = None,
    dashboard: bool = False,
    watch: Watch | None = None,
) -> Iterator[Client]:
    """Yield a client of the cluster; ``workers`` is the number of processes of this machine.

    Raises UserError when a scheduler does not answer or a batch system refuses.
    """
    if dashboard and importlib.util.find_spec("bokeh") is None:
        raise UserError("--dashboard: needs bokeh (the extra 'dashboard' of this package)")
    settings = {
        "distributed.scheduler.worker-ttl": SILENT_WORKER,
        "distributed.scheduler.worker-saturation": 1.0,  # none waits on a worker: Ctrl-C ends soon
        "distributed.admin.low-level-log-length": 0,  # or the last 1000 messages stay in memory
        # Loops that ask whether they are late, and profiles, take a tenth of a core of the idle.
        "distributed.admin.tick.interval": "1s",
        "distributed.worker.profile.enabled": dashboard,  # where somebody looks at it
        **{f"distributed.nanny.pre-spawn-environ.{k}": v for k, v in THREADS.items()},
    }
    # What is lost is said in one line, by the flow.
    for name in ("distributed.client", "distributed.scheduler"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    watch = watch or Watch()
    with contextlib.ExitStack() as stack:
        stack.enter_context(dask.config.set(settings))
        loop = stack.enter_context(_loop_without_ctrl_c())
        if cluster.where == LOCAL:
            local = stack.enter_context(_local_cluster(loop, workers, dashboard))
            client = sync(loop, _connected, local)
        elif cluster.where in BATCH_SYSTEMS:
            jobs = stack.enter_context(job_cluster(loop, cluster, dashboard))
            client = sync(loop, _connected, jobs)
            watch.follow(cluster.log_folder)
        else:
            client = _client_of(loop, cluster)
        stack.callback(sync, loop, _closed, client)
        if dashboard:
            say(f"dashboard: {client.dashboard_link} (anyone on the machine can look)")
        yield client


@contextlib.contextmanager
def _local_cluster(loop: IOLoop, workers: int | None, dashboard: bool) -> Iterator[SpecCluster]:
    """Yield processes of this machine, which listen to whoever has the certificate of this run."""
    count = workers or CPU_COUNT
    # What lies here is put in the path of imports: it must be nobody else's.
    with tempfile.TemporaryDirectory(prefix="elastomer-friction-") as folder:
        security = own_security(folder)
        ends = {"host": HERE, "protocol": ENCRYPTED, "security": security}
        one = {"nthreads": 1, "memory_limit": MEMORY_LIMIT // count, "local_directory": folder}
        how = ends | one | {"silence_logs": logging.CRITICAL}
        parts: dict[str, Any] = {
            "scheduler": {"cls": Scheduler, "options": ends | scheduler_options(dashboard)},
            "workers": {number: {"cls": Nanny, "options": how} for number in range(count)},
        }
        how_run = {"loop": loop, "security": security, "silence_logs": logging.CRITICAL}
        pages = dask.config.set(no_pages(security, dashboard))
        with pages, SpecCluster(**parts, **how_run) as local:
            # A nanny whose worker process is killed while it starts again gives it up.
            local.adapt(minimum=count, maximum=count, interval=ADAPT_SECONDS)
            yield local


@contextlib.contextmanager
def _loop_without_ctrl_c() -> Iterator[IOLoop]:
    """Yield the loop of a thread that Ctrl-C does not reach, nor the processes it starts.

    Ctrl-C is sent to the whole process group: worker processes must be born not to hear it.
    """
    begun: concurrent.futures.Future[IOLoop] = concurrent.futures.Future()
    over = asyncio.Event()

    async def until_over() -> None:
        begun.set_result(IOLoop.current())
        await over.wait()

    def run() -> None:
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})  # processes inherit it
        asyncio.run(until_over())

    resource_tracker.ensure_running()  # where it begins later, it unblocks what is blocked there
    thread = threading.Thread(target=run, name="IO loop", daemon=True)
    thread.start()
    loop = begun.result()
    try:
        yield loop
    finally:
        loop.add_callback(over.set)
        thread.join(CLOSE_SECONDS)


def _client_of(loop: IOLoop, cluster: Cluster) -> Client:
    """Return a client of a scheduler that stands."""
    security = security_of(cluster)
    try:
        return sync(loop, _connected, cluster.where, security)
    # Where another service greets, dask reads a length that no memory holds (MemoryError).
    except (OSError, ValueError, MemoryError) as error:
        whose = " that the certificates fit" if security else ""
        text = f"--scheduler {cluster.where}: no scheduler answers there{whose}"
        raise UserError(text) from error


async def _connected(where: Any, security: Any = None) -> Client:
    """Return a client; where nobody answers, close what has been opened."""
    # While one tries to connect, xarray is not to ask dask's default for locks of files it writes.
    how = {"timeout": CONNECT_SECONDS, "set_as_default": False, "asynchronous": True}
    client = Client(where, security=security, **how)
    try:  # of itself it waits for ever for a scheduler that says nothing, as if it were stopped
        return await asyncio.wait_for(client, MUTE_SECONDS)
    except BaseException:
        await _closed(client)
        raise


async def _closed(client: Client) -> None:
    """Close a client, whether or not its scheduler answers.

    Nothing is left to do when Python collects it: that may come while dask holds the lock of its
    threads, and would wait for that very lock.
    """
    with contextlib.suppress(TimeoutError):
        await client.close(timeout=CLOSE_SECONDS)
    client.status = "closed"
