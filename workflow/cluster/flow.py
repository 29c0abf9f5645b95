"""Stream items through the cluster: a bounded window, refilled in bulk, gathered in batches.

Nothing here waits for a process that may have been stopped: whatever asks one is a call in a
thread, and what a worker keeps is computed elsewhere.
"""

import math
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import partial
from itertools import islice
from typing import Any

from dask.utils import funcname
from distributed import Client, Future, as_completed
from distributed.scheduler import KilledWorker

from ..errors import UserError
from .calls import Call, Clock, Fetches
from .crew import SILENT_SECONDS, RollCalls
from .flight import Flight, Retry, Work, raise_error
from .watch import BEAT_SECONDS, NO_ANSWER, NO_SIGN, QUIET_SECONDS, Watch, say
from .worker import placed

PER_THREAD, LEAST = 4, 8  # items in flight
STOP_SECONDS = 10.0  # that running items are awaited after a stop


def stream(
    client: Client,
    function: Callable,
    items: Iterable[Any],
    watch: Watch | None = None,
    retry: Retry = raise_error,
    *,
    clock: Clock = time,
    completed: Callable[..., Any] = as_completed,
    call: Callable[..., Call] = Call,
) -> Iterator[tuple[Any, Any]]:
    """Yield (item, function(item)) as they finish; once watch() is true, only what is running.

    At most a few items per worker thread are in flight, so memory does not grow with the
    study. An item that raises is tried on another worker, for which it waits where one was lost a
    moment ago; ``retry`` returns what to do instead of one that failed on two, or twice on the
    only one. What follows a killed worker is done last, one item at a time, so that the item to
    blame is certain. An item whose worker falls silent is computed a second time on another; the
    first result counts. What runs when a stop is asked for is awaited for STOP_SECONDS at most.
    Raises UserError when the scheduler is lost, or patience ends. ``clock``, ``completed``
    (distributed.as_completed) and ``call`` are others in a simulation.
    """
    running, placing = completed([], loop=client.loop), partial(placed, function=function)
    watch = watch or Watch()
    asking = RollCalls(client, watch, clock, call), Fetches(client, clock, call)
    how = (placing, funcname(function), iter(items), watch, retry)
    return iter(_Stream(client, *how, clock, running, *asking))


