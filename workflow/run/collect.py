"""Reduction of stored block means on the workers, in rounds, and assembly of the datasets.

Points that miss the accuracy get more realizations, up to the limit. This decision depends only on
the block means of the round, not on other stored records. The same study therefore takes the same
rounds and gives the same bits for any number of workers, and also after a crash.
"""

import math
import time
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from .. import reduce, result
from ..ground import UserError
from ..plan import JACKKNIFE_GROUPS, Plan, Variant, most_blocks
from ..simulate import Task
from ..store import Store
from ..system import Reporter, Watch
from .summary import Summary
from .workers import Workers, fit_seconds

if TYPE_CHECKING:
    from ..reduce import Attained, Blocks, Estimates
    from ..result import Groups


TASKS_PER_REDUCTION = 32
NEED_MARGIN = 1.1  # safety factor on the growth; without it half of the points miss the accuracy
GROWTH_LIMITS = (1.25, 4.0)  # smallest and largest growth of the realizations in one round


class Collector:
    """Reducer of stored block means on the workers; each task is fitted once per round."""

    def __init__(
        self, workers: Workers, store: Store, plan: Plan, summary: Summary, watch: Watch
    ) -> None:
        """Create a collector. watch : callable that returns True to stop collecting."""
        self.workers, self.store, self.plan = workers, store, plan
        self.summary, self.watch = summary, watch
        self.widths = {variant.label: plan.widest_row(variant) for variant in plan.variants}
        self.fitted = {variant.label: Fitted(variant) for variant in plan.variants}

    def datasets(self, blocks: dict[str, int]) -> "Groups":
        """Return label -> dataset of every variant. blocks : number of blocks by key of the task.

        Failed tasks have NaN estimates, flags -1 and 0 realizations. The result is empty if
        ``watch()`` returned True.
        """
        datasets = {}
        sound = [(variant, self._sound(variant)) for variant in self.plan.variants]
        with self.reporter("fitting", sound, blocks) as reporter:
            for variant, rows in sound:
                if not self.fit(variant, rows, blocks, reporter):
                    return {}
                estimates = self._complete(variant, np.array(rows), blocks)
                exponents = reduce.exponents_of(self.plan, variant, estimates)
                data = result.build_dataset(self.plan, variant, estimates, exponents)
                datasets[variant.label] = data
        return datasets

    def _sound(self, variant: Variant) -> list[int]:
        """Return the rows of the tasks that did not fail. Raises UserError if all failed."""
        rows = [row for row, t in enumerate(variant.tasks) if t.key not in self.store.failed]
        if not rows:
            where = variant.label or "the study"
            raise UserError(f"{where}: all problems failed, so that no result remains")
        return rows

    def reporter(
        self, title: str, work: list[tuple[Variant, list[int]]], blocks: dict[str, int]
    ) -> Reporter:
        """Return a progress reporter for the pending fits. work : variants, each with its rows."""
        seconds = (self._seconds(variant, rows, blocks).values() for variant, rows in work)
        return Reporter(title, sum(map(sum, seconds)))

    def _seconds(
        self, variant: Variant, rows: list[int], blocks: dict[str, int]
    ) -> dict[int, float]:
        """Return the predicted seconds of the pending fits of a variant, by row."""
        fitted = self.fitted[variant.label].blocks
        counts = {row: blocks[variant.tasks[row].key] for row in rows}
        groups = {r: min(n, JACKKNIFE_GROUPS) for r, n in counts.items() if fitted[r] != n}
        return {row: fit_seconds(self.plan, number) for row, number in groups.items()}

    def fit(
        self, variant: Variant, rows: list[int], blocks: dict[str, int], reporter: Reporter
    ) -> bool:
        """Fit the tasks at ``rows`` of a variant, and report progress.

        blocks : number of blocks by key of the task. Tasks already fitted from the same number of
        blocks are skipped. Returns False if ``watch()`` returns True, which ends the fits early.
        """
        fitted = self.fitted[variant.label]
        counts = [blocks[task.key] for task in variant.tasks]
        seconds_of = self._seconds(variant, rows, blocks)
        portions = _portions({row: min(counts[row], JACKKNIFE_GROUPS) for row in seconds_of})

        def load() -> "Iterator[tuple[list[int], Blocks]]":
            for portion in portions:
                with self.summary.filing():
                    loaded = self._load(variant, [variant.tasks[row] for row in portion], blocks)
                yield portion, loaded

        work = self.workers.stream(_reduce_portion, load(), self.watch)
        for (portion, _), (estimates, seconds) in work:
            fitted.enter(portion, estimates, [counts[row] for row in portion])
            self.summary.phases["fits"] += seconds
            reporter.advance(sum(seconds_of[row] for row in portion))
        return not self.watch()

    def attained(self, variant: Variant, rows: list[int]) -> "Attained":
        """Return the accuracy reached by the fitted tasks at ``rows`` of a variant with goals."""
        tasks = [variant.tasks[row] for row in rows]
        estimates = self.fitted[variant.label].at(rows)
        expected = [variant.goals[task.key] for task in tasks]
        goals = reduce.with_measured_bias(expected, tasks, estimates, variant.numerics)
        ratios = np.array([task.problem.ratio for task in tasks])
        per_block = self.plan.study.realizations_per_block
        realizations = per_block * self.fitted[variant.label].blocks[rows]
        accuracy = variant.numerics.accuracy or 0.0
        return reduce.attained(estimates, goals, ratios, accuracy, realizations)

    def _complete(self, variant: Variant, sound: np.ndarray, blocks: dict[str, int]) -> "Estimates":
        """Return the estimates of all tasks, with failed tasks marked. sound : the other rows."""
        rows, tasks = sound.tolist(), variant.tasks
        estimates = self.fitted[variant.label].at(rows)
        if variant.goals:
            accuracy = self.attained(variant, rows)
            estimates["accuracy_reached"] = accuracy.reached
            estimates["accuracy_status"] = accuracy.status
        per_block = self.plan.study.realizations_per_block
        counts = np.zeros(len(tasks), np.int32)
        counts[sound] = [blocks[tasks[row].key] * per_block for row in rows]
        return reduce.completed(self.plan, variant, estimates, sound, counts)

    def _load(self, variant: Variant, tasks: list[Task], blocks: dict[str, int]) -> "Blocks":
        groups = min(blocks[tasks[0].key], JACKKNIFE_GROUPS)  # equal for all tasks of a portion
        records = [(task.key, block) for task in tasks for block in range(blocks[task.key])]
        ends = np.cumsum([blocks[task.key] for task in tasks])[:-1]
        read = self.store.read(records, self.widths[variant.label])
        scalars, rows = (
            np.stack([reduce.grouped_means(means, groups) for means in np.split(whole, ends)])
            for whole in read
        )
        return reduce.blocks_of(self.plan, variant, tasks, scalars, rows)


