"""Retry policy: a failed batch is split, its tasks are retried alone, then recorded as failed."""

import dataclasses
import math
import sys
from typing import Any

from ..cluster import WorkerDied
from ..ground import UserError
from ..plan import Plan
from ..simulate import Batch, Task
from ..store import Store
from .node import Node
from .workers import MARCH

NO_THREAD = "can't start new thread"  # of Python, at a limit of memory or of threads


class Failures:
    """The retry policy of a run, and its failed tasks.

    A failed batch is split into its tasks. A task that raises again, or kills its workers while it
    runs alone, is recorded in the journal. Later runs skip it unless ``retry_failed`` is set.
    """

    def __init__(self, store: Store, plan: Plan, most: int) -> None:
        """Create the policy. most : largest number of new failures; beyond it the run stops."""
        self.store, self.plan, self.most = store, plan, most
        self.fresh = 0  # number of tasks that failed in this run

    def __contains__(self, record: Any) -> bool:
        """Return whether a record is settled: it is stored, or its task failed."""
        return record[0] in self.store.failed or record in self.store

    def __call__(self, node: Node, error: Exception, alone: bool) -> list[Node]:
        """Return the replacements of a failed node (see ``Stream``); a fit has none."""
        if node.name == MARCH:
            return [Node(MARCH, batch) for batch in self.replaced(node.item, error, alone)]
        if isinstance(error, WorkerDied) and not alone:
            return [node]
        raise error

    def replaced(self, batch: Batch, error: Exception, alone: bool) -> list[Batch]:
        """Return the replacements of a failed batch."""
        if isinstance(error, UserError):
            raise error
        if isinstance(error, ImportError):
            raise UserError(f"a worker cannot import its code: {error}") from error
        if NO_THREAD in str(error):
            raise UserError(f"a worker {NO_THREAD}: raise ulimit -v or ulimit -u") from error
        if len(batch.tasks) > 1 or (isinstance(error, WorkerDied) and not alone):
            seconds = batch.seconds / len(batch.tasks)
            return [dataclasses.replace(batch, tasks=(t,), seconds=seconds) for t in batch.tasks]
        self._record(batch, error)
        return []

    def too_many(self) -> bool:
        """Return whether more tasks failed in this run than allowed."""
        return self.fresh > self.most

    def tasks(self) -> list[tuple[str, Task]]:
        """Return (label of the variant, task) of all failed tasks of the plan."""
        failed = self.store.failed
        return [(v.label, t) for v in self.plan.variants for t in v.tasks if t.key in failed]

    def lines(self) -> list[str]:
        """Return a table of all failed tasks of the plan, with a heading; empty if none failed."""
        tasks = self.tasks()
        if not tasks:
            return []
        rows = [f"  {self.where(t)} {label}: {self.store.failed[t.key]}" for label, t in tasks]
        return [f"{len(tasks)} problems failed; --retry-failed retries them:", *rows]

    def where(self, task: Task) -> str:
        """Return the first grid point of a task as text (see ``point_in_words``)."""
        return point_in_words(self.plan.first_point(task))

    def _record(self, batch: Batch, error: Exception) -> None:
        (task,) = batch.tasks
        if task.key in self.store.failed:
            return  # another block of this task failed before
        if isinstance(error, WorkerDied):
            why = f"its worker died {error.deaths} times, or retired before the job's walltime"
        else:
            why = f"{type(error).__name__}: {error}".splitlines()[0]
        last = batch.first_block + batch.blocks - 1
        self.store.record_failure(task.key, f"{why} (blocks {batch.first_block}-{last})")
        self.fresh += 1
        print(f"failed: {self.where(task)}: {self.store.failed[task.key]}", file=sys.stderr)


def point_in_words(point: dict[str, float]) -> str:
    """Return a grid point as text, without axes that are NaN (such as H of measured lines)."""
    known = {axis: value for axis, value in point.items() if not math.isnan(value)}
    return " ".join(f"{axis}={value:.4g}" for axis, value in known.items())
