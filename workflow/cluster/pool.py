"""Pool of the workers of a dask client: submission, arrivals, and snapshots.

No call blocks if the scheduler or a worker has been stopped: requests are awaited in the event loop
of the client.
"""

import asyncio
import concurrent.futures
import contextlib
import time
from collections.abc import Callable, Collection, Iterable, Mapping
from functools import partial
from queue import Empty, SimpleQueue
from typing import Any, NamedTuple, cast

from dask.utils import funcname
from distributed import Client, Future
from distributed.client import FutureCancelledError

from ..ground import UserError
from .worker import ADDRESS_ATTRIBUTE, with_address

SCHEDULER_LOST = "the scheduler was lost; run again to resume"
FETCH_SECONDS = 30.0  # timeout for the transfer of a result, which is then recomputed


class ResultLost(Exception):
    """A result could not be fetched from its worker."""


class Arrival(NamedTuple):
    """The outcome of an item: a value or an error."""

    key: str
    address: str = ""  # address of the worker; "": unknown
    value: Any = None
    error: Exception | None = None


class Snapshot(NamedTuple):
    """The scheduler's view of its workers."""

    threads: dict[str, int]  # number of threads of each worker, by address
    ready: Collection[str] = ()  # addresses that accept work; the others are short of memory
    running: Mapping[str, str] = {}  # key of each item on a worker -> address of the worker


class Pool:
    """Workers that apply a function to items."""

    monotonic = staticmethod(time.monotonic)

    def __init__(self, client: Client, function: Callable) -> None:
        self._client, self._loop = client, cast(Any, client.loop).asyncio_loop
        self._function, self._name = partial(with_address, function=function), funcname(function)
        self._futures: dict[str, Future] = {}  # awaited items, by key
        self._arrivals: SimpleQueue[Arrival] = SimpleQueue()

    def submit(self, items: Iterable[Any], workers: Collection[str] = ()) -> list[str]:
        """Submit items, restricted to ``workers`` unless it is empty; return their keys."""
        restriction: dict[str, Any] = {"workers": [*workers]} if workers else {}
        futures = self._client.map(
            self._function, [*items], pure=False, key=self._name, **restriction
        )
        self._futures |= {str(future.key): future for future in futures}
        for future in futures:
            future.add_done_callback(self._fetch_soon)
        return [str(future.key) for future in futures]

    def take(self, seconds: float) -> list[Arrival]:
        """Wait for an arrival and return all that are there; return none after ``seconds``."""
        arrivals = []
        with contextlib.suppress(Empty):
            arrivals.append(self._arrivals.get(timeout=seconds))
            arrivals += [self._arrivals.get_nowait() for _ in range(self._arrivals.qsize())]
        return [arrival for arrival in arrivals if self._futures.pop(arrival.key, None)]

    def drop(self, keys: Iterable[str]) -> None:
        """Stop waiting for items; those that have not started are cancelled."""
        for key in keys:
            if future := self._futures.pop(key, None):
                future.release()

    def pending(self, key: str) -> bool:
        """Return whether an item is unfinished."""
        return self._futures[key].status == "pending"

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

    def _fetch_soon(self, future: Future) -> None:
        if future.key in self._futures:
            asyncio.run_coroutine_threadsafe(self._fetch(future), self._loop)

    async def _fetch(self, future: Future) -> None:
        key = str(future.key)
        arrival = Arrival(key, error=ResultLost())
        try:
            arrival = Arrival(key, *await asyncio.wait_for(future, FETCH_SECONDS))
        except FutureCancelledError:
            arrival = Arrival(key, error=UserError(SCHEDULER_LOST))
        except Exception as error:
            if future.status == "error" or not isinstance(error, OSError):
                arrival = Arrival(key, getattr(error, ADDRESS_ATTRIBUTE, ""), error=error)
        finally:
            self._arrivals.put(arrival)