class Fitted:
    """Estimates of the fitted tasks of a variant."""

    def __init__(self, variant: Variant) -> None:
        self.blocks = np.zeros(len(variant.tasks), int)  # in the fit of each task; 0: no fit yet
        self.arrays: Estimates = {}

    def enter(self, rows: list[int], estimates: "Estimates", blocks: list[int]) -> None:
        """Store the estimates of the tasks at ``rows``. blocks : number of blocks in each fit."""
        for name, values in estimates.items():
            if name not in self.arrays:
                self.arrays[name] = np.empty((self.blocks.size, *values.shape[1:]), values.dtype)
            self.arrays[name][rows] = values
        self.blocks[rows] = blocks

    def at(self, rows: list[int]) -> "Estimates":
        """Return the estimates at ``rows``; callers must not write to the arrays."""
        if rows == list(range(self.blocks.size)):
            return dict(self.arrays)  # not copied: the curves of 1e5 points are large
        return {name: values[rows] for name, values in self.arrays.items()}


def _portions(groups: dict[int, int]) -> list[list[int]]:
    """Return the rows in portions of tasks with the same number of jackknife groups.

    groups : number of groups by row. Each portion is reduced in one call.
    """
    rows_by_count: dict[int, list[int]] = {}
    for row, count in groups.items():
        rows_by_count.setdefault(count, []).append(row)
    size = TASKS_PER_REDUCTION
    return [
        rows[i : i + size] for rows in rows_by_count.values() for i in range(0, len(rows), size)
    ]


def _reduce_portion(portion: "tuple[list[int], Blocks]") -> "tuple[Estimates, float]":
    began = time.thread_time()
    estimates = reduce.reduce_blocks(portion[1])
    return estimates, time.thread_time() - began


def next_blocks(now: int, growth: float, most: int) -> int:
    """Return the number of blocks of the next round, or ``now`` if no more are needed.

    growth : factor by which the number must grow, from the measured standard errors. most : limit.
    """
    if growth <= 1.0:
        return now
    smallest, largest = GROWTH_LIMITS
    factor = min(max(NEED_MARGIN * growth, smallest), largest)
    return min(math.ceil(now * factor), most)


class Rounds:
    """Numbers of blocks of all tasks in successive rounds."""

    def __init__(self, plan: Plan) -> None:
        """Start with the first round of the plan."""
        self.plan = plan
        self.blocks = dict(plan.first)  # by key of the task
        self.open = {v.label: list(range(len(v.tasks))) for v in plan.variants if v.goals}
        self.number = 1

    def advance(self, collector: Collector) -> bool:
        """Raise the blocks of tasks that miss the accuracy; return whether to run another round."""
        for variant in self.plan.variants:
            if self.open.get(variant.label):
                self.open[variant.label] = self._raise_blocks(collector, variant)
        self.number += 1
        return any(self.open.values())

    def _raise_blocks(self, collector: Collector, variant: Variant) -> list[int]:
        """Raise the blocks of tasks that miss the accuracy, and return their rows."""
        failed, tasks = collector.store.failed, variant.tasks
        rows = [row for row in self.open[variant.label] if tasks[row].key not in failed]
        with collector.reporter(f"round {self.number}", [(variant, rows)], self.blocks) as reporter:
            if not (rows and collector.fit(variant, rows, self.blocks, reporter)):
                return []  # all failed, or stopped
        most = most_blocks(self.plan.study, variant.numerics.max_realizations)
        continued = []
        for row, growth in zip(rows, collector.attained(variant, rows).growth, strict=True):
            key = tasks[row].key
            blocks = next_blocks(self.blocks[key], float(growth), most)
            if blocks > self.blocks[key]:
                self.blocks[key] = blocks
                continued.append(row)
        return continued
