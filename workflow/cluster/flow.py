"""Stream of items through the workers. The number of items in flight is bounded by a window."""

import math
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import islice
from types import SimpleNamespace
from typing import Any, cast

from distributed.scheduler import KilledWorker

from ..ground import UserError
from ..system import BEAT_SECONDS, NO_ANSWER, QUIET_SECONDS, Watch, say
from .blame import Blame
from .pool import ResultLost, Snapshot

ITEMS_PER_THREAD, MIN_WINDOW = 4, 8  # items in flight
BOUND_ITEMS_PER_THREAD = (
    2  # while workers are excluded: items are then bound to workers and cannot move
)
TAKE_SECONDS = 0.2  # longest wait for an arrival before the stop flag is checked
STOP_SECONDS = 10.0  # longest wait for running items after a stop
MAX_WORKER_DEATHS = 3  # caused by one item before it is given up; dask has the same limit

# Called with (item, error, whether the item ran alone); returns the items to compute instead.
Retry = Callable[[Any, Exception, bool], list[Any]]


def raise_error(item: Any, error: Exception, alone: bool) -> list[Any]:
    """Raise the error of an item; if its workers died, retry it once alone instead."""
    if isinstance(error, KilledWorker) and not alone:
        return [item]
    raise error


def stream(
    pool: Any,
    items: Iterable[Any],
    watch: Watch | None = None,
    retry: Retry = raise_error,
    blame: Blame | None = None,
) -> Iterator[tuple[Any, Any]]:
    """Yield (item, result) in order of arrival.

    At most a few items per worker thread are in flight, so that memory does not grow with the
    study. An item that raises is retried on another worker; it waits if a suitable worker may soon
    connect. An item that failed on two workers, or twice on the only worker, is passed to
    ``retry``, which returns its replacements. So is an item whose workers died several times; its
    replacements run last and one at a time, to identify the item that kills workers. Once
    ``watch()`` returns True, no item starts, and running items are awaited for at most
    STOP_SECONDS. Raises UserError if the scheduler is lost, or when the patience of ``watch`` ends.

    pool : a Pool, or its stand-in in tests. blame : state of the workers from earlier streams.
    """
    return iter(_Stream(pool, iter(items), watch or Watch(), retry, blame or Blame()))


@dataclass
class _Work:
    """An item with its failures and its worker."""

    item: Any
    failed: list[str] = field(default_factory=list)  # addresses at which it raised; "": unknown
    deaths: int = 0  # number of its workers that died
    workers: Collection[str] = ()  # addresses of allowed workers; empty: all
    worker: str = ""  # address of its worker in the last snapshot


