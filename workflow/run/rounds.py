"""Rounds of realizations: points that miss the accuracy get more, up to the cap.

A decision rests on the block means of the round alone, never on what else the store holds: the
same study takes the same rounds, with the same bits, whatever the workers, and after any crash.
"""

import math

import numpy as np

from workflow.plan.goal import JACKKNIFE_GROUPS, most_blocks
from workflow.plan.plan import Plan, Variant
from workflow.reduce.attained import attained
from workflow.run.collect import Collector
from workflow.simulate.tasks import Task

MARGIN = 1.1  # over the extrapolated need, or every other point would miss it by a hair
GROWTH = (1.25, 4.0)  # of the realizations from one round to the next


def next_blocks(now: int, growth: float, most: int) -> int:
    """Return the blocks of the next round; ``now`` where no more are needed or allowed.

    growth : factor that is lacking by the measured standard errors (attained.py).
    """
    if growth <= 1.0:
        return now
    least, largest = GROWTH
    factor = min(max(MARGIN * growth, least), largest)
    return min(JACKKNIFE_GROUPS * math.ceil(now * factor / JACKKNIFE_GROUPS), most)


class Rounds:
    """The number of blocks of every task, round after round."""

    def __init__(self, plan: Plan) -> None:
        """Begin with the first round of the plan."""
        self.plan = plan
        self.blocks = dict(plan.first)  # by key of the task
        self.open = {v.label: list(v.tasks) for v in plan.variants if v.goals}
        self.number = 1

    def go_on(self, collector: Collector) -> bool:
        """Judge the tasks of the round; return whether any needs more realizations."""
        for variant in self.plan.variants:
            if self.open.get(variant.label):
                self.open[variant.label] = self._short(collector, variant)
        self.number += 1
        return any(self.open.values())

    def _short(self, collector: Collector, variant: Variant) -> list[Task]:
        """Return the tasks that go on, with their blocks raised."""
        failed = collector.store.failed
        tasks = [task for task in self.open[variant.label] if task.key not in failed]
        if not tasks:
            return []
        estimates = collector.estimates(variant, tasks, self.blocks, f"round {self.number}")
        if not estimates:
            return []  # stopped
        goals = [variant.goals[task.key] for task in tasks]
        ratios = np.array([task.problem.ratio for task in tasks])
        found = attained(estimates, goals, ratios, variant.numerics.accuracy or 0.0)
        most = most_blocks(self.plan.study, variant.numerics.max_realizations)
        going = []
        for task, growth in zip(tasks, found.growth, strict=True):
            blocks = next_blocks(self.blocks[task.key], float(growth), most)
            if blocks > self.blocks[task.key]:
                self.blocks[task.key] = blocks
                going.append(task)
        return going
