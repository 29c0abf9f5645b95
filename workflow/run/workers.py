"""Workers that compute and fit: this process for short work, otherwise those of a cluster."""

import sys
import time
from collections.abc import Callable, Collection, Iterator, Mapping
from concurrent.futures import Future
from contextlib import contextmanager
from functools import partial
from itertools import count
from typing import Any, NamedTuple

from .. import cluster, reduce
from ..cluster import Arrival, Node, Snapshot
from ..plan import Plan
from ..simulate import Batch, BatchResult, block_means
from ..study import LOCAL, THIS_MACHINE, Cluster
from ..system import Watch, own_versions

SECONDS_HERE = 10.0  # predicted time below which this process computes without workers
SECONDS_PER_FIT = 3e-5  # core time of one fit to one jackknife replicate

MARCH, FIT = "march", "fit"  # names of nodes
HERE = "here"  # address of this process as a worker


class RunOptions(NamedTuple):
    """Options of a run; the numbers of the result do not depend on them.

    batch_seconds : predicted length of a batch, s; by default it grows with the study.
    work : function that computes a batch; tests replace it.
    """

    cluster: Cluster = THIS_MACHINE
    workers: int | None = None  # local processes; None: one per core, or none for short work
    dashboard: bool = False
    batch_seconds: float | None = None
    max_failures: int = 0
    retry_failed: bool = False
    one_kind: bool = False  # refuse to mix records of several makers
    no_lock: bool = False  # continue if the file system does not support locks
    work: Callable[[Batch], BatchResult] = block_means

    def here(self, seconds: float) -> bool:
        """Return whether to compute without workers. seconds : predicted time of the work."""
        workers_requested = (
            self.cluster.where != LOCAL or self.workers is not None or self.dashboard
        )
        return seconds < SECONDS_HERE and not workers_requested


def fit_seconds(plan: Plan, groups: int) -> float:
    """Return the predicted seconds of the fits of a task. groups : number of jackknife groups."""
    return (groups + 1) * plan.variants[0].quantities.relaxation * SECONDS_PER_FIT


@contextmanager
def open_pool(how: RunOptions, seconds: float, watch: Watch) -> Iterator[Any]:
    """Yield a pool of workers, or of this process. seconds : predicted time of the work.

    Raises UserError if no workers are available.
    """
    if how.here(seconds):
        yield PoolHere(functions_of(how.work))
        return
    if how.cluster.where == LOCAL:
        print("Starting worker processes, about 3 s.", file=sys.stderr)
    with cluster.open_client(how.cluster, how.workers, how.dashboard, watch) as client:
        march = partial(cluster.run_batch, expected=own_versions(), work=how.work)
        yield cluster.Pool(client, functions_of(march))


def functions_of(march: Callable[..., BatchResult]) -> dict[str, Callable[..., Any]]:
    """Return the functions of the nodes, by name."""
    return {MARCH: march, FIT: reduce.reduce_portion}


class PoolHere:
    """A ``cluster.Pool`` whose only worker is this process, which computes a node in ``take``."""

    monotonic = staticmethod(time.monotonic)

    def __init__(self, functions: dict[str, Callable[..., Any]]) -> None:
        """Create a pool. functions : by name of the nodes."""
        self.functions, self.numbers = functions, count()
        self.submitted: dict[str, Node] = {}  # by key

    def submit(self, nodes: list[Node], workers: Collection[str] = ()) -> list[str]:
        """Submit nodes; return their keys."""
        keys = [str(next(self.numbers)) for _ in nodes]
        for key, node in zip(keys, nodes, strict=True):
            self.submitted[key], node.result = node, HERE
        return keys

    def take(self, seconds: float) -> list[Arrival]:
        """Compute the next node; return what comes of it."""
        if not self.submitted:
            return []
        key, node = next(iter(self.submitted.items()))
        del self.submitted[key]
        try:
            inputs = [other.result for other in node.given]
            node.result = self.functions[node.name](node.item, *inputs)
        except Exception as error:
            return [Arrival(key, HERE, error=error)]
        return [Arrival(key, HERE, node.result)]

    def drop(self, nodes: Mapping[str, Node]) -> None:
        """Compute nodes, given by key, no more."""
        for key, node in nodes.items():
            self.submitted.pop(key, None)
            node.result = None

    def holds(self, node: Node) -> bool:
        """Return whether the result of a node that is done is still in memory."""
        return node.result is not None

    def pending(self, key: str) -> bool:
        """Return whether a node is unfinished."""
        return key in self.submitted

    def request_snapshot(self) -> "Future[Snapshot]":
        """Return the future of a snapshot, which is there."""
        answer: Future[Snapshot] = Future()
        answer.set_result(Snapshot({HERE: 1}, [HERE]))
        return answer
