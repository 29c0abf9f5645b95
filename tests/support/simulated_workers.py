"""Workers in simulated time, and a scheduler, that do to a stream of work what they are told.

Workers of one thread fail, die, fall silent, pause and join. Tasks are assigned as dask does,
but stolen without mercy: who idles takes at once what waits on another worker and may be taken.
"""

from collections.abc import Callable, Collection
from dataclasses import dataclass, field
from functools import partial
from heapq import heappop, heappush
from itertools import count
from typing import Any

from distributed.scheduler import KilledWorker

from elastomer_friction.workflow.cluster.pool import Arrival

ALLOWED_FAILURES = 3  # deaths of workers that dask lets a task survive
GIVEN_UP = 45.0  # s after which dask gives up a worker of which it hears nothing: 30 to 60
LONGEST = 5000.0  # s: who is not done by then hangs
DIE = object()  # what becomes of an item that kills its worker


@dataclass(eq=False)
class Task:
    """A future, and what the scheduler knows of it."""

    key: str
    item: Any
    workers: Collection[str]  # who alone may have it; none: anybody
    deaths: int = 0


@dataclass(eq=False)
class Worker:
    """A worker; ``does`` returns the seconds that an item takes, and what becomes of it."""

    address: str
    does: Callable[[Any], tuple[float, Any]]
    processing: list[Task] = field(default_factory=list)
    computing: Task | None = None
    silent: bool = False
    held: list[Callable] = field(default_factory=list)  # what ended while it was silent


class Workers:
    """Does what dask's scheduler does, in the time of a simulation."""

    def __init__(self, **workers: Callable[[Any], tuple[float, Any]]) -> None:
        """``workers`` : what each does, by name; see ``at``."""
        self.now = 1000.0
        self.replaced: Callable | None = None  # what a worker does in the place of one that died
        self.workers: dict[str, Worker] = {}
        self.running: set[Worker] = set()
        self.unrunnable: dict[Task, float] = {}
        self.tried: list[tuple[Any, str]] = []  # (item, name of the worker) as they began
        self._events: list[tuple[float, int, Callable]] = []
        self.ended: list[Arrival] = []
        self.numbers = count()
        for name, does in workers.items():
            self.join(name, does)

    def after(self, seconds: float, happen: Callable, *arguments: Any) -> None:
        """Let something happen, so long from now."""
        event = partial(happen, *arguments)
        heappush(self._events, (self.now + seconds, next(self.numbers), event))

    def join(self, name: str, does: Callable[[Any], tuple[float, Any]]) -> None:
        """Let a worker join."""
        self.workers[at(name)] = Worker(at(name), does)
        self.wake(name)

    def retire(self, name: str) -> None:
        """Let a worker end in good order, which dask does not count: those of jobs do in time."""
        self.die(name, counted=False)

    def die(self, name: str, counted: bool = True) -> None:
        """Let a worker die, if it is there."""
        worker = self.workers.pop(at(name), None)
        if worker is None:
            return
        self.running.discard(worker)
        for task in worker.processing:
            task.deaths += counted
            if task.deaths > ALLOWED_FAILURES:
                killed = KilledWorker(task.key, worker, ALLOWED_FAILURES)
                self._end(Arrival(task.key, error=killed))
            else:
                self.assign(task)
        if self.replaced:
            self.after(0.5, self.join, f"{name[0]}{int(name[1:]) + 1}", self.replaced)

    def pause(self, name: str) -> None:
        """Let a worker take up nothing, as dask's do that are short of memory."""
        if at(name) in self.workers:
            self.running.discard(self.workers[at(name)])

    def hush(self, name: str) -> None:
        """Stop a worker as SIGSTOP does; it is thought to be there until it is given up."""
        if worker := self.workers.get(at(name)):
            worker.silent = True
            self.after(GIVEN_UP, self._give_up, worker)

    def _give_up(self, worker: Worker) -> None:
        if worker.silent:
            self.die(worker.address.rpartition(":")[2])

    def wake(self, name: str) -> None:
        """Let a worker go on."""
        worker = self.workers.get(at(name))
        if worker is None:
            return
        worker.silent, held, worker.held = False, worker.held, []
        self.running.add(worker)
        for happen in held:
            happen()
        for task in [*self.unrunnable]:
            del self.unrunnable[task]
            self.assign(task)
        self._go_on()

    def pass_by(self, seconds: float) -> None:
        """Let time pass, and happen what is to happen, until a task has ended."""
        until = self.now + seconds
        assert until < LONGEST, "hangs"
        while self._events and self._events[0][0] <= until and not self.ended:
            self.now, _, happen = heappop(self._events)
            happen()
            self._go_on()
        self.now = self.now if self.ended else until

    def assign(self, task: Task) -> None:
        """Give a task to whoever of those that may have it has least to do."""
        fit = [w for w in self.running if _may(task, w)]
        if fit:
            min(fit, key=lambda w: (len(w.processing), w.address)).processing.append(task)
            self._go_on()
        else:
            self.unrunnable[task] = self.now

    def forget(self, task: Task) -> None:
        """Let nobody begin a task that is not waited for."""
        self.unrunnable.pop(task, None)
        for worker in self.workers.values():
            if task in worker.processing and task is not worker.computing:
                worker.processing.remove(task)

    def _go_on(self) -> None:
        """Let who idles compute what it has, or steal."""
        for worker in sorted(self.running, key=lambda w: w.address):
            if worker.silent or worker.computing:
                continue
            if not worker.processing:
                self._steal(worker)
            if worker.processing:
                worker.computing = task = worker.processing[0]
                self.tried.append((task.item, worker.address.rpartition(":")[2]))
                seconds, value = worker.does(task.item)
                self.after(seconds, self._computed, worker, task, value)

    def _steal(self, thief: Worker) -> None:
        for victim in self.workers.values():
            for task in victim.processing:
                free = task is not victim.computing and not victim.silent
                if free and _may(task, thief):
                    victim.processing.remove(task)
                    thief.processing.append(task)
                    return

    def _computed(self, worker: Worker, task: Task, value: Any) -> None:
        if worker.silent:
            worker.held.append(partial(self._computed, worker, task, value))
        elif worker.address not in self.workers:
            return
        elif value is DIE:
            self.die(worker.address.rpartition(":")[2])
        else:
            worker.processing.remove(task)
            worker.computing = None
            failed = isinstance(value, Exception)
            how = {"error": value} if failed else {"value": value}
            self._end(Arrival(task.key, worker.address, **how))

    def _end(self, arrival: Arrival) -> None:
        self.ended.append(arrival)


def at(name: str) -> str:
    """Return the address of a worker: of its host if it has one, as in "host_1"."""
    host, _, _ = name.rpartition("_")
    return f"tls://{host or 'here'}:{name}"


def _may(task: Task, worker: Worker) -> bool:
    return not task.workers or worker.address in task.workers