@dataclass
class _Stream:
    pool: Any
    source: Iterator[Any]
    watch: Watch
    retry: Retry
    blame: Blame
    in_flight: dict[str, _Work] = field(default_factory=dict)  # by key
    again: list[_Work] = field(default_factory=list)  # submitted before the rest of the source
    alone: list[_Work] = field(default_factory=list)  # submitted after the source, one at a time
    isolated: bool = False  # whether the item in flight was submitted alone
    window: int = MIN_WINDOW  # largest number of items in flight
    answer: Any = None  # future of the next snapshot
    requested: float = -math.inf  # time of the last request for a snapshot, s
    checked: float = -math.inf  # time of the last check, s
    stopped: float = math.inf  # time of the stop, s

    def __iter__(self) -> Iterator[tuple[Any, Any]]:
        try:
            self._look()
            self._submit()
            while self.in_flight or (self.again and not self.watch()):
                done = self._take()
                self._look()
                self._submit()
                yield from done
        finally:
            self.pool.drop(self.in_flight)

    def _submit(self) -> None:
        """Fill the window with retries and new items; if none are left, submit one item alone."""
        free = self.window - len(self.in_flight)
        if self.watch() or free <= self.window // 8 or (self.isolated and self.in_flight):
            return  # the window is refilled in bulk
        works = self.again[:free]
        del self.again[:free]
        works += map(_Work, islice(self.source, free - len(works)))
        self.isolated = self.isolated and len(works) < 2
        if not works and not self.in_flight and self.alone:
            works, self.isolated = [self.alone.pop()], True
        blame = self.blame
        self._send([w for w in works if not w.failed], blame.fit() if blame.excluded else [])
        for work in works:
            if work.failed and blame.awaited(work.failed):
                self.again.append(work)
            elif work.failed:
                self._send([work], blame.fit(work.failed))

    def _send(self, works: list[_Work], workers: list[str]) -> None:
        """Submit items, restricted to ``workers`` unless it is empty.

        A mere preference does not suffice: idle workers steal items, and a sick worker is idle.
        """
        if works:
            keys = self.pool.submit([work.item for work in works], workers)
            for key, work in zip(keys, works, strict=True):
                work.workers = workers
                self.in_flight[key] = work

    def _take(self) -> list[tuple[Any, Any]]:
        """Return the arrived (item, result) pairs, and reschedule failed items."""
        done: list[tuple[Any, Any]] = []
        for arrival in self.pool.take(TAKE_SECONDS):
            work = self.in_flight.pop(arrival.key)
            if arrival.error:
                self._fail(work, arrival.error, arrival.address)
            else:
                self.blame.succeeded(arrival.address, work.failed)
                done.append((work.item, arrival.value))
        return done

    def _fail(self, work: _Work, error: Exception, address: str = "") -> None:
        """Schedule the retry or replacement of an item that failed or whose worker died."""
        if isinstance(error, KilledWorker):
            work.deaths = max(work.deaths, error.allowed_failures) + 1
        elif not isinstance(error, ResultLost):
            work.failed.append(address)
        given_up = work.deaths > MAX_WORKER_DEATHS or self.blame.to_be_given_up(work.failed)
        if given_up or isinstance(error, UserError):
            replacements = map(_Work, self.retry(work.item, error, self.isolated))
            (self.alone if isinstance(error, KilledWorker) else self.again).extend(replacements)
        else:
            self.again.append(work)

    def _look(self) -> None:
        """Once a second, request a snapshot of the workers and report to the watch."""
        now, stopping = self.pool.monotonic(), self.watch()
        if stopping:
            self.stopped = min(self.stopped, now)
        if self.answer is not None and self.answer.done():
            self._note(self.answer.result(), now)
            self.answer = None
        due = now - self.checked >= BEAT_SECONDS
        if self.answer is None and (
            due or self.requested < self.stopped <= now
        ):  # at once after a stop
            self.answer, self.requested = self.pool.request_snapshot(), now
        if not due:
            return
        self.checked = now
        silent = now - self.requested >= QUIET_SECONDS
        if self.in_flight and (now - self.stopped >= STOP_SECONDS or (stopping and silent)):
            say(f"abandoned: {len(self.in_flight)} batches that did not finish in time")
            self._drop([*self.in_flight])
        threads = sum(self.blame.now.threads.values())
        self.watch.look(threads, len(self.in_flight), NO_ANSWER if silent else "")

    def _note(self, snapshot: Snapshot, now: float) -> None:
        """Update the state of the workers; resubmit the items of lost workers.

        Dask resubmits them too, but does not count the loss of workers that retire, for instance at
        the end of a job. After a stop, drop the items that are not on a worker in the snapshot.
        """
        blame = self.blame
        blame.note(snapshot, now)
        per_thread = BOUND_ITEMS_PER_THREAD if blame.excluded else ITEMS_PER_THREAD
        self.window = max(per_thread * sum(snapshot.threads.values()), MIN_WINDOW)
        for key, work in [*self.in_flight.items()]:
            lost = work.workers or {work.worker} - {""}
            work.worker = snapshot.running.get(key, "")
            if lost and snapshot.threads.keys().isdisjoint(lost):
                self._drop([key])
                last = cast(Any, SimpleNamespace(address=" or ".join(lost)))
                self._fail(work, KilledWorker(key, last, work.deaths))
        if self.requested >= self.stopped:
            waiting = self.in_flight.keys() - snapshot.running.keys()
            self._drop([key for key in waiting if self.pool.pending(key)])

    def _drop(self, keys: list[str]) -> None:
        """Stop waiting for items."""
        self.pool.drop(keys)
        for key in keys:
            del self.in_flight[key]
