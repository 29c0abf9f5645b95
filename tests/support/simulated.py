"""A simulated cluster behind the interface that a stream of work has with dask's client."""

from collections import Counter
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from elastomer_friction.workflow.cluster.calls import ROLL, Call
from elastomer_friction.workflow.cluster.flow import stream
from elastomer_friction.workflow.cluster.watch import Watch
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


class Cluster(Workers):
    """Stands in for distributed's Client and as_completed."""

    loop = None

    def __init__(self, **workers: Callable[[Any], tuple[float, Any]]) -> None:
        """``workers`` : what each does, by name; see ``at``."""
        super().__init__(**workers)
        self.cancelled: list[Task] = []

    @property
    def scheduler(self) -> SimpleNamespace:
        """Return what answers calls."""
        return SimpleNamespace(**{ROLL: self.handlers.get(ROLL)})

    def run_on_scheduler(self, function: Callable, *arguments: Any) -> Any:
        """Run a function there."""
        return function(*arguments, dask_scheduler=self)

    def sync(self, function: Callable) -> Any:
        """Call the scheduler, which has heard of those that are not silent."""
        for worker in self.workers.values():
            worker.last_seen = worker.last_seen if worker.silent else self.now
        return function()

    def map(
        self,
        function: Callable,
        items: list[Any],
        workers: list[str] | None = None,
        allow_other_workers: bool = False,
        **_: Any,
    ) -> list[Task]:
        """Submit items."""
        del function
        tasks = [Task(str(next(self.numbers)), i, workers, allow_other_workers) for i in items]
        for task in tasks:
            self.tasks[task.key] = task
            self.assign(task)
        return tasks

    def gather(self, tasks: list[Task]) -> list[Any]:
        """Return results."""
        return [task.value for task in tasks]

    def cancel(self, tasks: list[Task]) -> None:
        """Forget tasks."""
        self.cancelled += tasks

    def update(self, tasks: list[Task]) -> None:
        """Wait for these too."""

    def next_batch(self, block: bool) -> list[Task]:
        """Return what has ended since the last time."""
        del block
        ended, self.ended = self.ended, []
        return ended


def streamed(cluster: Cluster, items: list[Any], **how: Any) -> list[tuple[Any, Any]]:
    """Return what a stream of items through a simulated cluster yields."""
    simulated = {"clock": cluster, "completed": lambda *_, **__: cluster, "call": AtOnce}
    return list(stream(cluster, abs, items, **{"watch": Watch()} | how, **simulated))


def tries(cluster, name):
    """Return how often each item was tried by a worker."""
    return Counter(item for item, worker in cluster.tried if worker == name)
