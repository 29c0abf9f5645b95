"""Workers that compute and fit: this process for short work, otherwise those of a cluster."""

import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any, NamedTuple

from .. import cluster, reduce
from ..cluster import Node
from ..ground import UserError
from ..plan import Plan
from ..simulate import Batch, BatchResult, block_means
from ..study import LOCAL, THIS_MACHINE, Cluster
from ..system import Watch, own_versions

SECONDS_HERE = 10.0  # predicted time below which this process computes without workers
SECONDS_PER_FIT = 3e-5  # core time of one fit to one jackknife replicate

MARCH, FIT = "march", "fit"  # names of nodes

# stream(nodes, watch, retry) yields (node, its value).
Stream = Callable[..., Iterator[tuple[Node, Any]]]


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
    """A stream of the nodes of a graph through the workers."""

    stream: Stream


@contextmanager
def open_workers(how: RunOptions, seconds: float, watch: Watch) -> Iterator[Workers]:
    """Yield the workers. seconds : predicted time of the work.

    Raises UserError if no workers are available.
    """
    if how.here(seconds):
        yield Workers(partial(stream_here, functions_of(how.work)))
        return
    if how.cluster.where == LOCAL:
        print("Starting worker processes, about 3 s.", file=sys.stderr)
    with cluster.open_client(how.cluster, how.workers, how.dashboard, watch) as client:
        march = partial(cluster.run_batch, expected=own_versions(), work=how.work)
        pool = cluster.Pool(client, functions_of(march))
        yield Workers(partial(cluster.stream, pool, blame=cluster.Blame()))


def functions_of(march: Callable[..., BatchResult]) -> dict[str, Callable[..., Any]]:
    """Return the functions of the nodes, by name."""
    return {MARCH: march, FIT: reduce.reduce_portion}


def stream_here(
    functions: dict[str, Callable[..., Any]],
    nodes: Iterable[Node],
    watch: Watch,
    retry: Callable[[Node, Exception, bool], list[Node]],
) -> Iterator[tuple[Node, Any]]:
    """Yield (node, value), one after the other, until watch() is true.

    As in cluster.stream, a node that raises twice is passed to ``retry``, which returns its
    replacements.
    """
    source, again = iter(nodes), list[Node]()
    watch.look(1, 0)
    while not watch():
        node = again.pop(0) if again else next(source, None)
        if node is None:
            return
        if not node.prepare():
            continue
        try:
            value = _tried(functions[node.name], node)
        except Exception as error:
            node.instead = retry(node, error, True)
            again += node.instead
            continue
        watch.look(1, 1)
        node.result = value
        node.finish()
        yield node, value


def _tried(function: Callable[..., Any], node: Node) -> Any:
    """Return the value of a node, tried twice unless it raises a UserError."""
    inputs = [other.result for other in node.given]
    try:
        return function(node.item, *inputs)
    except UserError:
        raise
    except Exception:  # on a cluster two workers try it
        return function(node.item, *inputs)
