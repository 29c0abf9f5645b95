"""Collect stored block means, round after round, reduce them on the workers, assemble the datasets.

Points that miss the accuracy get more realizations, up to the cap. A decision rests on the block
means of the round alone, never on what else the store holds: the same study takes the same rounds,
with the same bits, whatever the workers, and after any crash.
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


# Slow to import: what is needed of them is, when it is used.


TASKS_PER_REDUCTION = 32
MARGIN = 1.1  # over the extrapolated need, or every other point would miss it by a hair
GROWTH = (1.25, 4.0)  # of the realizations from one round to the next


class Collector:
    """Reduces stored block means on the workers, those of a task once."""

    def __init__(
        self, workers: Workers, store: Store, plan: Plan, summary: Summary, watch: Watch
    ) -> None:
        """``watch`` : tells when to give up."""
        self.workers, self.store, self.plan = workers, store, plan
        self.summary, self.watch = summary, watch
        self.widths = {variant.label: plan.widest_row(variant) for variant in plan.variants}
        self.fitted = {variant.label: Fitted(variant) for variant in plan.variants}

    def datasets(self, blocks: dict[str, int]) -> "Groups":
        """Return label -> dataset of every variant, from ``blocks`` of each task (by key).

        Tasks that failed are marked: estimates NaN, flags -1, realizations 0. Empty if
        ``watch()`` turned true meanwhile.
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
        """Return the rows of the tasks that did not fail. Raises UserError where none is left."""
        rows = [row for row, t in enumerate(variant.tasks) if t.key not in self.store.failed]
        if not rows:
            where = variant.label or "the study"
            raise UserError(f"nothing is left of {where}: every problem failed")
        return rows

    def reporter(
        self, what: str, work: list[tuple[Variant, list[int]]], blocks: dict[str, int]
    ) -> Reporter:
        """Return what reports on fits at rows of variants, one for all of them."""
        seconds = (self._seconds(variant, rows, blocks).values() for variant, rows in work)
        return Reporter(what, sum(map(sum, seconds)))

    def _seconds(
        self, variant: Variant, rows: list[int], blocks: dict[str, int]
    ) -> dict[int, float]:
        """Return the predicted time of the fits that are open at some rows of a variant."""
        fitted = self.fitted[variant.label].blocks
        counts = {row: blocks[variant.tasks[row].key] for row in rows}
        groups = {r: min(n, JACKKNIFE_GROUPS) for r, n in counts.items() if fitted[r] != n}
        return {row: fit_seconds(self.plan, number) for row, number in groups.items()}

    def fit(
        self, variant: Variant, rows: list[int], blocks: dict[str, int], reporter: Reporter
    ) -> bool:
        """Fit the tasks at some rows of a variant, from ``blocks`` of each; tell the reporter.

        Those that are fitted from so many blocks already stay as they are. Returns whether all
        are fitted now: not where ``watch()`` turned true meanwhile.
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
        """Return which accuracy the fitted tasks at some rows have; for a variant with goals."""
        tasks = [variant.tasks[row] for row in rows]
        estimates = self.fitted[variant.label].at(rows)
        expected = [variant.goals[task.key] for task in tasks]
        goals = reduce.with_found_bias(expected, tasks, estimates, variant.numerics)
        ratios = np.array([task.problem.ratio for task in tasks])
        each = self.plan.study.realizations_per_block
        realizations = each * self.fitted[variant.label].blocks[rows]
        wanted = variant.numerics.accuracy or 0.0
        return reduce.attained(estimates, goals, ratios, wanted, realizations)

    def _complete(self, variant: Variant, sound: np.ndarray, blocks: dict[str, int]) -> "Estimates":
        """Return all that the result says of each task, sound rows from their fits."""
        rows, tasks = sound.tolist(), variant.tasks
        estimates = self.fitted[variant.label].at(rows)
        if variant.goals:
            found = self.attained(variant, rows)
            estimates["accuracy_reached"] = found.reached
            estimates["accuracy_status"] = found.status
        each = self.plan.study.realizations_per_block
        counts = np.zeros(len(tasks), np.int32)
        counts[sound] = [blocks[tasks[row].key] * each for row in rows]
        return reduce.completed(self.plan, variant, estimates, sound, counts)

    def _load(self, variant: Variant, tasks: list[Task], blocks: dict[str, int]) -> "Blocks":
        groups = min(blocks[tasks[0].key], JACKKNIFE_GROUPS)  # of all, see _portions
        records = [(task.key, block) for task in tasks for block in range(blocks[task.key])]
        ends = np.cumsum([blocks[task.key] for task in tasks])[:-1]
        read = self.store.read(records, self.widths[variant.label])
        scalars, rows = (
            np.stack([reduce.grouped_means(own, groups) for own in np.split(whole, ends)])
            for whole in read
        )
        return reduce.blocks_of(self.plan, variant, tasks, scalars, rows)


class Fitted:
    """Estimates of the tasks of a variant, as far as they are fitted."""

    def __init__(self, variant: Variant) -> None:
        self.blocks = np.zeros(len(variant.tasks), int)  # from how many; 0: not fitted
        self.arrays: Estimates = {}

    def enter(self, rows: list[int], estimates: "Estimates", blocks: list[int]) -> None:
        """Take the estimates of some tasks."""
        for name, values in estimates.items():
            if name not in self.arrays:
                self.arrays[name] = np.empty((self.blocks.size, *values.shape[1:]), values.dtype)
            self.arrays[name][rows] = values
        self.blocks[rows] = blocks

    def at(self, rows: list[int]) -> "Estimates":
        """Return the estimates of some tasks, all fitted; not to be written to."""
        if rows == list(range(self.blocks.size)):
            return dict(self.arrays)  # not copied: curves of 1e5 points are large
        return {name: values[rows] for name, values in self.arrays.items()}


def _portions(groups: dict[int, int]) -> list[list[int]]:
    """Return the rows of tasks in portions of as many jackknife groups each.

    groups : by row. A portion is reduced in one call.
    """
    alike: dict[int, list[int]] = {}
    for row, count in groups.items():
        alike.setdefault(count, []).append(row)
    size = TASKS_PER_REDUCTION
    return [rows[i : i + size] for rows in alike.values() for i in range(0, len(rows), size)]


def _reduce_portion(portion: "tuple[list[int], Blocks]") -> "tuple[Estimates, float]":
    began = time.thread_time()
    estimates = reduce.reduce_blocks(portion[1])
    return estimates, time.thread_time() - began


def next_blocks(now: int, growth: float, most: int) -> int:
    """Return the blocks of the next round; ``now`` where no more are needed or allowed.

    growth : factor that is lacking by the measured standard errors (attained.py).
    """
    if growth <= 1.0:
        return now
    least, largest = GROWTH
    factor = min(max(MARGIN * growth, least), largest)
    return min(math.ceil(now * factor), most)


class Rounds:
    """The number of blocks of every task, round after round."""

    def __init__(self, plan: Plan) -> None:
        """Begin with the first round of the plan."""
        self.plan = plan
        self.blocks = dict(plan.first)  # by key of the task
        self.open = {v.label: list(range(len(v.tasks))) for v in plan.variants if v.goals}
        self.number = 1

    def go_on(self, collector: Collector) -> bool:
        """Judge the tasks of the round; return whether any needs more realizations."""
        for variant in self.plan.variants:
            if self.open.get(variant.label):
                self.open[variant.label] = self._short(collector, variant)
        self.number += 1
        return any(self.open.values())

    def _short(self, collector: Collector, variant: Variant) -> list[int]:
        """Return the rows of the tasks that go on, with their blocks raised."""
        failed, tasks = collector.store.failed, variant.tasks
        rows = [row for row in self.open[variant.label] if tasks[row].key not in failed]
        with collector.reporter(f"round {self.number}", [(variant, rows)], self.blocks) as reporter:
            if not (rows and collector.fit(variant, rows, self.blocks, reporter)):
                return []  # all failed, or stopped
        most = most_blocks(self.plan.study, variant.numerics.max_realizations)
        going = []
        for row, growth in zip(rows, collector.attained(variant, rows).growth, strict=True):
            key = tasks[row].key
            blocks = next_blocks(self.blocks[key], float(growth), most)
            if blocks > self.blocks[key]:
                self.blocks[key] = blocks
                going.append(row)
        return going
