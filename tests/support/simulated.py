"""A simulated cluster behind the interface of a Pool of workers."""

from collections import Counter
from collections.abc import Callable, Collection, Iterable
from concurrent.futures import Future
from typing import Any

from elastomer_friction.workflow.cluster.flow import stream
from elastomer_friction.workflow.cluster.pool import Arrival, Snapshot
from tests.support.simulated_workers import Task, Workers

ERROR = OSError("Input/output error")


def sick(item):
    """Fail at once, as with a broken disk."""
    return 0.01, ERROR


def sound(item):
    """Take a second."""
    return 1.0, item


def first(seconds):
    """Return a sound worker whose first item takes so long, as where all has to be compiled."""
    times = iter([seconds])
    return lambda item: (next(times, 1.0), item)


class Cluster(Workers):
    """Stands in for a Pool of workers."""

    def __init__(self, **workers: Callable[[Any], tuple[float, Any]]) -> None:
        """``workers`` : what each does, by name; see ``at``."""
        super().__init__(**workers)
        self.tasks: dict[str, Task] = {}  # that are waited for

    def monotonic(self) -> float:
        """Return the time."""
        return self.now

    def submit(self, items: list[Any], workers: Collection[str] = ()) -> list[str]:
        """Give out items."""
        tasks = [Task(str(next(self.numbers)), item, workers) for item in items]
        self.tasks |= {task.key: task for task in tasks}
        for task in tasks:
            self.assign(task)
        return [task.key for task in tasks]

    def take(self, seconds: float) -> list[Arrival]:
        """Return what has come, once something has, within so many seconds."""
        self.pass_by(seconds)
        ended, self.ended = self.ended, []
        return [arrival for arrival in ended if self.tasks.pop(arrival.key, None)]

    def drop(self, keys: Collection[str]) -> None:
        """Wait for some no more."""
        for key in keys:
            self.forget(self.tasks.pop(key))

    def pending(self, key: str) -> bool:
        """Return whether nobody has done an item yet."""
        return all(arrival.key != key for arrival in self.ended)

    def request_snapshot(self) -> "Future[Snapshot]":
        """Return who is there."""
        running = {task.key: w.address for w in self.workers.values() for task in w.processing}
        ready = [worker.address for worker in self.running]
        answer: Future[Snapshot] = Future()
        answer.set_result(Snapshot(dict.fromkeys(self.workers, 1), sorted(ready), running))
        return answer


def streamed(cluster: Cluster, items: Iterable[Any], **how: Any) -> list[tuple[Any, Any]]:
    """Return what a stream of items through a simulated cluster yields."""
    return list(stream(cluster, items, **how))


def tries(cluster, name):
    """Return how often each item was tried by a worker."""
    return Counter(item for item, worker in cluster.tried if worker == name)
