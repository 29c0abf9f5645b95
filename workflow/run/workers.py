"""Workers that compute and fit: this process for short work, otherwise those of a cluster."""

import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any, NamedTuple

from .. import cluster
from ..ground import UserError
from ..plan import Plan
from ..simulate import Batch, BatchResult, block_means
from ..study import LOCAL, THIS_MACHINE, Cluster
from ..system import Watch, own_versions

SECONDS_HERE = 10.0  # predicted time below which this process computes without workers
SECONDS_PER_FIT = 3e-5  # core time of one fit to one jackknife replicate

# stream(function, items, watch, retry) yields (item, function(item)).
Stream = Callable[..., Iterator[tuple[Any, Any]]]


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
    return (groups + 1) * plan.quantities.relaxation * SECONDS_PER_FIT


class Workers(NamedTuple):
    """A function that streams items through the workers, and the function that computes a batch."""

    stream: Stream
    work: Callable[[Batch], BatchResult]


@contextmanager
def open_workers(how: RunOptions, seconds: float, watch: Watch) -> Iterator[Workers]:
    """Yield the workers. seconds : predicted time of the work.

    Raises UserError if no workers are available.
    """
    if how.here(seconds):
        yield Workers(stream_here, how.work)
        return
    if how.cluster.where == LOCAL:
        print("Starting worker processes, about 3 s.", file=sys.stderr)
    with cluster.open_client(how.cluster, how.workers, how.dashboard, watch) as client:
        work = partial(cluster.run_batch, expected=own_versions(), work=how.work)
        through = partial(cluster.stream, blame=cluster.Blame())

        def stream(
            function: Callable, items: Iterable[Any], *watch_and_retry: Any
        ) -> Iterator[tuple[Any, Any]]:
            return through(cluster.Pool(client, function), items, *watch_and_retry)

        yield Workers(stream, work)


def stream_here(
    function: Callable[[Any], Any],
    items: Iterable[Any],
    watch: Watch,
    retry: Callable[[Any, Exception, bool], list[Any]] | None = None,
) -> Iterator[tuple[Any, Any]]:
    """Yield (item, function(item)), one item at a time, until ``watch()`` returns True.

    As in cluster.stream, an item that raises twice is passed to ``retry``, which returns its
    replacements; without ``retry`` the error ends the stream.
    """
    source, again = iter(items), list[Any]()
    watch.look(1, 0)
    while not watch():
        rest = object()
        item = again.pop(0) if again else next(source, rest)
        if item is rest:
            return
        try:
            done = _tried(function, item)
        except Exception as error:
            if retry is None:
                raise
            again += retry(item, error, True)
            continue
        watch.look(1, 1)
        yield item, done


def _tried(function: Callable[[Any], Any], item: Any) -> Any:
    """Return function(item), retried once unless it raises a UserError."""
    try:
        return function(item)
    except UserError:
        raise
    except Exception:  # retried as on a cluster, where a second worker tries it
        return function(item)
