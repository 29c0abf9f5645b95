"""Pool of the workers of a dask client: submission, arrivals, and snapshots.

No call blocks on a process that may have been stopped: requests are awaited in the event loop of
the client. The states of all futures are looked at together and finished results are fetched
together: dask's ``as_completed`` starts a coroutine for each future, which costs the driver more.
"""

import asyncio
import concurrent.futures
import contextlib
import pickle
import time
import uuid
from collections.abc import Callable, Collection, Iterable, Mapping
from queue import SimpleQueue
from typing import Any, NamedTuple, cast

from distributed import Client, Future
from distributed.client import FutureCancelledError
from distributed.protocol.pickle import dumps

from ..ground import UserError
from .node import Node
from .worker import ADDRESS_ATTRIBUTE, forget_tasks, with_address

SCHEDULER_LOST = "the scheduler was lost; run again to resume"
CONNECTION_LOST = "scheduler-connection-lost"  # dask's reason of cancelled futures
FETCH_SECONDS = 30.0  # timeout of a transfer, after which the result is recomputed
FORGET, NO_KWARGS = dumps(forget_tasks), dumps({})


class ResultLost(Exception):
    """Raised if a result could not be fetched from its worker, or if an input of it was lost."""


class Arrival(NamedTuple):
    """The outcome of a node: a value or an error."""

    key: str
    address: str = ""  # address of the worker; "": unknown
    value: Any = None
    error: Exception | None = None


class Snapshot(NamedTuple):
    """The scheduler's view of its workers."""

    threads: dict[str, int]  # number of threads of each worker, by address
    ready: Collection[str] = ()  # addresses that accept work; the others are short of memory
    running: Mapping[str, str] = {}  # key of a node on a worker -> address


class Pool:
    """Workers that compute nodes."""

    monotonic = staticmethod(time.monotonic)

    def __init__(self, client: Client, functions: dict[str, Callable]) -> None:
        """Create a pool. functions : by name of the nodes."""
        self._client, self._loop = client, cast(Any, client.loop).asyncio_loop
        self._functions = {name: dumps(function) for name, function in functions.items()}
        self._pending: dict[str, Future] = {}
        self._fetched: set[str] = set()  # keys of results that are on their way
        self._arrivals: SimpleQueue[Arrival] = SimpleQueue()

    def submit(self, nodes: Iterable[Node], workers: Collection[str] = ()) -> list[str]:
        """Submit nodes, restricted to ``workers`` unless it is empty; return their keys."""
        restriction: dict[str, Any] = {"workers": [*workers]} if workers else {}
        nodes, uid = [*nodes], uuid.uuid4()
        keys = [f"{node.name}-{uid}-{number}" for number, node in enumerate(nodes)]
        roots = [(node, key) for node, key in zip(nodes, keys, strict=True) if not node.given]
        if roots:
            functions = [self._functions[node.name] for node, _ in roots]
            items = [pickle.dumps(node.item, 5) for node, _ in roots]
            root_keys: Any = [key for _, key in roots]
            futures = self._client.map(
                with_address, functions, items, key=root_keys, pure=False, **restriction
            )
            for (node, _), future in zip(roots, futures, strict=True):
                node.result = future
        for node, key in zip(nodes, keys, strict=True):
            if node.given:
                arguments = self._functions[node.name], pickle.dumps(node.item, 5)
                inputs = [other.result for other in node.given]
                node.result = self._client.submit(
                    with_address, *arguments, *inputs, key=key, pure=False, **restriction
                )
        self._pending |= {key: node.result for node, key in zip(nodes, keys, strict=True)}
        return keys

    def take(self, seconds: float) -> list[Arrival]:
        """Return what has arrived after the given time, and fetch what is finished."""
        time.sleep(seconds)
        arrivals = [self._arrivals.get_nowait() for _ in range(self._arrivals.qsize())]
        finished = [f for f in self._pending.values() if f.status != "pending"]
        for future in finished:
            del self._pending[str(future.key)]
        if finished:
            self._fetched |= {str(future.key) for future in finished}
            asyncio.run_coroutine_threadsafe(self._fetch(finished), self._loop)
        arrivals = [arrival for arrival in arrivals if arrival.key in self._fetched]
        self._fetched -= {arrival.key for arrival in arrivals}
        return arrivals

    def drop(self, nodes: Mapping[str, Node]) -> None:
        """Stop waiting for nodes, given by key; those that no worker has started do not run."""
        for key, node in nodes.items():
            self._fetched.discard(key)
            self._pending.pop(key, None)
            if node.result is not None:
                node.result.release()
                node.result = None

    def holds(self, node: Node) -> bool:
        """Return whether a worker still has the result of a node that is done."""
        return node.result is not None and node.result.status == "finished"

    def pending(self, key: str) -> bool:
        """Return whether a node is unfinished."""
        return key in self._pending and self._pending[key].status == "pending"

    def request_snapshot(self) -> "concurrent.futures.Future[Snapshot]":
        """Request a snapshot. Its future raises UserError if the scheduler is lost."""
        return asyncio.run_coroutine_threadsafe(self._snapshot(), self._loop)

    async def _snapshot(self) -> Snapshot:
        scheduler: Any = self._client.scheduler
        try:
            threads, ready, processing = await asyncio.gather(
                scheduler.ncores(), scheduler.ncores_running(), scheduler.processing()
            )
        except OSError as error:
            raise UserError(SCHEDULER_LOST) from error
        running = {str(key): address for address, keys in processing.items() for key in keys}
        return Snapshot(threads, ready, running)

    async def _fetch(self, futures: list[Future]) -> None:
        """Fetch results together, or one by one if that fails."""
        keys = [str(future.key) for future in futures]
        try:
            gathering: Any = self._client.gather(futures, asynchronous=True)
            results = await asyncio.wait_for(gathering, FETCH_SECONDS)
            arrivals = [Arrival(key, *result) for key, result in zip(keys, results, strict=True)]
        except Exception as error:
            if len(futures) > 1:
                await asyncio.gather(*(self._fetch([future]) for future in futures))
                return
            arrivals = [_failure(futures[0], error)]
        for arrival in arrivals:
            self._arrivals.put(arrival)
        with contextlib.suppress(OSError):  # the next snapshot reports a lost scheduler
            scheduler: Any = self._client.scheduler
            await scheduler.run_function(function=FORGET, args=dumps((keys,)), kwargs=NO_KWARGS)


def _failure(future: Future, error: Exception) -> Arrival:
    """Return the arrival of a future whose result could not be fetched."""
    key = str(future.key)
    if isinstance(error, FutureCancelledError):
        lost = error.reason == CONNECTION_LOST
        return Arrival(key, error=UserError(SCHEDULER_LOST) if lost else ResultLost())
    if future.status == "error" or not isinstance(error, OSError):
        return Arrival(key, getattr(error, ADDRESS_ATTRIBUTE, ""), error=error)
    return Arrival(key, error=ResultLost())
