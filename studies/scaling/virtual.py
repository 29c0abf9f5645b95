"""A cluster in virtual time, behind the interface of a Pool of workers.

Nothing runs: a task takes the seconds that ``duration`` says of its item. Driver and scheduler
are one server each, first come, first served, with so many seconds per task; a worker is idle
from its last task until the scheduler's next message has reached it. This is the cluster of
``distributed.scheduler.worker-saturation = 1``, where no task waits on a worker.
"""

from collections import deque
from collections.abc import Callable, Collection, Iterable
from concurrent.futures import Future
from heapq import heappop, heappush
from itertools import count
from operator import pos
from typing import Any, NamedTuple

import numpy as np

from elastomer_friction.workflow.cluster import Arrival, Snapshot, stream

SPREAD = 0.5  # of a task's time, about its mean, each way
BEGAN = 1000.0  # s; no clock of a machine starts at zero with a program, and flow looks at once


class Costs(NamedTuple):
    """What one task costs besides its own time (s)."""

    scheduler: float  # half when it is submitted, half when it is done
    driver: float  # gathering, storing, refilling
    latency: float  # of a message between two processes


class VirtualPool:
    """Stands in for a Pool of workers; ``now`` is the driver's clock (s)."""

    def __init__(
        self, workers: int, costs: Costs, duration: Callable[[Any], float], function: Callable
    ) -> None:
        self.workers, self.costs, self.duration = workers, costs, duration
        self.function = function
        self.now = BEGAN
        self.busy = 0.0  # worker-seconds spent on tasks
        self.tasks = 0  # done
        self._answer: Future[Snapshot] = Future()
        self._answer.set_result(Snapshot({str(number): 1 for number in range(workers)}))
        self._idle = workers
        self._server = 0.0  # when the scheduler will have dealt with all messages it has
        self._numbers = count()
        self._queue: deque[tuple[str, Any]] = deque()  # keys and items at the scheduler
        # messages on their way there: (arrival, number, keys and items, whether they are done)
        self._messages: list[tuple[float, int, list[tuple[str, Any]], bool]] = []
        self._news: deque[tuple[float, Arrival]] = deque()  # (arrival at the driver, what is done)

    @property
    def efficiency(self) -> float:
        """Busy worker time over workers times the time that has passed."""
        return self.busy / (self.workers * self.wall)

    @property
    def wall(self) -> float:
        """Time that has passed (s)."""
        return self.now - BEGAN

    def ask(self) -> "Future[Snapshot]":
        """Return who the workers are, all of them alive."""
        return self._answer

    def submit(self, items: Iterable[Any], workers: Collection[str] = ()) -> list[str]:
        """Submit tasks, which any worker may have."""
        assert not workers
        tasks = [(str(next(self._numbers)), item) for item in items]
        self._send(self.now, tasks, done=False)
        return [key for key, _ in tasks]

    def drop(self, keys: Collection[str]) -> None:
        """Forget tasks, of which there are none when all are done."""
        assert not keys

    def take(self, seconds: float) -> list[Arrival]:
        """Return what has come once something has, within so many seconds; charge the driver."""
        until = self.now + seconds
        while self._messages and self._messages[0][0] <= until and not self._heard():
            self._next_message()
            until = min([until, *(arrival for arrival, _ in self._news)])
        found = []
        self.now = max(self.now, until)
        while self._heard():
            found.append(self._news.popleft()[1])
        self.now += len(found) * self.costs.driver
        return found

    def _heard(self) -> bool:
        return bool(self._news) and self._news[0][0] <= self.now

    def monotonic(self) -> float:
        """Return the driver's time."""
        return self.now

    def _send(self, time: float, tasks: list[tuple[str, Any]], done: bool) -> None:
        message = (time + self.costs.latency, next(self._numbers), tasks, done)
        heappush(self._messages, message)

    def _next_message(self) -> None:
        """Let the scheduler deal with its next message, then give work to idle workers."""
        arrival, _, tasks, done = heappop(self._messages)
        begin = max(self._server, arrival)
        self._server = begin + 0.5 * self.costs.scheduler * len(tasks)
        if done:
            self._idle += 1
            self.tasks += 1
            ((key, item),) = tasks
            outcome = Arrival(key, value=self.function(item))
            self._news.append((self._server + self.costs.latency, outcome))
        else:
            self._queue.extend(tasks)
        while self._queue and self._idle:
            self._idle -= 1
            key, item = self._queue.popleft()
            seconds = self.duration(item)
            self.busy += seconds
            self._send(self._server + self.costs.latency + seconds, [(key, item)], done=True)


def simulated(workers: int, items: list[float], costs: Costs) -> VirtualPool:
    """Return virtual workers that have done tasks of these durations (s)."""
    pool = VirtualPool(workers, costs, pos, pos)
    for _ in stream(pool, items):
        pass
    return pool


def durations(seconds: float, tasks: int, seed: int) -> list[float]:
    """Return times of tasks (s), uniform about their mean."""
    spread = np.random.default_rng(seed).uniform(1.0 - SPREAD, 1.0 + SPREAD, tasks)
    return (seconds * spread).tolist()
