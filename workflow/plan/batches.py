"""Batches: the records of a plan that the store lacks, cut into pieces of similar duration.

The store is read once, record by record. The missing records can then be cut to any length.
"""

from bisect import bisect_right
from collections.abc import Callable, Container, Iterator
from itertools import groupby
from typing import NamedTuple

from ..simulate import Batch, Record, Task
from .cost import drawing_seconds
from .plan import Plan
from .variant import Variant, samples_of, sharing

MIN_BATCH_SECONDS, MAX_BATCH_SECONDS = 1.0, 10.0
MANY_BATCHES = 200  # more work makes batches longer, as each costs the scheduler milliseconds
MAX_SHARED_LENGTH = 6.0  # of a piece whose tasks share sweeps, over the target
RECUT_FACTOR = 2.0  # pieces that exceed the target by this factor are cut again


class Missing(NamedTuple):
    """Tasks on the same random lines that lack the same blocks."""

    variant: Variant
    tasks: list[Task]
    first_block: int
    blocks: int
    seconds: float  # predicted, per block


def batch_target(seconds: float) -> float:
    """Return the duration of a batch (s), for ``seconds`` of predicted work."""
    return min(max(MIN_BATCH_SECONDS, seconds / MANY_BATCHES), MAX_BATCH_SECONDS)


def missing_work(
    plan: Plan, stored: Container[Record], blocks: dict[str, int] | None = None
) -> list[Missing]:
    """Return the records of a plan that are not stored, each in exactly one entry.

    stored : records that need no computing, as a store or a set.
    blocks : number of blocks by task key, by default the expected ones.
    """
    counts = blocks or plan.expected
    return [
        Missing(
            variant, tasks, first, count, variant.block_size * variant.realization_seconds(tasks)
        )
        for variant in plan.variants
        for line in variant.by_line
        for tasks, first, count in _missing_runs(line, counts, stored)
    ]


def total_seconds(missing: list[Missing]) -> float:
    """Return the predicted core-seconds of missing work."""
    return sum(entry.blocks * entry.seconds for entry in missing)


def total_records(missing: list[Missing]) -> int:
    """Return the number of missing records."""
    return sum(entry.blocks * len(entry.tasks) for entry in missing)


def cut(missing: list[Missing], target: float) -> list[Missing]:
    """Return pieces of missing work whose single blocks take at most about ``target`` seconds.

    Tasks that share sweeps stay together up to MAX_SHARED_LENGTH times the target, and a single
    task is never divided. Pieces longer than the target come first, the longest first, so that no
    worker is left alone with a long piece at the end.
    """
    pieces = [piece for entry in missing for piece in _pieces(entry, target)]
    return sorted(pieces, key=lambda piece: -max(piece.seconds, target))


def make_batches(
    pieces: list[Missing], target: float, rate: Callable[[str], float] = lambda _: 1.0
) -> Iterator[Batch]:
    """Yield batches of about ``target`` seconds that cover the pieces of ``cut``.

    Every missing record is in exactly one batch; results do not depend on the cut.

    rate : label of a variant -> measured over predicted time of its work. It is called for each
    piece when its batches are made, so that finished batches correct later ones.
    """
    for piece in pieces:
        predicted = target / rate(piece.variant.label)  # ``target`` in predicted seconds
        long = piece.seconds > RECUT_FACTOR * predicted
        for part in _pieces(piece, predicted) if long else [piece]:
            blocks, end = max(1, round(predicted / part.seconds)), part.first_block + part.blocks
            for start in range(part.first_block, end, blocks):
                yield batch_of(part, start, min(blocks, end - start))


def batch_of(piece: Missing, first_block: int, blocks: int) -> Batch:
    """Return the batch of some blocks of a piece."""
    variant = piece.variant
    block_size, lines = variant.block_size, variant.lines
    heights, modes = None, lines.amplitudes  # in h; modes: of lines with a measured spectrum
    if lines.power is not None:
        elements = piece.tasks[0].problem.elements
        modes = lines.drawn_amplitudes(elements) / variant.study.grid["roughness"][0]
    elif lines.profile is not None:
        roughness = lines.profile.roughness
        if modes is None:
            rows = slice(first_block * block_size, (first_block + blocks) * block_size)
            heights = lines.profile.heights[rows] / roughness
        else:
            modes = modes / roughness
    return Batch(
        seed=variant.study.seed,
        normalisation=lines.normalisation,
        quantities=variant.quantities,
        scheme=variant.numerics.scheme,
        recording=variant.recording,
        tasks=tuple(piece.tasks),
        first_block=first_block,
        blocks=blocks,
        realizations_per_block=block_size,
        seconds=blocks * piece.seconds,
        refine=variant.numerics.refines,
        heights=heights,
        modes=modes,
    )


def _missing_runs(
    line: list[Task], blocks: dict[str, int], stored: Container[Record]
) -> Iterator[tuple[list[Task], int, int]]:
    """Yield (tasks, first block, number of blocks) for blocks missing from the same tasks."""
    counts = [(task, blocks[task.key]) for task in line]
    ends = sorted({count for _, count in counts})
    requested = [[task for task, count in counts if count >= end] for end in ends]

    def lacking(block: int) -> list[Task]:
        if not stored:  # every requested block is missing
            return requested[bisect_right(ends, block)]
        return [t for t, count in counts if block < count and (t.key, block) not in stored]

    for tasks, run in groupby(range(ends[-1]), lacking):
        if tasks:
            first, *others = run
            yield tasks, first, 1 + len(others)


def _pieces(whole: Missing, target: float) -> Iterator[Missing]:
    """Yield pieces of missing work, by tasks, whose single blocks take about ``target`` seconds."""
    block_size = whole.variant.block_size
    chosen: list[Task] = []
    lines: set[int] = set()
    total = 0.0
    for tasks in _groups(whole, target):
        samples, seconds = samples_of(tasks[0]), _seconds_on_lines(whole.variant, tasks)
        drawing = block_size * drawing_seconds(samples)
        added = seconds if samples in lines else seconds + drawing
        if chosen and total + added > target:
            yield whole._replace(tasks=chosen, seconds=total)
            chosen, lines, total, added = [], set(), 0.0, seconds + drawing
        chosen += tasks
        lines.add(samples)
        total += added
    yield whole._replace(tasks=chosen, seconds=total)


def _groups(whole: Missing, target: float) -> Iterator[list[Task]]:
    """Yield groups of tasks that share sweeps, or single tasks if a group takes too long."""
    for _, group in groupby(whole.tasks, sharing):
        tasks = list(group)
        if _seconds_on_lines(whole.variant, tasks) <= MAX_SHARED_LENGTH * target:
            yield tasks
        else:
            yield from ([task] for task in tasks)


def _seconds_on_lines(variant: Variant, tasks: list[Task]) -> float:
    """Return the predicted time of one block of tasks, without drawing the lines."""
    seconds = sum(variant.seconds[variant.rows[task.key]] for task in tasks)
    return variant.block_size * seconds
