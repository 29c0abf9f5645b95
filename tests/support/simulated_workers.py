"""Workers and a scheduler in simulated time, with faults at given times.

Workers of one thread fail, die, fall silent, pause and join. Tasks are assigned as dask does, but
work stealing is immediate: an idle worker takes at once any task that waits on another worker.
"""

from collections.abc import Callable, Collection
from dataclasses import dataclass, field
from functools import partial
from heapq import heappop, heappush
from itertools import count
from typing import Any

from elastomer_friction.workflow.cluster import Arrival, WorkerDied

ALLOWED_FAILURES = 3  # number of workers that dask lets a task kill
GIVEN_UP = 45.0  # s, silence after which dask gives up a worker; 30 to 60 in dask
LONGEST = 5000.0  # s, time at which a simulation counts as hanging
DIE = object()  # result of an item that kills its worker


@dataclass(eq=False)
class Task:
    """A task of the scheduler."""

    key: str
    item: Any
    workers: Collection[str]  # addresses of the workers allowed to run it; empty: all
    deaths: int = 0  # number of workers that died with it


@dataclass(eq=False)
class Worker:
    """A worker; ``does`` returns the seconds that an item takes, and its result."""

    address: str
    does: Callable[[Any], tuple[float, Any]]
    processing: list[Task] = field(default_factory=list)  # all tasks assigned to it
    computing: Task | None = None  # the running one
    silent: bool = False
    held: list[Callable] = field(default_factory=list)  # events delayed while it was silent


class Workers:
    """A model of dask's scheduler in simulated time."""

    def __init__(self, **workers: Callable[[Any], tuple[float, Any]]) -> None:
        """Let workers join. workers : function ``does`` of each Worker, by name (see ``at``)."""
        self.now = 1000.0  # s
        self.replaced: Callable | None = None  # ``does`` of the worker that replaces a dead one
        self.workers: dict[str, Worker] = {}  # by address
        self.running: set[Worker] = set()  # workers that accept tasks
        self.unrunnable: dict[Task, float] = {}  # time since when no worker can run a task
        self.tried: list[tuple[Any, str]] = []  # (item, name of the worker), in order of start
        self._events: list[tuple[float, int, Callable]] = []  # heap of (time, number, action)
        self.ended: list[Arrival] = []  # results to be collected
        self.numbers = count()
        for name, does in workers.items():
            self.join(name, does)

    def after(self, seconds: float, happen: Callable, *arguments: Any) -> None:
        """Schedule a call in ``seconds`` from now."""
        event = partial(happen, *arguments)
        heappush(self._events, (self.now + seconds, next(self.numbers), event))

    def join(self, name: str, does: Callable[[Any], tuple[float, Any]]) -> None:
        """Let a worker join."""
        self.workers[at(name)] = Worker(at(name), does)
        self.wake(name)

    def retire(self, name: str) -> None:
        """End a worker in good order, as at the end of a job; dask does not count this death."""
        self.die(name, counted=False)

    def die(self, name: str, counted: bool = True) -> None:
        """Kill a worker if it exists. counted : whether its tasks count the death."""
        worker = self.workers.pop(at(name), None)
        if worker is None:
            return
        self.running.discard(worker)
        for task in worker.processing:
            task.deaths += counted
            if task.deaths > ALLOWED_FAILURES:
                self._end(Arrival(task.key, error=WorkerDied(task.deaths)))
            else:
                self.assign(task)
        if self.replaced:
            self.after(0.5, self.join, f"{name[0]}{int(name[1:]) + 1}", self.replaced)

    def pause(self, name: str) -> None:
        """Let a worker accept no new tasks, as a dask worker that is short of memory does."""
        if at(name) in self.workers:
            self.running.discard(self.workers[at(name)])

    def hush(self, name: str) -> None:
        """Stop a worker as SIGSTOP does; the scheduler keeps it until it is given up."""
        if worker := self.workers.get(at(name)):
            worker.silent = True
            self.after(GIVEN_UP, self._give_up, worker)

    def _give_up(self, worker: Worker) -> None:
        if worker.silent:
            self.die(worker.address.rpartition(":")[2])

    def wake(self, name: str) -> None:
        """Resume a paused or silent worker, or start a new one."""
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
        """Advance the simulation by ``seconds``, or until a task has ended."""
        until = self.now + seconds
        assert until < LONGEST, "hangs"
        while self._events and self._events[0][0] <= until and not self.ended:
            self.now, _, happen = heappop(self._events)
            happen()
            self._go_on()
        self.now = self.now if self.ended else until

    def assign(self, task: Task) -> None:
        """Assign a task to the allowed worker with the fewest tasks."""
        fit = [w for w in self.running if _may(task, w)]
        if fit:
            min(fit, key=lambda w: (len(w.processing), w.address)).processing.append(task)
            self._go_on()
        else:
            self.unrunnable[task] = self.now

    def forget(self, task: Task) -> None:
        """Remove a task from all workers, unless one is computing it."""
        self.unrunnable.pop(task, None)
        for worker in self.workers.values():
            if task in worker.processing and task is not worker.computing:
                worker.processing.remove(task)

    def _go_on(self) -> None:
        """Let every idle worker begin its next task, or steal one."""
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
            outcome = {"error": value} if failed else {"value": value}
            self._end(Arrival(task.key, worker.address, **outcome))

    def _end(self, arrival: Arrival) -> None:
        self.ended.append(arrival)


def at(name: str) -> str:
    """Return the address of a worker; "host_1" is on the host "host", other names on "here"."""
    host, _, _ = name.rpartition("_")
    return f"tls://{host or 'here'}:{name}"


def _may(task: Task, worker: Worker) -> bool:
    return not task.workers or worker.address in task.workers
