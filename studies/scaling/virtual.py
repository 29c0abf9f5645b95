"""A cluster in virtual time, behind the interface that the stream of work uses of dask's Client.

Nothing runs: a task takes the seconds that ``duration`` says of its item. Driver and scheduler
are one server each, first come, first served, with so many seconds per task; a worker is idle
from its last task until the scheduler's next message has reached it. This is the cluster of
``distributed.scheduler.worker-saturation = 1``, where no task waits on a worker.
"""

import math
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from heapq import heappop, heappush
from itertools import count
from operator import pos
from types import SimpleNamespace
from typing import Any, NamedTuple, cast

import numpy as np
from distributed import Client

from elastomer_friction.workflow.cluster import ROLL, Call, Roll, stream

SPREAD = 0.5  # of a task's time, about its mean, each way
BEGAN = 1000.0  # s; no clock of a machine starts at zero with a program, and flow looks at once


class Costs(NamedTuple):
    """What one task costs besides its own time (s)."""

    scheduler: float  # half when it is submitted, half when it is done
    driver: float  # gathering, storing, refilling
    latency: float  # of a message between two processes


class VirtualFuture(NamedTuple):
    """A task on the virtual cluster; whoever is told of it is told that it is done."""

    key: str
    function: Callable
    item: Any
    status: str = "finished"


class VirtualClient:
    """Stands in for distributed.Client and as_completed; ``now`` is the driver's clock (s)."""

    loop = None

    def __init__(self, workers: int, costs: Costs, duration: Callable[[Any], float]) -> None:
        self.workers, self.costs, self.duration = workers, costs, duration
        self.now = BEGAN
        self.busy = 0.0  # worker-seconds spent on tasks
        self.tasks = 0  # done
        self._roll = Roll({str(number): 1 for number in range(workers)}, {}, {})
        self.scheduler = SimpleNamespace(**{ROLL: self._call_roll})
        self._idle = workers
        self._server = 0.0  # when the scheduler will have dealt with all messages it has
        self._numbers = count()
        self._queue: deque[VirtualFuture] = deque()  # at the scheduler
        # messages on their way to the scheduler: (arrival, number, futures, whether they are done)
        self._messages: list[tuple[float, int, list[VirtualFuture], bool]] = []
        self._news: deque[tuple[float, VirtualFuture]] = deque()  # (arrival at the driver, done)

    @property
    def efficiency(self) -> float:
        """Busy worker time over workers times the time that has passed."""
        return self.busy / (self.workers * self.wall)

    @property
    def wall(self) -> float:
        """Time that has passed (s)."""
        return self.now - BEGAN

    def run_on_scheduler(self, function: Callable) -> None:
        """Run nothing."""

    def sync(self, function: Callable[[], Any]) -> Any:
        """Return what a function of the scheduler returns."""
        return function()

    def _call_roll(self) -> Roll:
        """Return the roll of the workers, all of them alive."""
        return self._roll._replace(heard=dict.fromkeys(self._roll.threads, self.now))

    def map(self, function: Callable, items: Iterable[Any], **_: Any) -> list[VirtualFuture]:
        """Submit tasks."""
        futures = [VirtualFuture(str(next(self._numbers)), function, item) for item in items]
        if futures:
            self._send(self.now, futures, done=False)
        return futures

    def gather(self, futures: list[VirtualFuture]) -> list[Any]:
        """Return results of finished tasks, and charge the driver for them."""
        self.now += len(futures) * self.costs.driver
        return [future.function(future.item) for future in futures]

    def update(self, futures: list[VirtualFuture]) -> None:
        """Wait for these too; the driver is told of all there are anyway."""

    def next_batch(self, block: bool) -> list[VirtualFuture]:
        """Return the tasks of whose end the driver hears since it asked last, perhaps none."""
        while self._messages and self._messages[0][0] <= self.now:
            self._next_message()
        heard = []
        while self._news and self._news[0][0] <= self.now:
            heard.append(self._news.popleft()[1])
        return heard

    def monotonic(self) -> float:
        """Return the driver's time."""
        return self.now

    def sleep(self, seconds: float) -> None:
        """Pass the driver's time, and as many such sleeps at once as would bring no news."""
        while self._messages and not self._news:
            self._next_message()
        until = self._news[0][0] if self._news else self.now
        self.now += seconds * max(1, math.ceil((until - self.now) / seconds))

    def _send(self, time: float, futures: list[VirtualFuture], done: bool) -> None:
        message = (time + self.costs.latency, next(self._numbers), futures, done)
        heappush(self._messages, message)

    def _next_message(self) -> None:
        """Let the scheduler deal with its next message, then give work to idle workers."""
        arrival, _, futures, done = heappop(self._messages)
        begin = max(self._server, arrival)
        self._server = begin + 0.5 * self.costs.scheduler * len(futures)
        if done:
            self._idle += 1
            self.tasks += 1
            self._news.append((self._server + self.costs.latency, futures[0]))
        else:
            self._queue.extend(futures)
        while self._queue and self._idle:
            self._idle -= 1
            future = self._queue.popleft()
            seconds = self.duration(future.item)
            self.busy += seconds
            self._send(self._server + self.costs.latency + seconds, [future], done=True)


class AtOnce(Call):
    """A call that has returned when it is made."""

    def __init__(self, function: Callable, *arguments: Any) -> None:
        self._value = function(*arguments)

    def wait(self, seconds: float) -> bool:
        """Return that it has returned."""
        del seconds
        return True

    def result(self) -> Any:
        """Return what the call has returned."""
        return self._value


def virtual_stream(
    client: VirtualClient, function: Callable[[Any], Any], items: Iterable[Any]
) -> Iterator[tuple[Any, Any]]:
    """Let the workflow stream its work through a virtual cluster, by its clock."""
    real = cast(Client, client)  # of its interface the stream uses what is above
    return stream(
        real, function, items, clock=client, completed=lambda *_, **__: client, call=AtOnce
    )


def simulated(workers: int, items: list[float], costs: Costs) -> VirtualClient:
    """Return a virtual cluster that has done tasks of these durations (s)."""
    client = VirtualClient(workers, costs, pos)
    for _ in virtual_stream(client, pos, items):
        pass
    return client


def durations(seconds: float, tasks: int, seed: int) -> list[float]:
    """Return times of tasks (s), uniform about their mean."""
    spread = np.random.default_rng(seed).uniform(1.0 - SPREAD, 1.0 + SPREAD, tasks)
    return (seconds * spread).tolist()
