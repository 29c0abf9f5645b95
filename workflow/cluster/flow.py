"""The graph of a run through the workers, with a bounded window that is refilled in bulk."""

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import islice
from types import SimpleNamespace
from typing import Any, cast

from distributed.scheduler import KilledWorker

from ..ground import UserError
from ..system import BEAT_SECONDS, NO_ANSWER, QUIET_SECONDS, Watch, say
from .blame import Blame
from .node import Node
from .pool import ResultLost, Snapshot

NODES_PER_THREAD, MIN_WINDOW = 4, 8  # nodes in flight
BOUND_NODES_PER_THREAD = 2  # if nodes are bound to workers: fewer, so that others take the rest
TAKE_SECONDS = 0.1  # between two checks for arrivals, which are then handled together
STOP_SECONDS = 10.0  # wait for running nodes after a stop
MAX_WORKER_DEATHS = 3  # that a node may cause before it is given up; dask has the same limit

# Returns the nodes to compute instead of one that failed with an error, alone or not.
Retry = Callable[[Node, Exception, bool], list[Node]]


def raise_error(node: Node, error: Exception, alone: bool) -> list[Node]:
    """Raise the error of a worker; retry a node once, alone, if its worker died."""
    if isinstance(error, KilledWorker) and not alone:
        return [node]
    raise error


def stream(
    pool: Any,
    nodes: Iterable[Node],
    watch: Watch | None = None,
    retry: Retry = raise_error,
    blame: Blame | None = None,
) -> Iterator[tuple[Node, Any]]:
    """Yield (node, value) in order of arrival; after watch() is true, only running nodes.

    A node is submitted once those that it waits for are, whose futures it is given. A few nodes
    per worker thread, or as many as finish in a second, are in flight, so that memory does not
    grow with the study. A node that raises is retried on another worker; it waits for one if none
    has connected or one was lost recently. ``retry`` returns the replacement of a node that failed
    on two workers, or twice on the only worker. Nodes of killed workers run last and one at a time,
    so that the node that kills is known. After a stop, running nodes are awaited for at most
    STOP_SECONDS. Raises UserError if the scheduler is lost, or when patience ends.

    pool : a Pool, or its stand-in in tests. blame : state of the workers from earlier streams.
    """
    return iter(_Stream(pool, iter(nodes), watch or Watch(), retry, blame or Blame()))


