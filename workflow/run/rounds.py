"""Rounds of realizations: points that miss the accuracy get more, up to the cap.

A decision rests on the block means of the round alone, never on what else the store holds: the
same study takes the same rounds, with the same bits, whatever the workers, and after any crash.
"""

import math

from ..plan import Plan, Variant, most_blocks
from .collect import Collector

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
        if not (rows and collector.fit(variant, rows, self.blocks, f"round {self.number}")):
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
