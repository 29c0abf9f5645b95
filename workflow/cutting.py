"""Cut work to size: which tasks lack which blocks, and tasks that make up a batch together."""

from collections.abc import Container, Iterator

from workflow.pricing import Prices
from workflow.simulate.tasks import Record, Task


def missing_runs(
    group: list[Task], blocks: dict[str, int], stored: Container[Record]
) -> Iterator[tuple[list[Task], int, int]]:
    """Yield (tasks, first block, number of blocks) where the same tasks are missing."""
    run: tuple[list[Task], int, int] | None = None
    for block in range(max(blocks[task.key] for task in group)):
        tasks = [t for t in group if block < blocks[t.key] and (t.key, block) not in stored]
        if run and run[0] == tasks:
            run = (tasks, run[1], run[2] + 1)
        else:
            if run and run[0]:
                yield run
            run = (tasks, block, 1)
    if run and run[0]:
        yield run


def parts(
    prices: Prices, block: int, tasks: list[Task], target: float
) -> Iterator[tuple[list[Task], float]]:
    """Yield (tasks, predicted seconds of a block) of about ``target`` seconds at most.

    block : realizations per block. A task that takes longer is a part by itself.
    """
    part: list[Task] = []
    total = 0.0
    steps = -1
    for task in tasks:
        cost = block * prices.task(task)
        if part and total + cost > target:
            yield part, total
            part, total, steps = [], 0.0, -1
        if task.steps_per_spacing != steps:  # a line of its own
            steps = task.steps_per_spacing
            total += block * prices.line(task.problem.elements * steps)
        part.append(task)
        total += cost
    if part:
        yield part, total
