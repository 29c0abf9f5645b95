"""Pool of the workers of a dask client: submission, arrivals, and snapshots.

No method blocks on a process that may have been stopped: requests are awaited in the event loop of
the client. The states of all futures are looked at together and finished results are fetched
together: dask's ``as_completed`` starts a coroutine for each future, which costs the driver more.
"""

import asyncio
import contextlib
import pickle
import time
import uuid
from collections.abc import Callable, Collection, Iterable
from concurrent.futures import Future as Answer
from queue import SimpleQueue
from typing import Any, cast

from distributed import Client, Future
from distributed.client import FutureCancelledError
from distributed.protocol.pickle import dumps
from distributed.scheduler import KilledWorker

from ..ground import UserError
from .remote_call import Arrival, Call, ResultLost, Snapshot, WorkerDied
from .worker import ADDRESS_ATTRIBUTE, forget_tasks, with_address

SCHEDULER_LOST = "the scheduler was lost; run again to resume"
CONNECTION_LOST = "scheduler-connection-lost"  # dask's reason of cancelled futures
FETCH_SECONDS = 30.0  # timeout of a transfer, after which the result is recomputed


class Pool:
    """Workers that compute calls."""

    monotonic = staticmethod(time.monotonic)

    def __init__(self, client: Client, functions: dict[str, Callable]) -> None:
        """Create a pool. functions : by name of the calls."""
        self._client, self._loop = client, cast(Any, client.loop).asyncio_loop
        self._scheduler: Any = client.scheduler
        self._functions = {name: dumps(function) for name, function in functions.items()}
        self._pending: dict[str, Future] = {}
        self._arrivals: SimpleQueue[Arrival] = SimpleQueue()
        self._fetched: list[str] = []  # keys that the scheduler is not told of yet
        self._telling = asyncio.Lock()  # or many calls at once would each open a connection

    def submit(self, calls: list[Call], workers: Collection[str] = ()) -> dict[str, Future]:
        """Submit calls, restricted to ``workers`` unless it is empty; return futures by key."""
        uid = uuid.uuid4()
        keys = [f"{call.name}-{uid}-{number}" for number, call in enumerate(calls)]
        futures = self._client.map(
            with_address,
            [self._functions[call.name] for call in calls],
            [pickle.dumps(call.item, 5) for call in calls],
            [call.inputs for call in calls],
            key=cast(Any, keys),
            pure=False,
            workers=cast(Any, [*workers] or None),
        )
        submitted = dict(zip(keys, futures, strict=True))
        self._pending |= submitted
        return submitted

    def take(self, seconds: float) -> list[Arrival]:
        """Return what has arrived after the given time, and fetch what is finished."""
        time.sleep(seconds)
        if finished := [f for f in self._pending.values() if f.status != "pending"]:
            for future in finished:
                del self._pending[str(future.key)]
            asyncio.run_coroutine_threadsafe(self._fetch(finished), self._loop)
        return [self._arrivals.get_nowait() for _ in range(self._arrivals.qsize())]

    def drop(self, keys: Iterable[str]) -> None:
        """Stop waiting for calls; those that no worker has started do not run without a future."""
        for key in keys:
            self._pending.pop(key, None)

    def holds(self, future: Future) -> bool:
        """Return whether a worker still has the result of a call that is done."""
        return future.status == "finished"

    def pending(self, key: str) -> bool:
        """Return whether a call is unfinished."""
        return key in self._pending and self._pending[key].status == "pending"

    def request_snapshot(self) -> "Answer[Snapshot]":
        """Request a snapshot. Its future raises UserError if the scheduler is lost."""
        return asyncio.run_coroutine_threadsafe(self._snapshot(), self._loop)

    async def _snapshot(self) -> Snapshot:
        scheduler = self._scheduler
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
            address = getattr(error, ADDRESS_ATTRIBUTE, "")
            arrivals = [Arrival(keys[0], address, error=_meaning(futures[0], error))]
        for arrival in arrivals:
            self._arrivals.put(arrival)
        self._fetched += keys
        async with self._telling:
            fetched, self._fetched = self._fetched, []
            with contextlib.suppress(OSError):  # the next snapshot reports a lost scheduler
                if fetched:
                    await self._client.run_on_scheduler(forget_tasks, fetched)


def _meaning(future: Future, error: Exception) -> Exception:
    """Return what an error means that was raised when the result of a future was fetched."""
    if isinstance(error, KilledWorker):
        return WorkerDied(error.allowed_failures + 1)
    if isinstance(error, FutureCancelledError) and error.reason == CONNECTION_LOST:
        return UserError(SCHEDULER_LOST)
    transfer = isinstance(error, OSError) and future.status != "error"
    return ResultLost() if transfer or isinstance(error, FutureCancelledError) else error
