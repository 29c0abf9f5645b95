"""Estimates of all tasks, in rounds, and assembly of the datasets.

Points that miss the accuracy get more realizations, up to the limit. This decision depends only on
the block means of the round, not on other stored records. The same study therefore takes the same
rounds and gives the same bits for any number of workers, and also after a crash.
"""

import math
from typing import TYPE_CHECKING

import numpy as np

from .. import reduce, result
from ..ground import UserError
from ..plan import Plan, Variant, most_blocks
from ..store import Store
from .graph import FitNode, Graph, Read

if TYPE_CHECKING:
    from ..reduce import Attained, Estimates
    from ..result import Groups


NEED_MARGIN = 1.1  # over the extrapolated need, which half of the points would miss narrowly
GROWTH_LIMITS = (1.25, 4.0)  # of the realizations from one round to the next


class Collector:
    """Estimates of the tasks of a plan; each task is fitted once per round."""

    def __init__(self, plan: Plan, store: Store) -> None:
        self.plan, self.store = plan, store
        self.fitted = {variant.label: Fitted(variant) for variant in plan.variants}

    def graph(self, blocks: dict[str, int], read: Read) -> Graph:
        """Return a graph with the fits that are left. blocks : of each task, by key."""
        failed = self.store.failed
        graph = Graph(self.plan, blocks, failed, read)
        for variant in self.plan.variants:
            fitted = self.fitted[variant.label].blocks.tolist()
            keys = [(row, task.key) for row, task in enumerate(variant.tasks)]
            left = [row for row, key in keys if key not in failed and fitted[row] != blocks[key]]
            graph.add_fits(variant, left)
        return graph

    def enter(self, fit: FitNode, estimates: "Estimates") -> None:
        """Enter the estimates of a fit."""
        self.fitted[fit.variant.label].enter(fit.rows, estimates, fit.blocks())

    def datasets(self, blocks: dict[str, int]) -> "Groups":
        """Return label -> dataset of every variant. blocks : number of blocks by key of the task.

        Failed tasks have estimates NaN, flags -1 and realizations 0. Raises UserError if all tasks
        of a variant failed.
        """
        datasets, other_body, other = {}, self.plan.other_body, None
        if other_body is not None:
            other = self._complete(other_body, np.array(self._sound(other_body)), blocks)
        for variant in self.plan.variants:
            if variant.study is not self.plan.study:  # serves only model_ratio
                continue
            estimates = other if variant is other_body else None
            if estimates is None:
                estimates = self._complete(variant, np.array(self._sound(variant)), blocks, other)
            exponents = reduce.exponents_of(self.plan, variant, estimates)
            datasets[variant.label] = result.build_dataset(self.plan, variant, estimates, exponents)
        return datasets

    def _sound(self, variant: Variant) -> list[int]:
        """Return the rows of the tasks that did not fail. Raises UserError if all failed."""
        rows = [row for row, t in enumerate(variant.tasks) if t.key not in self.store.failed]
        if not rows:
            where = variant.label or "the study"
            raise UserError(f"{where}: all problems failed, so that no result remains")
        return rows

    def attained(self, variant: Variant, rows: list[int]) -> "Attained":
        """Return the accuracy reached by the fitted tasks at ``rows`` of a variant with goals."""
        tasks = [variant.tasks[row] for row in rows]
        estimates = self.fitted[variant.label].at(rows)
        expected = [variant.goals[task.key] for task in tasks]
        goals = reduce.with_measured_bias(expected, tasks, estimates, variant.numerics)
        ratios = np.array([task.problem.ratio for task in tasks])
        per_block = variant.block_size
        realizations = per_block * self.fitted[variant.label].blocks[rows]
        accuracy = variant.numerics.accuracy or 0.0
        return reduce.attained(estimates, goals, ratios, accuracy, realizations)

    def _complete(
        self,
        variant: Variant,
        sound: np.ndarray,
        blocks: dict[str, int],
        other: "Estimates | None" = None,
    ) -> "Estimates":
        """Return the estimates of all tasks, with failed tasks marked.

        sound : rows of the others. other : as for ``completed``.
        """
        rows, tasks = sound.tolist(), variant.tasks
        estimates = self.fitted[variant.label].at(rows)
        if variant.goals:
            accuracy = self.attained(variant, rows)
            estimates["accuracy_reached"] = accuracy.reached
            estimates["accuracy_status"] = accuracy.status
        per_block = variant.block_size
        counts = np.zeros(len(tasks), np.int32)
        counts[sound] = [blocks[tasks[row].key] * per_block for row in rows]
        return reduce.completed(self.plan, variant, estimates, sound, counts, other)


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

    def advance(self, collector: Collector) -> bool:
        """Judge the fitted tasks of the round; return whether a further round is needed."""
        for variant in self.plan.variants:
            if self.open.get(variant.label):
                self.open[variant.label] = self._raise_blocks(collector, variant)
        return any(self.open.values())

    def _raise_blocks(self, collector: Collector, variant: Variant) -> list[int]:
        """Raise the blocks of tasks that miss the accuracy, and return their rows."""
        failed, tasks = collector.store.failed, variant.tasks
        rows = [row for row in self.open[variant.label] if tasks[row].key not in failed]
        if not rows:
            return []
        most = most_blocks(variant.study, variant.numerics.max_realizations)
        continued, before = [], dict(self.blocks)
        for row, growth in zip(rows, collector.attained(variant, rows).growth, strict=True):
            key = tasks[row].key
            blocks = next_blocks(before[key], float(growth), most)
            if blocks > before[key]:
                self.blocks[key] = max(blocks, self.blocks[key])
                continued.append(row)
        return continued
