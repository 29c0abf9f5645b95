"""Stream items through the workers: a bounded window of them, refilled in bulk."""

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

PER_THREAD, LEAST = 4, 8  # items in flight
FEW_PER_THREAD = 2  # where each item is for some workers alone, so that others may still have it
POLL_SECONDS = 0.2  # at most between looks at whether to stop
STOP_SECONDS = 10.0  # that running items are awaited after a stop
DEATHS = 3  # of workers that an item survives, as dask's

# What to do instead of an item that failed with an error, alone in the cluster or not.
Retry = Callable[[Any, Exception, bool], list[Any]]


def raise_error(item: Any, error: Exception, alone: bool) -> list[Any]:
    """Let an error on a worker end the stream; an item whose worker died gets another chance."""
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
    """Yield (item, result) as they come from a pool; once watch() is true, only what is running.

    At most a few items per worker thread are in flight, so memory does not grow with the study. An
    item that raises is tried on another worker, for which it waits where none is known yet or one
    was lost a moment ago; ``retry`` returns what to do instead of one that failed on two, or twice
    on the only one. What follows a killed worker is done last, one item at a time, so that the item
    to blame is certain. What runs when a stop is asked for is awaited for STOP_SECONDS at most.
    Raises UserError when the scheduler is lost, or patience ends.

    pool : a Pool, or what stands in for one in a simulation.
    blame : what earlier streams know of the workers.
    """
    return iter(_Stream(pool, iter(items), watch or Watch(), retry, blame or Blame()))


@dataclass
class _Work:
    """An item on its way."""

    item: Any
    failed: list[str] = field(default_factory=list)  # where it raised: addresses, or ""
    deaths: int = 0  # of workers that had it
    workers: Collection[str] = ()  # who alone may have it; none: anybody
    where: str = ""  # who has it: an address, when last looked


@dataclass
class _Stream:
    pool: Any
    source: Iterator[Any]
    watch: Watch
    retry: Retry
    blame: Blame
    in_flight: dict[str, _Work] = field(default_factory=dict)  # by key
    again: list[_Work] = field(default_factory=list)  # before the rest of the source
    alone: list[_Work] = field(default_factory=list)  # after it
    isolated: bool = False  # what is in flight is alone there
    window: int = LEAST
    answer: Any = None  # that is awaited: a future of a snapshot
    asked: float = -math.inf  # when
    looked: float = -math.inf  # when
    stopped: float = math.inf  # when that was asked for

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
        """Fill the window from what is to be done again and the source; then one alone."""
        free = self.window - len(self.in_flight)
        if self.watch() or free <= self.window // 8 or (self.isolated and self.in_flight):
            return  # refilled in bulk
        fresh = self.again[:free]
        del self.again[:free]
        fresh += map(_Work, islice(self.source, free - len(fresh)))
        self.isolated = self.isolated and len(fresh) < 2
        if not fresh and not self.in_flight and self.alone:
            fresh, self.isolated = [self.alone.pop()], True
        blame = self.blame
        self._send([w for w in fresh if not w.failed], blame.fit() if blame.left_out else [])
        for work in fresh:
            if work.failed and blame.awaited(work.failed):
                self.again.append(work)
            elif work.failed:
                self._send([work], blame.fit(work.failed))

    def _send(self, works: list[_Work], workers: list[str]) -> None:
        """Give out works, to some workers alone if there are any.

        As a mere wish it would be of no use: idle workers steal, and who fails is soon idle.
        """
        if works:
            keys = self.pool.submit([work.item for work in works], workers)
            for key, work in zip(keys, works, strict=True):
                work.workers = workers
                self.in_flight[key] = work

    def _take(self) -> list[tuple[Any, Any]]:
        """Return (item, result) of what has come, and note what to do instead of what failed."""
        done: list[tuple[Any, Any]] = []
        for arrival in self.pool.take(POLL_SECONDS):
            work = self.in_flight.pop(arrival.key)
            if arrival.error:
                self._fail(work, arrival.error, arrival.address)
            else:
                self.blame.succeeded(arrival.address, work.failed)
                done.append((work.item, arrival.value))
        return done

    def _fail(self, work: _Work, error: Exception, address: str = "") -> None:
        """Note what to do instead of an item that failed, or whose worker died."""
        if isinstance(error, KilledWorker):
            work.deaths = max(work.deaths, error.allowed_failures) + 1
        elif not isinstance(error, ResultLost):
            work.failed.append(address)
        given_up = work.deaths > DEATHS or self.blame.to_be_given_up(work.failed)
        if given_up or isinstance(error, UserError):
            instead = map(_Work, self.retry(work.item, error, self.isolated))
            (self.alone if isinstance(error, KilledWorker) else self.again).extend(instead)
        else:
            self.again.append(work)

    def _look(self) -> None:
        """Every second ask for the workers, and let the watch look."""
        now, stopping = self.pool.monotonic(), self.watch()
        if stopping:
            self.stopped = min(self.stopped, now)
        if self.answer is not None and self.answer.done():
            self._note(self.answer.result(), now)
            self.answer = None
        due = now - self.looked >= BEAT_SECONDS
        if self.answer is None and (due or self.asked < self.stopped <= now):  # soon after a stop
            self.answer, self.asked = self.pool.ask(), now
        if not due:
            return
        self.looked = now
        silent = now - self.asked >= QUIET_SECONDS
        if self.in_flight and (now - self.stopped >= STOP_SECONDS or (stopping and silent)):
            say(f"left behind: {len(self.in_flight)} batches that were not done in time")
            self._drop([*self.in_flight])
        threads = sum(self.blame.now.threads.values())
        self.watch.look(threads, len(self.in_flight), NO_ANSWER if silent else "")

    def _note(self, snapshot: Snapshot, now: float) -> None:
        """Note who is there; compute again what workers had that are gone.

        Dask would do so as well, but does not count those that retire, as a job's in good time.
        After a stop, shed what nobody had begun when the scheduler was asked.
        """
        blame = self.blame
        blame.note(snapshot, now)
        per_thread = FEW_PER_THREAD if blame.left_out else PER_THREAD
        self.window = max(per_thread * sum(snapshot.threads.values()), LEAST)
        for key, work in [*self.in_flight.items()]:
            gone = work.workers or {work.where} - {""}
            work.where = snapshot.begun.get(key, "")
            if gone and snapshot.threads.keys().isdisjoint(gone):
                self._drop([key])
                last = cast(Any, SimpleNamespace(address=" or ".join(gone)))
                self._fail(work, KilledWorker(key, last, work.deaths))
        if self.asked >= self.stopped:
            fresh = self.in_flight.keys() - snapshot.begun.keys()
            self._drop([key for key in fresh if self.pool.pending(key)])

    def _drop(self, keys: list[str]) -> None:
        """Wait for items no more."""
        self.pool.drop(keys)
        for key in keys:
            del self.in_flight[key]
