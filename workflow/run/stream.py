"""The graph of a run through the workers, with a bounded window that is refilled in bulk."""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import islice
from typing import Any

from ..cluster import ResultLost, Snapshot, WorkerDied
from ..ground import UserError
from ..system import BEAT_SECONDS, NO_ANSWER, QUIET_SECONDS, Watch, say
from .blame import Blame
from .node import Node

NODES_PER_THREAD, MIN_WINDOW = 4, 8  # nodes in flight
BOUND_NODES_PER_THREAD = 2  # if nodes are bound to workers: fewer, so that others take the rest
TAKE_SECONDS = 0.1  # between two checks for arrivals, which are then handled together
STOP_SECONDS = 10.0  # wait for running nodes after a stop
MAX_WORKER_DEATHS = 3  # that a node may cause before it is given up; dask has the same limit


@dataclass
class Stream:
    """Iterable of (node, value) in order of arrival; after watch() is true, of running nodes only.

    A node is submitted once those that it waits for are, whose futures it is given. A few nodes
    per worker thread, or as many as finish in a second, are in flight, so that memory does not
    grow with the study. A node that raises is retried on another worker; it waits for one if none
    has connected or one was lost recently. If it fails on two workers, or twice on the only one,
    it is replaced. Nodes of killed workers run last and one at a time, so that the node that kills
    is known. Raises UserError if the scheduler is lost, or when patience ends.
    """

    pool: Any  # a Pool, or what has its methods
    source: Iterator[Node]
    watch: Watch
    # retry(node, error, alone) returns what to compute instead of a node that failed, alone or not.
    retry: Callable[[Node, Exception, bool], list[Node]]
    blame: Blame  # state of the workers, also from earlier streams
    in_flight: dict[str, Node] = field(default_factory=dict)  # by key
    queue: list[Node] = field(default_factory=list)  # they wait for other nodes, or for a worker
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
        """Yield (node, value)."""
        try:
            self._look()
            self._submit()
            while self.in_flight or ((self.drawn or self.queue) and not self.watch()):
                yield from self._take()
                self._look()
                self._submit()
        finally:
            self._drop([*self.in_flight])

    def _submit(self) -> None:
        """Fill the window from the queue and the source; then submit nodes one at a time."""
        free = self.window - len(self.in_flight)
        if self.watch() or free <= self.window // 8 or (self.isolated and self.in_flight):
            return  # refilled in bulk
        nodes = [*self.queue, *islice(self.source, max(free - len(self.queue), 0))]
        self.drawn = bool(nodes)
        self.queue = [node for node in nodes if node.inputs or node.failed]
        self._send([node for node in nodes if not (node.inputs or node.failed)])
        for node in [node for node in self.queue if self._ready(node)]:
            self.queue.remove(node)
            self._send([node], node.failed)
        self.isolated = self.isolated and len(self.in_flight) < 2
        retried = any(node.failed for node in self.queue)
        if self.alone and not (self.in_flight or retried):
            self._send([self.alone.pop()])
            self.isolated = True

    def _ready(self, node: Node) -> bool:
        """Return whether the inputs of a node are submitted, and it waits for no worker."""
        submitted = all(other.done or other.result is not None for other in node.needs())
        return submitted and not (node.failed and self.blame.awaited(node.failed))

    def _send(self, nodes: list[Node], failed: Sequence[str] = ()) -> None:
        """Submit nodes that are needed, to other workers than those at which they failed.

        A preference would not do, since idle workers steal nodes and a failing worker is idle.
        """
        workers = self.blame.fit(failed) if failed or self.blame.excluded else []
        for other in (other for node in nodes for other in node.needs() if other.done):
            if other.result is not None and not self.pool.holds(other.result):
                other.result = None
        if nodes := [node for node in nodes if node.prepare()]:
            futures = self.pool.submit([node.call() for node in nodes], workers)
            self.in_flight |= zip(futures, nodes, strict=True)
            for node, future in zip(nodes, futures.values(), strict=True):
                node.result, node.workers, node.worker = future, workers, ""

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

        The nodes that wait for its result are taken back. An error of a node that waits for others
        counts once these are done, as it may be theirs.
        """
        node.result = None
        withdrawn = [key for key, other in self.in_flight.items() if node in other.given]
        self.queue += self._drop(withdrawn)
        if not all(other.done for other in node.given):
            error = ResultLost()
        if isinstance(error, WorkerDied):
            node.deaths = max(node.deaths + 1, error.deaths)
        elif not isinstance(error, ResultLost):
            node.failed.append(address)
        given_up = node.deaths > MAX_WORKER_DEATHS or self.blame.to_be_given_up(node.failed)
        if not (given_up or isinstance(error, UserError)):
            self.queue.append(node)
            return
        node.failed, node.deaths = [], 0
        nodes = self.retry(node, error, self.isolated)
        node.instead = None if node in nodes else nodes
        (self.alone if isinstance(error, WorkerDied) else self.queue).extend(nodes)

    def _look(self) -> None:
        """Once a second, and after a stop, request a snapshot; report to the watch."""
        now, stopping = self.pool.monotonic(), self.watch()
        if stopping:
            self.stopped = min(self.stopped, now)
        due = now - self.checked >= BEAT_SECONDS
        if self.answer is None and (due or self.requested < self.stopped <= now):
            self.answer, self.requested = self.pool.request_snapshot(), now
        if self.answer is not None and self.answer.done():
            self._note(self.answer.result(), now)
            self.answer = None
        if not due:
            return
        self.checked = now
        silent = now - self.requested >= QUIET_SECONDS
        if self.in_flight and (now - self.stopped >= STOP_SECONDS or (stopping and silent)):
            say(f"abandoned: {len(self.in_flight)} batches that did not finish in time")
            self._drop([*self.in_flight])
        threads = sum(self.blame.now.threads.values())
        self.watch.look(threads, len(self.in_flight), NO_ANSWER if silent else "")

    def _note(self, snapshot: Snapshot, now: float) -> None:
        """Update the workers; resubmit the nodes of lost workers.

        Dask would resubmit them too, but does not count workers that retire, as at the end of a
        job. After a stop, drop the nodes that no worker had started at the time of the snapshot.
        """
        self.blame.note(snapshot, now)
        per_thread = BOUND_NODES_PER_THREAD if self.blame.excluded else NODES_PER_THREAD
        self.window = max(per_thread * sum(snapshot.threads.values()), MIN_WINDOW, self.arrived)
        self.arrived = 0
        for key, node in [*self.in_flight.items()]:
            lost = node.workers or {node.worker} - {""}
            node.worker = snapshot.running.get(key, "")
            if lost and key in self.in_flight and snapshot.threads.keys().isdisjoint(lost):
                self._drop([key])
                self._fail(node, WorkerDied(node.deaths + 1))
        if self.requested >= self.stopped:
            waiting = self.in_flight.keys() - snapshot.running.keys()
            self._drop([key for key in waiting if self.pool.pending(key)])

    def _drop(self, keys: list[str]) -> list[Node]:
        """Stop waiting for nodes; return them."""
        self.pool.drop(keys)
        nodes = [self.in_flight.pop(key) for key in keys]
        for node in nodes:
            node.result = None
        return nodes
