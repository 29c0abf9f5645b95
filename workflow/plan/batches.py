"""Cut the work of a plan into batches: which tasks lack which blocks, and what makes up a batch."""

from collections.abc import Container, Iterator

from workflow.plan.cost import Prices
from workflow.plan.plan import Plan, quantities
from workflow.simulate.tasks import Batch, Record, Task
from workflow.study.numerics import Numerics
from workflow.study.study import Study

BATCH_SECONDS = (1.0, 10.0)  # shortest and longest
MANY_BATCHES = 200  # from here on batches grow: each costs the scheduler milliseconds


def batch_target(seconds: float) -> float:
    """Return the length of a batch for ``seconds`` of predicted work."""
    shortest, longest = BATCH_SECONDS
    return min(max(shortest, seconds / MANY_BATCHES), longest)


def batches(
    plan: Plan,
    stored: Container[Record],
    target: float = BATCH_SECONDS[0],
    blocks: dict[str, int] | None = None,
) -> Iterator[Batch]:
    """Yield batches of about ``target`` predicted seconds covering every record not stored.

    Every missing record is in exactly one batch; results do not depend on the cut. What takes
    longer than the target comes first, longest first: no worker is left alone with it.
    blocks : number of blocks by key of the task, by default those expected.
    """
    block = plan.study.realizations_per_block
    pieces = [
        (seconds, variant.numerics, tasks, first, count)
        for variant in plan.variants
        for group in variant.by_line
        for missing, first, count in missing_runs(group, blocks or plan.expected, stored)
        for tasks, seconds in parts(plan.prices, block, missing, target)
    ]
    pieces.sort(key=lambda piece: -max(piece[0], target))
    for piece in pieces:
        yield from _cut(plan.study, target, *piece)


def _cut(
    study: Study,
    target: float,
    seconds: float,
    numerics: Numerics,
    tasks: list[Task],
    first: int,
    count: int,
) -> Iterator[Batch]:
    blocks = max(1, round(target / seconds))
    for start in range(first, first + count, blocks):
        number = min(blocks, first + count - start)
        yield Batch(
            seed=study.seed,
            normalisation=study.normalisation,
            quantities=quantities(study),
            scheme=numerics.scheme,
            samples=numerics.samples,
            tasks=tuple(tasks),
            first_block=start,
            blocks=number,
            realizations_per_block=study.realizations_per_block,
            seconds=number * seconds,
        )


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
