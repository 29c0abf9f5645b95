"""Batches: what of a plan is not stored yet, cut into work of about equal length.

The store is asked once, record by record; what is missing is then cut to any length.
"""

from bisect import bisect_right
from collections.abc import Container, Iterator
from itertools import groupby
from typing import NamedTuple

from ..simulate import Batch, Record, Task
from .cost import drawing_seconds
from .plan import Plan
from .variant import Variant, samples_of, sharing

BATCH_SECONDS = (1.0, 10.0)  # shortest and longest
MANY_BATCHES = 200  # from here on batches grow: each costs the scheduler milliseconds
TOGETHER = 6.0  # lengths of a batch, up to which tasks that share sweeps stay together


class Missing(NamedTuple):
    """Tasks on the same random lines that lack the same blocks."""

    variant: Variant
    tasks: list[Task]
    first_block: int
    blocks: int
    seconds: float  # predicted, per block


def batch_target(seconds: float) -> float:
    """Return the length of a batch for ``seconds`` of predicted work."""
    shortest, longest = BATCH_SECONDS
    return min(max(shortest, seconds / MANY_BATCHES), longest)


def missing_work(
    plan: Plan, stored: Container[Record], blocks: dict[str, int] | None = None
) -> list[Missing]:
    """Return what of a plan is not stored: every such record is in exactly one entry.

    stored : tells which records need not be computed, a store or a set.
    blocks : number of blocks by key of the task, by default those expected.
    """
    wanted = blocks or plan.expected
    return [
        Missing(variant, tasks, first, count, block_seconds(plan, variant, tasks))
        for variant in plan.variants
        for line in variant.by_line
        for tasks, first, count in _missing_runs(line, wanted, stored)
    ]


def total_seconds(missing: list[Missing]) -> float:
    """Return the predicted core-seconds of missing work."""
    return sum(entry.blocks * entry.seconds for entry in missing)


def total_records(missing: list[Missing]) -> int:
    """Return the number of missing records."""
    return sum(entry.blocks * len(entry.tasks) for entry in missing)


def block_seconds(plan: Plan, variant: Variant, tasks: list[Task]) -> float:
    """Return the predicted time of one block of tasks that share their lines."""
    return plan.study.realizations_per_block * float(variant.typical_of(tasks) @ variant.factors)


def cut(plan: Plan, missing: list[Missing], target: float) -> list[Missing]:
    """Return missing work whose blocks take about ``target`` seconds each at most.

    Tasks that share sweeps stay together up to TOGETHER times as long, and a task that takes longer
    stays whole. What takes longer than the target comes first, longest first: no worker is left
    alone with it.
    """
    found = [piece for entry in missing for piece in _pieces(plan, entry, target)]
    return sorted(found, key=lambda piece: -max(piece.seconds, target))


def make_batches(plan: Plan, pieces: list[Missing], target: float) -> Iterator[Batch]:
    """Yield batches of about ``target`` predicted seconds covering the pieces of ``cut``.

    Every missing record is in exactly one batch; results do not depend on the cut.
    """
    each = plan.study.realizations_per_block
    for piece in pieces:
        surface = piece.variant.lines
        heights, modes = None, surface.amplitudes  # in h, of measured lines and of lines like them
        if surface.profile is not None and modes is None:
            heights = surface.profile.heights / surface.profile.roughness
        elif surface.profile is not None and modes is not None:
            modes = modes / surface.profile.roughness
        blocks = max(1, round(target / piece.seconds))
        end = piece.first_block + piece.blocks
        for start in range(piece.first_block, end, blocks):
            number, first = min(blocks, end - start), start * each
            yield Batch(
                seed=plan.study.seed,
                normalisation=surface.normalisation,
                quantities=plan.asked,
                scheme=piece.variant.numerics.scheme,
                recording=piece.variant.recording,
                tasks=tuple(piece.tasks),
                first_block=start,
                blocks=number,
                realizations_per_block=each,
                seconds=number * piece.seconds,
                refine=piece.variant.numerics.refines,
                heights=None if heights is None else heights[first : first + number * each],
                modes=modes,
            )


def _missing_runs(
    line: list[Task], blocks: dict[str, int], stored: Container[Record]
) -> Iterator[tuple[list[Task], int, int]]:
    """Yield (tasks, first block, number of blocks) where the same tasks are missing."""
    counts = [(task, blocks[task.key]) for task in line]
    ends = sorted({count for _, count in counts})

    def lacking(block: int) -> list[Task]:
        if not stored:  # nothing lacks but what is not wanted: the same up to the next end
            return wanted[bisect_right(ends, block)]
        return [t for t, count in counts if block < count and (t.key, block) not in stored]

    wanted = [[task for task, count in counts if count >= end] for end in ends]
    for tasks, run in groupby(range(ends[-1]), lacking):
        if tasks:
            first, *others = run
            yield tasks, first, 1 + len(others)


def _pieces(plan: Plan, whole: Missing, target: float) -> Iterator[Missing]:
    """Yield the tasks of missing work, as many together as take ``target`` seconds a block."""
    variant, each = whole.variant, plan.study.realizations_per_block
    chosen: list[Task] = []
    lines: set[int] = set()
    total = 0.0
    groups: list[list[Task]] = []  # what shares sweeps, unless that takes too long
    for _, group in groupby(whole.tasks, sharing):
        tasks = list(group)
        together = _own_seconds(plan, variant, tasks) <= TOGETHER * target
        groups += [tasks] if together else [[task] for task in tasks]
    for tasks in groups:
        samples, own = samples_of(tasks[0]), _own_seconds(plan, variant, tasks)
        drawing = each * float(variant.factors[0] * drawing_seconds(samples))
        shared = own if samples in lines else own + drawing
        if chosen and total + shared > target:
            yield whole._replace(tasks=chosen, seconds=total)
            chosen, lines, total, shared = [], set(), 0.0, own + drawing
        chosen += tasks
        lines.add(samples)
        total += shared
    yield whole._replace(tasks=chosen, seconds=total)


def _own_seconds(plan: Plan, variant: Variant, tasks: list[Task]) -> float:
    """Return the predicted time of one block of some tasks, but for drawing lines."""
    each = plan.study.realizations_per_block
    return each * sum(variant.seconds[variant.rows[task.key]] for task in tasks)
