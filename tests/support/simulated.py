"""A simulated cluster with the interface of a Pool of workers."""

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator
from concurrent.futures import Future
from typing import Any

from elastomer_friction.workflow.cluster import Arrival, Call, Snapshot, WorkerDied
from elastomer_friction.workflow.run.blame import Blame
from elastomer_friction.workflow.run.node import Node
from elastomer_friction.workflow.run.stream import Stream
from elastomer_friction.workflow.system import Watch
from tests.support.simulated_workers import Task, Workers

ERROR = OSError("Input/output error")


def sick(item):
    """Return (seconds, result) of a worker with a broken disk, which fails at once."""
    return 0.01, ERROR


def sound(item):
    """Return (seconds, result) of a sound worker, which takes a second."""
    return 1.0, item


def first(seconds):
    """Return a sound worker whose first item takes ``seconds``, as if kernels were compiled."""
    times = iter([seconds])
    return lambda item: (next(times, 1.0), item)


class Cluster(Workers):
    """A substitute for a Pool of workers."""

    def __init__(self, **workers: Callable[[Any], tuple[float, Any]]) -> None:
        """Let workers join. workers : function ``does`` of each Worker, by name (see ``at``)."""
        super().__init__(**workers)
        self.tasks: dict[str, Task] = {}  # submitted tasks without a collected result

    def monotonic(self) -> float:
        """Return the simulated time."""
        return self.now

    def submit(self, calls: list[Call], workers: Collection[str] = ()) -> dict[str, Task]:
        """Give out calls."""
        tasks = [Task(str(next(self.numbers)), call.item, workers) for call in calls]
        submitted = {task.key: task for task in tasks}
        self.tasks |= submitted
        for task in tasks:
            self.assign(task)
        return submitted

    def take(self, seconds: float) -> list[Arrival]:
        """Wait up to ``seconds`` for the first results; return all that have arrived."""
        self.pass_by(seconds)
        ended, self.ended = self.ended, []
        return [arrival for arrival in ended if self.tasks.pop(arrival.key, None)]

    def drop(self, keys: Iterable[str]) -> None:
        """Wait for some no more."""
        for key in keys:
            self.forget(self.tasks.pop(key))

    def pending(self, key: str) -> bool:
        """Return whether a task is unfinished."""
        return all(arrival.key != key for arrival in self.ended)

    def request_snapshot(self) -> "Future[Snapshot]":
        """Return the future of a Snapshot of the workers and of the tasks that they hold."""
        running = {task.key: w.address for w in self.workers.values() for task in w.processing}
        ready = [worker.address for worker in self.running]
        answer: Future[Snapshot] = Future()
        answer.set_result(Snapshot(dict.fromkeys(self.workers, 1), sorted(ready), running))
        return answer


def raised(node: Node, error: Exception, alone: bool) -> list[Node]:
    """Raise the error of a worker; retry a node once, alone, if its worker died."""
    if isinstance(error, WorkerDied) and not alone:
        return [node]
    raise error


def stream(
    pool: Any,
    nodes: Iterable[Node],
    watch: Watch | None = None,
    retry: Callable[[Node, Exception, bool], list[Node]] = raised,
) -> Iterator[tuple[Node, Any]]:
    """Return an iterator over (node, value)."""
    return iter(Stream(pool, iter(nodes), watch or Watch(), retry, Blame()))


def streamed(
    cluster: Any,
    items: Iterable[Any],
    retry: Callable[[Any, Exception, bool], list[Any]] | None = None,
    **how: Any,
) -> list[tuple[Any, Any]]:
    """Return (item, value) of all nodes that a stream yields. retry : of items."""
    nodes = (Node("march", item) for item in items)
    if retry is not None:
        how["retry"] = lambda node, error, alone: [
            Node("march", item) for item in retry(node.item, error, alone)
        ]
    return [(node.item, value) for node, value in stream(cluster, nodes, **how)]


def tries(cluster, name):
    """Return how often a worker began each item."""
    return Counter(item for item, worker in cluster.tried if worker == name)