@dataclass
class _Stream:
    client: Client
    function: Callable
    name: str
    source: Iterator[Any]
    watch: Watch
    retry: Retry
    clock: Clock
    running: Any  # of distributed.as_completed
    rolls: RollCalls
    fetches: Fetches
    flight: Flight = field(default_factory=Flight)
    again: list[Work] = field(default_factory=list)  # before the rest of the source
    alone: list[Work] = field(default_factory=list)  # after it
    left: list[Future] = field(default_factory=list)  # copies that nobody waits for any more
    looked: float = float("-inf")
    stop_seen: float = math.inf  # when it was asked for
    isolated: bool = False  # what is in flight is alone there
    window: int = LEAST

    def __iter__(self) -> Iterator[tuple[Any, Any]]:
        self._tick()
        while not (self.rolls.answered() or self.watch()):
            self.fetches.rest()
            self._tick()
        self._submit()
        try:
            while self.flight or (self.again and not self.watch()):
                ended = self.running.next_batch(block=False)
                self.fetches.begin([f for f in ended if f.key in self.flight.works])
                del ended
                done = self._take()
                if not done:
                    self.fetches.rest()
                self._tick()
                self._submit()
                yield from done
        finally:
            if self.left:
                self.client.cancel(self.left)

    def _submit(self) -> None:
        """Fill the window from what is to be done again and the source; then one alone."""
        free = self.window - len(self.flight)
        if self.watch() or free <= self.window // 8 or (self.isolated and self.flight):
            return  # refilled in bulk
        fresh = self.again[:free]
        del self.again[:free]
        fresh += map(Work, islice(self.source, free - len(fresh)))
        self.isolated = self.isolated and len(fresh) < 2
        if not fresh and not self.flight and self.alone:
            fresh, self.isolated = [self.alone.pop()], True
        crew = self.rolls.crew
        self._send([w for w in fresh if not w.failed], crew.fit() if crew.left_out else [])
        for work in fresh:
            if work.failed and crew.awaits(work.failed):
                self.again.append(work)
            elif work.failed:
                self._send([work], work.workers(crew))

    def _send(self, works: list[Work], workers: list[str]) -> None:
        """Submit works, for some workers alone if there are any.

        As a mere wish it would be of no use: idle workers steal, and who fails is soon idle.
        """
        if works:
            where: dict[str, Any] = {"workers": workers} if workers else {}
            items = [work.item for work in works]
            futures = self.client.map(self.function, items, pure=False, key=self.name, **where)
            for work, future in zip(works, futures, strict=True):
                self.flight.add(work, future, workers)
            self.running.update(futures)

    def _take(self) -> list[tuple[Any, Any]]:
        """Return (item, result) of what has come, and note what to do instead of what failed."""
        done: list[tuple[Any, Any]] = []
        for found in self.fetches.done():
            for key, (address, result) in found.results.items():
                if work := self.flight.works.get(key):  # else a copy of it was faster
                    self.left += self.flight.drop(work)
                    self.rolls.crew.succeeded(address, work.failed)
                    done.append((work.item, result))
            for key, (address, error) in found.errors.items():
                self._fail(key, address, error)
        return done

    def _fail(self, key: str, address: str, error: Exception) -> None:
        """Note what to do instead of an item that failed on a worker."""
        work = self.flight.fall(key)
        if work is None:
            return
        work.fail(address, error)
        if not work.lost(self.rolls.crew.silent):
            return  # another copy may go well
        if isinstance(error, UserError) or not work.to_be_tried_again(self.rolls.crew):
            self.left += self.flight.drop(work)
            instead = map(Work, self.retry(work.item, error, self.isolated))
            (self.alone if isinstance(error, KilledWorker) else self.again).extend(instead)
        elif not work.copies:  # or else at the next look
            self.again.append(work)

    def _tick(self) -> None:
        """Now and then look at the workers, and at what they do."""
        now, stopping = self.clock.monotonic(), self.watch()
        if self.rolls.tick(stopping):
            self._look_after()
        if now - self.looked >= BEAT_SECONDS:
            self.looked = now
            unanswered, crew = self.rolls.unanswered(), self.rolls.crew
            if stopping:
                self.stop_seen = min(self.stop_seen, now)
                all_of_it = unanswered or now - self.stop_seen >= STOP_SECONDS
                self._leave([*self.flight.works.values()] if all_of_it else self.flight.lost(crew))
            lack = NO_ANSWER if unanswered else NO_SIGN if crew.all_quiet() else ""
            self.watch.look(crew.threads(), len(self.flight), lack)

    def _look_after(self) -> None:
        """Compute elsewhere what does not come; after a stop, shed what no worker has begun."""
        crew, stopping = self.rolls.crew, self.rolls.stopping
        self.window = max((2 if crew.left_out else PER_THREAD) * crew.threads(), LEAST)
        self.flight.note(crew)
        self.flight.stick(self.fetches.overdue(QUIET_SECONDS if stopping else SILENT_SECONDS))
        for future, error in self.flight.stranded(crew):
            self.left.append(future)
            self._fail(str(future.key), "", error)
        if stopping:
            for work in self.flight.unbegun(crew):
                self.left += self.flight.drop(work)
        else:
            for work, workers in self.flight.second_copies(crew):
                self._send([work], workers)

    def _leave(self, works: list[Work]) -> None:
        """After a stop, do not wait for what does not come."""
        left = dict.fromkeys(works)
        if left:
            say(f"left behind: {len(left)} batches that were not done in time")
        for work in left:
            self.left += self.flight.drop(work)
