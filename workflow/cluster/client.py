"""The client of what computes: processes of this machine, jobs, or a scheduler that is there."""

import contextlib
import importlib.util
import logging
import signal
import socket
import ssl
import tempfile
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import dask
from dask.system import CPU_COUNT
from distributed import Client, Nanny, Scheduler, SpecCluster
from distributed.comm import get_address_host_port
from distributed.system import MEMORY_LIMIT
from distributed.utils import LoopRunner
from tornado.ioloop import IOLoop, PeriodicCallback

from ..errors import UserError
from ..study import BATCH_SYSTEMS, LOCAL, Cluster
from ..system import THREADS
from .calls import CLOSE_SECONDS, SafeClient, patiently
from .jobs import job_cluster
from .security import ENCRYPTED, own_security, routes, scheduler_options, security_of
from .watch import NO_ANSWER, Watch, say

CONNECT_SECONDS = 10
TRIES = 3  # to begin a thread of dask, which gives it ten seconds each: few on a busy machine
LOST_SECONDS = 30.0  # without a worker process, until a nanny of our own is given up
AGAIN_SECONDS = 5.0  # between looks at whether one has to be replaced
HERE = "127.0.0.1"


class PromptNanny(Nanny):
    """A nanny that kills its worker process soon where it does not end: it may be stopped."""

    async def kill(self, timeout: float = CLOSE_SECONDS, reason: str = "nanny-kill") -> None:
        """End the worker process."""
        await super().kill(min(timeout, CLOSE_SECONDS), reason)


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
        "distributed.worker.preload": ["elastomer_friction.workflow.cluster.worker"],
        **routes(dashboard),
        "distributed.scheduler.worker-saturation": 1.0,  # none waits on a worker: Ctrl-C ends soon
        "distributed.admin.low-level-log-length": 0,  # or the last 1000 messages stay in memory
        # Every loop asks 50 times a second whether it is late, and every worker looks 100 times at
        # what it does: together a tenth of a core, with nothing to do.
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
        if cluster.where == LOCAL:
            client = SafeClient(stack.enter_context(_local_cluster(workers, dashboard)))
        elif cluster.where in BATCH_SYSTEMS:
            client = SafeClient(stack.enter_context(job_cluster(cluster, dashboard)))
            watch.follow(cluster.log_folder)
        else:
            client = _client_of(cluster, watch)
        stack.callback(client.end)
        if dashboard:
            say(f"dashboard: {client.dashboard_link} (anyone on the machine can look)")
        yield client


@contextlib.contextmanager
def _local_cluster(workers: int | None, dashboard: bool) -> Iterator[SpecCluster]:
    """Yield processes of this machine, which listen to whoever has the certificate of this run."""
    count = workers or CPU_COUNT
    security = own_security()
    options = scheduler_options(dashboard)
    ends = {"host": HERE, "protocol": ENCRYPTED, "security": security}
    # What lies here is put in the path of imports: it must be nobody else's.
    with tempfile.TemporaryDirectory(prefix="elastomer-friction-") as folder:
        one = {"nthreads": 1, "memory_limit": MEMORY_LIMIT // count, "local_directory": folder}
        how = ends | one | {"silence_logs": logging.ERROR}
        parts: dict[str, Any] = {
            "scheduler": {"cls": Scheduler, "options": ends | options},
            "workers": {number: {"cls": PromptNanny, "options": how} for number in range(count)},
        }
        lost = dask.config.set({"distributed.deploy.lost-worker-timeout": LOST_SECONDS})
        with lost, _loop_without_ctrl_c() as loop:
            how_run = {"loop": loop, "security": security, "silence_logs": logging.ERROR}
            with SpecCluster(**parts, **how_run) as local, _kept(local, loop, count):
                yield local


@contextlib.contextmanager
def _kept(local: SpecCluster, loop: IOLoop, count: int) -> Iterator[None]:
    """Keep so many workers: dask's nanny gives up one that is killed while it starts again."""
    look = PeriodicCallback(partial(local.scale, count), 1e3 * AGAIN_SECONDS)
    loop.add_callback(look.start)
    try:
        yield
    finally:
        loop.add_callback(look.stop)


@contextlib.contextmanager
def _loop_without_ctrl_c() -> Iterator[IOLoop]:
    """Yield the loop of a thread that Ctrl-C does not reach, nor the processes it starts.

    Ctrl-C is sent to the whole process group: worker processes must be born not to hear it. This
    thread hears it all the while, so that it is not lost while they start.
    """
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        runner = begun(_running_loop)  # threads and processes inherit what is blocked
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
    try:
        yield runner.loop
    finally:
        runner.stop()


def _running_loop() -> LoopRunner:
    runner = LoopRunner()
    runner.start()
    return runner


def begun(begin: Callable[[], Any]) -> Any:
    """Return what ``begin`` returns; try again where dask asserts that its thread has begun."""
    for _ in range(TRIES - 1):
        with contextlib.suppress(AssertionError):
            return begin()
    return begin()


def _client_of(cluster: Cluster, watch: Watch) -> SafeClient:
    """Return a client of a scheduler that stands; wait for one that is there and says nothing."""
    security = security_of(cluster)
    while True:
        try:
            return patiently(watch, NO_ANSWER, _connected, cluster.where, security)
        # Where another service greets, dask reads a length that no memory holds (MemoryError).
        except (OSError, ValueError, MemoryError) as error:
            no_address = isinstance(error, ValueError)
            if no_address or not _is_mute(cluster.where):
                whose = " that the certificates fit" if security else ""
                text = f"--scheduler {cluster.where}: no scheduler answers there{whose}"
                raise UserError(text) from error


def _connected(address: str, security: Any) -> SafeClient:
    # While one tries to connect, xarray is not to ask dask's default for locks of files it writes.
    how = {"timeout": CONNECT_SECONDS, "security": security, "set_as_default": False}
    return begun(partial(SafeClient, address, **how))


def _is_mute(address: str) -> bool:
    """Return whether somebody takes connections at an address and says nothing, as if stopped."""
    place = get_address_host_port(address)
    with contextlib.suppress(OSError), socket.create_connection(place, CONNECT_SECONDS) as end:
        try:
            if address.startswith(ENCRYPTED):
                context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
                context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
                context.wrap_socket(end).close()  # it is only seen whether it answers
            else:
                end.recv(1)
        except TimeoutError:
            return True
    return False
