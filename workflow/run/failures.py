"""What to do with batches that fail: split, tried alone, then recorded; the rest goes on."""

import dataclasses
import math
import sys
from typing import Any

from ..ground import UserError
from ..plan import Plan
from ..simulate import Batch, Task
from ..store import Store


class Failures:
    """The retry policy of a run, and the tasks that failed for good.

    A batch that fails is split into its tasks. One that raises again, or kills its workers while
    nothing else runs, is recorded in the journal; no run takes it up until it is asked to.
    """

    def __init__(self, store: Store, plan: Plan, most: int) -> None:
        """``most`` : with more failed tasks than this the run stops taking up work."""
        self.store, self.plan, self.most = store, plan, most
        self.fresh = 0  # failures of this run

    def __contains__(self, record: Any) -> bool:
        """Return whether nothing is left to do for a record: stored, or of a failed task."""
        return record[0] in self.store.failed or record in self.store

    def __call__(self, batch: Batch, error: Exception, alone: bool) -> list[Batch]:
        """Return what to do instead of a batch that failed (see flow.Retry)."""
        if isinstance(error, UserError):
            raise error
        if isinstance(error, ImportError):
            raise UserError(f"a worker cannot work: {error}") from error
        if len(batch.tasks) > 1 or (_killed(error) and not alone):
            each = batch.seconds / len(batch.tasks)
            return [dataclasses.replace(batch, tasks=(t,), seconds=each) for t in batch.tasks]
        self._record(batch, error)
        return []

    def too_many(self) -> bool:
        """Return whether more tasks failed in this run than it may go on with."""
        return self.fresh > self.most

    def tasks(self) -> list[tuple[str, Task]]:
        """Return (label of the variant, task) of all tasks of the plan that failed."""
        failed = self.store.failed
        return [(v.label, t) for v in self.plan.variants for t in v.tasks if t.key in failed]

    def lines(self) -> list[str]:
        """Return a table of all tasks of the plan that failed, by grid point."""
        tasks = self.tasks()
        if not tasks:
            return []
        said = [f"  {self.where(t)} {label}: {self.store.failed[t.key]}" for label, t in tasks]
        return [f"{len(tasks)} problems failed; --retry-failed tries them again:", *said]

    def where(self, task: Task) -> str:
        """Return the first grid point of a task in words, without axes that have no value."""
        return point_in_words(self.plan.first_point(task))

    def _record(self, batch: Batch, error: Exception) -> None:
        (task,) = batch.tasks
        if task.key in self.store.failed:
            return  # in another block, meanwhile
        if _killed(error):
            times = getattr(error, "allowed_failures", 0) + 1
            why = f"its worker died {times} times, or retired before the job's walltime"
        else:
            why = f"{type(error).__name__}: {error}".splitlines()[0]
        last = batch.first_block + batch.blocks - 1
        self.store.record_failure(task.key, f"{why} (blocks {batch.first_block}-{last})")
        self.fresh += 1
        print(f"failed: {self.where(task)}: {self.store.failed[task.key]}", file=sys.stderr)


def _killed(error: Exception) -> bool:
    """Return whether a worker died; where there are none, what knows of them is not loaded."""
    scheduler = sys.modules.get("distributed.scheduler")
    return scheduler is not None and isinstance(error, scheduler.KilledWorker)


def point_in_words(point: dict[str, float]) -> str:
    """Return a grid point in words; measured lines have no Hurst exponent to name."""
    known = {axis: value for axis, value in point.items() if not math.isnan(value)}
    return " ".join(f"{axis}={value:.4g}" for axis, value in known.items())