@dataclass
class _Stream:
    pool: Any
    source: Iterator[Node]
    watch: Watch
    retry: Retry
    blame: Blame
    in_flight: dict[str, Node] = field(default_factory=dict)  # by key
    again: list[Node] = field(default_factory=list)  # submitted before the rest of the source
    waiting: list[Node] = field(default_factory=list)  # for nodes that are not submitted
    alone: list[Node] = field(default_factory=list)  # submitted after the rest, one at a time
    isolated: bool = False  # whether the node in flight is the only one
    drawn: bool = False  # whether there were nodes to submit the last time
    window: int = MIN_WINDOW
    arrived: int = 0  # values since the last snapshot
    answer: Any = None  # future of the next snapshot
    requested: float = -math.inf  # time of the last request for a snapshot, s
    checked: float = -math.inf  # time of the last check, s
    stopped: float = math.inf  # time of the stop, s

    def __iter__(self) -> Iterator[tuple[Node, Any]]:
        try:
            self._look()
            self._submit()
            while self.in_flight or ((self.drawn or self.again) and not self.watch()):
                yield from self._take()
                self._look()
                self._submit()
        finally:
            self.pool.drop(self.in_flight)

    def _submit(self) -> None:
        """Fill the window from the retries and the source; then submit nodes one at a time."""
        free = self.window - len(self.in_flight)
        if self.watch() or free <= self.window // 8 or (self.isolated and self.in_flight):
            return  # refilled in bulk
        nodes = self.again[:free]
        del self.again[:free]
        nodes += islice(self.source, free - len(nodes))
        self.drawn = bool(nodes)
        self._send_ready([node for node in nodes if not node.inputs])
        self.waiting += [node for node in nodes if node.inputs]
        ready = [node for node in self.waiting if node.ready()]
        self.waiting = [node for node in self.waiting if node not in ready]
        self._send_ready(ready)
        self.isolated = self.isolated and len(self.in_flight) < 2
        if not (self.in_flight or self.again) and self.alone:
            self._send_ready([self.alone.pop()])
            self.isolated = True

    def _send_ready(self, nodes: list[Node]) -> None:
        """Submit nodes; those that failed elsewhere, or wait for a worker that may come."""
        blame = self.blame
        self._send([n for n in nodes if not n.failed], blame.fit() if blame.excluded else [])
        for node in nodes:
            if node.failed and blame.awaited(node.failed):
                self.again.append(node)
            elif node.failed:
                self._send([node], blame.fit(node.failed))

    def _send(self, nodes: list[Node], workers: list[str]) -> None:
        """Submit nodes that are needed, restricted to ``workers`` unless it is empty.

        A preference would not do, since idle workers steal nodes and a failing worker is idle.
        """
        for other in (other for node in nodes for other in node.needs() if other.done):
            if not self.pool.holds(other):
                other.result = None
        nodes = [node for node in nodes if node.prepare()]
        if nodes:
            keys = self.pool.submit(nodes, workers)
            for key, node in zip(keys, nodes, strict=True):
                node.workers = workers
                self.in_flight[key] = node

    def _take(self) -> Iterator[tuple[Node, Any]]:
        """Yield the arrived (node, value), and schedule replacements of failed nodes."""
        for arrival in self.pool.take(TAKE_SECONDS):
            node = self.in_flight.pop(arrival.key, None)
            if node is None:
                continue  # it was withdrawn
            if arrival.error:
                self._fail(node, arrival.error, arrival.address)
            else:
                self.arrived += 1
                self.blame.succeeded(arrival.address, node.failed)
                node.finish()
                yield node, arrival.value

    def _fail(self, node: Node, error: Exception, address: str = "") -> None:
        """Schedule the retry or replacement of a node that failed or whose worker died.

        An error of a node that waits for others counts once these are done, as it may be theirs.
        """
        self._withdraw(node)
        if not all(other.done for other in node.given):
            error = ResultLost()
        if isinstance(error, KilledWorker):
            node.deaths = max(node.deaths, error.allowed_failures) + 1
        elif not isinstance(error, ResultLost):
            node.failed.append(address)
        given_up = node.deaths > MAX_WORKER_DEATHS or self.blame.to_be_given_up(node.failed)
        if not (given_up or isinstance(error, UserError)):
            self.again.append(node)
            return
        node.failed, node.deaths = [], 0
        nodes = self.retry(node, error, self.isolated)
        node.instead = None if node in nodes else nodes
        (self.alone if isinstance(error, KilledWorker) else self.again).extend(nodes)

    def _withdraw(self, node: Node) -> None:
        """Take back the nodes that wait for the result of one that failed."""
        node.result = None
        withdrawn = {key: other for key, other in self.in_flight.items() if node in other.given}
        self._drop(withdrawn)
        self.waiting += withdrawn.values()

    def _look(self) -> None:
        """Once a second, request a snapshot of the workers and report to the watch."""
        now, stopping = self.pool.monotonic(), self.watch()
        if stopping:
            self.stopped = min(self.stopped, now)
        if self.answer is not None and self.answer.done():
            self._note(self.answer.result(), now)
            self.answer = None
        due = now - self.checked >= BEAT_SECONDS
        if self.answer is None and (
            due or self.requested < self.stopped <= now
        ):  # at once after a stop
            self.answer, self.requested = self.pool.request_snapshot(), now
        if not due:
            return
        self.checked = now
        silent = now - self.requested >= QUIET_SECONDS
        if self.in_flight and (now - self.stopped >= STOP_SECONDS or (stopping and silent)):
            say(f"abandoned: {len(self.in_flight)} batches that did not finish in time")
            self._drop(self.in_flight)
        threads = sum(self.blame.now.threads.values())
        self.watch.look(threads, len(self.in_flight), NO_ANSWER if silent else "")

    def _note(self, snapshot: Snapshot, now: float) -> None:
        """Update the workers; resubmit the nodes of lost workers.

        Dask would resubmit them too, but does not count workers that retire, as at the end of a
        job. After a stop, drop the nodes that no worker had started at the time of the snapshot.
        """
        blame = self.blame
        blame.note(snapshot, now)
        per_thread = BOUND_NODES_PER_THREAD if blame.excluded else NODES_PER_THREAD
        self.window = max(per_thread * sum(snapshot.threads.values()), MIN_WINDOW, self.arrived)
        self.arrived = 0
        for key, node in [*self.in_flight.items()]:
            lost = node.workers or {node.worker} - {""}
            node.worker = snapshot.running.get(key, "")
            if lost and key in self.in_flight and snapshot.threads.keys().isdisjoint(lost):
                self._drop({key: node})
                last = cast(Any, SimpleNamespace(address=" or ".join(lost)))
                self._fail(node, KilledWorker(key, last, node.deaths))
        if self.requested >= self.stopped:
            waiting = self.in_flight.keys() - snapshot.running.keys()
            self._drop({k: self.in_flight[k] for k in waiting if self.pool.pending(k)})

    def _drop(self, nodes: dict[str, Node]) -> None:
        """Stop waiting for nodes, given by key."""
        nodes = dict(nodes)
        self.pool.drop(nodes)
        for key in nodes:
            del self.in_flight[key]
