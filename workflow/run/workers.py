"""Workers that compute and fit: this process for short work, otherwise those of a cluster."""

import sys
import time
from collections.abc import Callable, Collection, Iterable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from functools import partial
from itertools import count
from typing import Any, NamedTuple

from .. import cluster, reduce
from ..cluster import Arrival, Call, Snapshot
from ..plan import Plan
from ..simulate import Batch, BatchResult, block_means
from ..study import BATCH_SYSTEMS, LOCAL, THIS_MACHINE, Cluster
from ..system import Versions, Watch, own_versions, require

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
    with cluster.open_client(how.cluster, how.workers, how.dashboard) as client:
        if how.cluster.where in BATCH_SYSTEMS:
            watch.follow(how.cluster.log_folder)
        march = partial(run_batch, expected=own_versions(), work=how.work)
        yield cluster.Pool(client, functions_of(march))


def run_batch(
    batch: Batch, expected: Versions, work: Callable[[Batch], BatchResult] = block_means
) -> BatchResult:
    """Compute a batch. Raises UserError if the versions here differ from those of the driver."""
    require(expected)
    return work(batch)


def functions_of(march: Callable[..., BatchResult]) -> dict[str, Callable[..., Any]]:
    """Return the functions of the nodes, by name."""
    return {MARCH: march, FIT: reduce.reduce_portion}


class PoolHere:
    """A ``cluster.Pool`` whose only worker is this process, which computes a call in ``take``."""

    monotonic = staticmethod(time.monotonic)

    def __init__(self, functions: dict[str, Callable[..., Any]]) -> None:
        """Create a pool. functions : by name of the calls."""
        self.functions, self.numbers = functions, count()
        self.submitted: dict[str, tuple[Call, Future[Any]]] = {}  # by key

    def submit(self, calls: list[Call], workers: Collection[str] = ()) -> dict[str, Future]:
        """Submit calls; return futures by key."""
        submitted = {str(next(self.numbers)): (call, Future[Any]()) for call in calls}
        self.submitted |= submitted
        return {key: future for key, (_, future) in submitted.items()}

    def take(self, seconds: float) -> list[Arrival]:
        """Compute the next call; return its outcome."""
        if not self.submitted:
            return []
        key, (call, future) = next(iter(self.submitted.items()))
        del self.submitted[key]
        try:
            inputs = [other.result() for other in call.inputs]
            future.set_result(self.functions[call.name](call.item, *inputs))
        except Exception as error:
            return [Arrival(key, HERE, error=error)]
        return [Arrival(key, HERE, future.result())]

    def drop(self, keys: Iterable[str]) -> None:
        """Compute calls no more."""
        for key in keys:
            self.submitted.pop(key, None)

    def holds(self, future: Future) -> bool:
        """Return whether the result of a call that is done is there, as it is as long as it."""
        return future.done()

    def pending(self, key: str) -> bool:
        """Return whether a call is unfinished."""
        return key in self.submitted

    def request_snapshot(self) -> "Future[Snapshot]":
        """Return the future of a snapshot, which is there."""
        answer: Future[Snapshot] = Future()
        answer.set_result(Snapshot({HERE: 1}, [HERE]))
        return answer
