"""The workers of a dask client: what they are given, what comes of it, and who they are.

Nothing here waits for a process that may have been stopped: whatever is asked of one is awaited
in the loop of the client.
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
from .worker import PLACE, with_address

LOST = "the scheduler was lost; run again to resume"
FETCH_SECONDS = 30.0  # for a result to come from its worker, before it is computed again


class ResultLost(Exception):
    """A result that did not come from the worker that has it."""


class Arrival(NamedTuple):
    """What became of an item."""

    key: str
    address: str = ""  # of the worker, if anybody knows it
    value: Any = None
    error: Exception | None = None


class Snapshot(NamedTuple):
    """What the scheduler knows of its workers, by address."""

    threads: dict[str, int]
    ready: Collection[str] = ()  # who takes up work; the others are short of memory
    begun: Mapping[str, str] = {}  # by key of what is on a worker: its address


class Pool:
    """Workers that apply a function to items."""

    monotonic = staticmethod(time.monotonic)

    def __init__(self, client: Client, function: Callable) -> None:
        self._client, self._loop = client, cast(Any, client.loop).asyncio_loop
        self._function, self._name = partial(with_address, function=function), funcname(function)
        self._futures: dict[str, Future] = {}  # that are waited for
        self._arrivals: SimpleQueue[Arrival] = SimpleQueue()

    def submit(self, items: Iterable[Any], workers: Collection[str] = ()) -> list[str]:
        """Give out items, to some workers alone if any are named; return their keys."""
        where: dict[str, Any] = {"workers": [*workers]} if workers else {}
        futures = self._client.map(self._function, [*items], pure=False, key=self._name, **where)
        self._futures |= {str(future.key): future for future in futures}
        for future in futures:
            future.add_done_callback(self._fetch_soon)
        return [str(future.key) for future in futures]

    def take(self, seconds: float) -> list[Arrival]:
        """Return what has come, as soon as something has, or nothing after so many seconds."""
        found = []
        with contextlib.suppress(Empty):
            found.append(self._arrivals.get(timeout=seconds))
            found += [self._arrivals.get_nowait() for _ in range(self._arrivals.qsize())]
        return [arrival for arrival in found if self._futures.pop(arrival.key, None)]

    def drop(self, keys: Iterable[str]) -> None:
        """Wait for some items no more; what no worker has begun is not computed."""
        for key in keys:
            if future := self._futures.pop(key, None):
                future.release()

    def pending(self, key: str) -> bool:
        """Return whether no worker has done an item yet."""
        return self._futures[key].status == "pending"

    def ask(self) -> "concurrent.futures.Future[Snapshot]":
        """Ask the scheduler for a snapshot. The answer raises UserError where it is lost."""
        return asyncio.run_coroutine_threadsafe(self._snapshot(), self._loop)

    async def _snapshot(self) -> Snapshot:
        scheduler: Any = self._client.scheduler
        try:
            threads, ready, begun = await asyncio.gather(
                scheduler.ncores(), scheduler.ncores_running(), scheduler.processing()
            )
        except OSError as error:
            raise UserError(LOST) from error
        where = {str(key): address for address, keys in begun.items() for key in keys}
        return Snapshot(threads, ready, where)

    def _fetch_soon(self, future: Future) -> None:
        if future.key in self._futures:
            asyncio.run_coroutine_threadsafe(self._fetch(future), self._loop)

    async def _fetch(self, future: Future) -> None:
        key = str(future.key)
        arrival = Arrival(key, error=ResultLost())
        try:
            arrival = Arrival(key, *await asyncio.wait_for(future, FETCH_SECONDS))
        except FutureCancelledError:
            arrival = Arrival(key, error=UserError(LOST))
        except Exception as error:
            if future.status == "error" or not isinstance(error, OSError):
                arrival = Arrival(key, getattr(error, PLACE, ""), error=error)
        finally:
            self._arrivals.put(arrival)
