"""Stream items through the cluster: a bounded window, refilled in bulk, gathered in batches."""

import time
from collections.abc import Callable, Hashable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import islice
from typing import Any, Protocol

from distributed import Client, Future, as_completed
from distributed.client import FutureCancelledError
from distributed.scheduler import KilledWorker

from workflow.cluster.watch import Watch
from workflow.errors import UserError

# What to do instead of an item that failed with an error, alone in the cluster or not.
Retry = Callable[[Any, Exception, bool], list[Any]]


class Clock(Protocol):
    """What tells the time: the module time, or a simulation."""

    def monotonic(self) -> float:
        """Return the time in s."""

    def sleep(self, seconds: float, /) -> None:
        """Let time pass."""


LOST = "the scheduler was lost; run again to resume"
POLL_SECONDS = 0.02
BEAT_SECONDS = 1.0
PER_THREAD, LEAST = 4, 8  # items in flight


def raise_error(item: Any, error: Exception, alone: bool) -> list[Any]:
    """Let an error on a worker end the stream; an item whose worker died gets another chance."""
    if isinstance(error, KilledWorker) and not alone:
        return [item]
    raise error


def stream(
    client: Client,
    function: Callable,
    items: Iterable[Any],
    watch: Watch | None = None,
    retry: Retry = raise_error,
    *,
    clock: Clock = time,
    completed: Callable[..., Any] = as_completed,
) -> Iterator[tuple[Any, Any]]:
    """Yield (item, function(item)) as they finish; once watch() is true, only what is running.

    At most a few items per worker thread are in flight, so memory does not grow with the
    study. ``retry`` returns what to do instead of an item that failed; what follows a killed
    worker is done last, one item at a time, so that the item to blame is certain. Raises
    UserError when the scheduler is lost. ``clock`` and ``completed`` (distributed.as_completed)
    are others in a simulation.
    """
    running = completed([], loop=client.loop)
    return iter(_Stream(client, function, iter(items), watch or Watch(), retry, clock, running))


@dataclass
class _Stream:
    client: Client
    function: Callable
    source: Iterator[Any]
    watch: Watch
    retry: Retry
    clock: Clock
    running: Any  # of distributed.as_completed
    again: list[Any] = field(default_factory=list)  # before the rest of the source
    alone: list[Any] = field(default_factory=list)  # after it
    pending: dict[Hashable, tuple[Future, Any]] = field(default_factory=dict)  # by key
    isolated: bool = False  # what is in flight is alone there
    window: int = LEAST
    shedding: bool = False
    last_beat: float = 0.0

    def __iter__(self) -> Iterator[tuple[Any, Any]]:
        self._tick()
        if not self.watch():
            self._submit()
        while self.pending:
            finished = self.running.next_batch(block=False)
            done = self._take([future for future in finished if future.key in self.pending])
            if not finished:
                self.clock.sleep(POLL_SECONDS)
            del finished
            self._tick()
            if not self.watch():
                self._submit()
            yield from done

    def _submit(self) -> None:
        """Fill the window from what is to be done again and the source; then one alone."""
        free = self.window - len(self.pending)
        if free <= self.window // 8 or (self.isolated and self.pending):
            return  # refilled in bulk
        fresh = self.again[:free]
        del self.again[:free]
        fresh += islice(self.source, free - len(fresh))
        self.isolated = False if fresh else self.isolated
        if not fresh and not self.pending and self.alone:
            fresh, self.isolated = [self.alone.pop()], True
        if not fresh:
            return
        futures = self.client.map(self.function, fresh, pure=False)
        self.pending |= {f.key: (f, item) for f, item in zip(futures, fresh, strict=True)}
        self.running.update(futures)

    def _take(self, futures: list[Future]) -> list[tuple[Any, Any]]:
        """Return (item, result) of what went well, and note what to do instead of the rest."""
        if any(future.status in ("cancelled", "lost") for future in futures):
            raise UserError(LOST)
        while True:
            failed = [future for future in futures if future.status == "error"]
            sound = [future for future in futures if future not in failed]
            try:
                results = self.client.gather(sound)
                break
            except (FutureCancelledError, OSError) as error:
                raise UserError(LOST) from error
            except Exception:  # a result was lost with its worker, and failed the second time
                if all(future.status != "error" for future in sound):
                    raise
        done = [(self.pending.pop(f.key)[1], r) for f, r in zip(sound, results, strict=True)]
        for future in failed:
            item, raised = self.pending.pop(future.key)[1], future.exception()
            killed = isinstance(raised, KilledWorker)
            (self.alone if killed else self.again).extend(self.retry(item, raised, self.isolated))
        return done

    def _tick(self) -> None:
        """Now and then look at the workers; shed what no worker has begun after a stop."""
        stopping = self.watch()
        if self.shedding == stopping and self.clock.monotonic() - self.last_beat < BEAT_SECONDS:
            return
        self.shedding = stopping
        try:
            threads = sum(self.client.nthreads().values())
            if stopping:
                self._shed()
        except OSError as error:
            raise UserError(LOST) from error
        self.window = max(PER_THREAD * threads, LEAST)
        self.watch.look(threads, len(self.pending))
        self.last_beat = self.clock.monotonic()

    def _shed(self) -> None:
        """Take back what no worker has yet, so that an interrupted run ends soon."""
        begun = {key for keys in self.client.processing().values() for key in keys}
        waiting = [future for key, (future, _) in self.pending.items() if key not in begun]
        for future in waiting:
            del self.pending[future.key]
        self.client.cancel(waiting)
