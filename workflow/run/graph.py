"""The graph of a round: marches of batches, and fits of tasks that wait for their batches."""

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

import numpy as np

from .. import reduce
from ..plan import JACKKNIFE_GROUPS, Missing, Plan, Variant, make_batches
from ..simulate import Record, Task
from ..store import DamagedShard
from .node import Node
from .workers import FIT, MARCH, fit_seconds

if TYPE_CHECKING:
    from ..reduce import BlockPlace, Portion

MAX_TASKS = 32  # of a fit
MAX_FIT_BYTES = 2**24  # of block means, for a fit of several tasks

# read(records, width) returns the scalars and curves of stored records.
Read = Callable[[list[Record], int], tuple[np.ndarray, np.ndarray]]


class FitNode(Node):
    """Tasks of a variant that are fitted in one call."""

    def __init__(self, graph: "Graph", variant: Variant, rows: list[int]) -> None:
        super().__init__(FIT, None)
        self.graph, self.variant, self.rows = graph, variant, rows

    def prepare(self) -> bool:
        """Set the portion and the marches that give results to it; leave out failed tasks.

        Returns False if no task is left, or if a stored record turns out damaged.
        """
        tasks = self.variant.tasks
        self.rows = [row for row in self.rows if tasks[row].key not in self.graph.failed]
        self.given = [node for node in self.needs() if node.result is not None]
        try:
            self.item = self.graph.portion(self)
        except DamagedShard:
            self.graph.damaged = True
            return False
        return bool(self.rows)

    def finish(self) -> None:
        """Release the portion and its estimates too."""
        super().finish()
        self.item = self.result = None

    def blocks(self) -> list[int]:
        """Return the number of blocks of each task."""
        return [self.graph.blocks[self.variant.tasks[row].key] for row in self.rows]

    def seconds(self) -> float:
        """Return the predicted time."""
        groups = (min(count, JACKKNIFE_GROUPS) for count in self.blocks())
        return sum(fit_seconds(self.graph.plan, count) for count in groups)


class Graph:
    """Marches and fits of a round. A fit is given the results of its marches, and stored records.

    plan : of the study. blocks : of each task, by key. failed : keys of failed tasks. read : reads
    stored records.
    """

    def __init__(self, plan: Plan, blocks: dict[str, int], failed: dict[str, str], read: Read):
        self.plan, self.blocks, self.failed, self.read = plan, blocks, failed, read
        self.damaged = False  # whether a record could not be read
        self.fits: list[FitNode] = []
        self.fits_of: dict[str, list[FitNode]] = {}  # by key of the task
        self.widths = {v.label: plan.widest_row(v) for v in plan.variants}

    def add_fits(self, variant: Variant, rows: list[int]) -> None:
        """Add the fits of the tasks at rows of a variant."""
        counts = {row: self.blocks[variant.tasks[row].key] for row in rows}
        for portion in _portions(counts, 8 * self.widths[variant.label]):
            fit = FitNode(self, variant, portion)
            self.fits.append(fit)
            for row in portion:
                self.fits_of.setdefault(variant.tasks[row].key, []).append(fit)

    def nodes(
        self, pieces: list[Missing], target: float, rate: Callable[[str], float]
    ) -> Iterator[Node]:
        """Yield the marches of the pieces, and each fit after the last of its marches.

        Marches of one fit follow each other, so that few results are kept for fits to come.
        target, rate : as for ``make_batches``.
        """
        rest = dict(enumerate(pieces))
        pieces_of: dict[FitNode, list[int]] = {}
        for number, piece in rest.items():
            for fit in self._fits_of(piece.tasks):
                pieces_of.setdefault(fit, []).append(number)

        def marches(numbers: list[int]) -> Iterator[Node]:
            begun = [rest.pop(number) for number in numbers if number in rest]
            for batch in make_batches(begun, target, rate):
                node = Node(MARCH, batch)
                for fit in self._fits_of(batch.tasks):
                    fit.inputs.append(node)
                yield node

        for number, piece in enumerate(pieces):
            yield from marches([number])
            for fit in self._fits_of(piece.tasks):
                if fit in pieces_of:
                    yield from marches(pieces_of.pop(fit))
                    yield fit
        yield from (fit for fit in self.fits if not (fit.inputs or fit.done))

    def portion(self, fit: FitNode) -> "Portion":
        """Return the portion of a fit. Raises DamagedShard."""
        tasks, blocks = [fit.variant.tasks[row] for row in fit.rows], fit.blocks()
        rows: dict[str, list[int]] = {}
        for row, task in enumerate(tasks):
            rows.setdefault(task.key, []).append(row)
        lacking = [np.ones(count, bool) for count in blocks]
        places: list[list[BlockPlace]] = []
        for batch in (node.item for node in fit.given):
            places.append([])
            for number, task in enumerate(batch.tasks):
                for row in rows.get(task.key, ()):
                    count = min(batch.blocks, blocks[row] - batch.first_block)
                    if count > 0:
                        places[-1].append(reduce.BlockPlace(row, number, batch.first_block, count))
                        lacking[row][batch.first_block : batch.first_block + count] = False
        how, width = reduce.reduction_of(fit.variant), self.widths[fit.variant.label]
        groups = min([*blocks, JACKKNIFE_GROUPS])  # equal for all tasks
        portion = reduce.Portion(how, tasks, blocks, groups, width, places, [])
        self._add_stored(portion, [np.flatnonzero(numbers) for numbers in lacking])
        return portion

    def _add_stored(self, portion: "Portion", lacking: list[np.ndarray]) -> None:
        """Add the stored blocks of each task, or their group means if all its blocks are stored."""
        records = [
            (task.key, block)
            for task, numbers in zip(portion.tasks, lacking, strict=True)
            for block in numbers.tolist()
        ]
        if not records:
            return
        ends = np.cumsum([numbers.size for numbers in lacking])[:-1]
        read = (np.split(values, ends) for values in self.read(records, portion.width))
        for row, (scalars, curves) in enumerate(zip(*read, strict=True)):
            numbers = lacking[row]
            if numbers.size == portion.blocks[row]:
                portion.blocks[row], numbers = portion.groups, np.arange(portion.groups)
                scalars, curves = (
                    reduce.grouped_means(means, portion.groups) for means in (scalars, curves)
                )
            if numbers.size:
                portion.stored.append(reduce.StoredBlocks(row, numbers, scalars, curves))

    def _fits_of(self, tasks: "list[Task] | tuple[Task, ...]") -> dict[FitNode, None]:
        """Return the fits of tasks, each once."""
        return dict.fromkeys(fit for task in tasks for fit in self.fits_of.get(task.key, ()))


def _portions(blocks: dict[int, int], block_bytes: int) -> Iterator[list[int]]:
    """Yield the rows of tasks in portions with equal numbers of jackknife groups.

    blocks : of each task, by row. A portion is reduced in one call.
    """
    rows_by_groups: dict[int, list[int]] = {}
    for row, count in blocks.items():
        rows_by_groups.setdefault(min(count, JACKKNIFE_GROUPS), []).append(row)
    for rows in rows_by_groups.values():
        fitting = MAX_FIT_BYTES // (block_bytes * max(blocks[row] for row in rows))
        size = min(MAX_TASKS, max(1, fitting))
        yield from (rows[i : i + size] for i in range(0, len(rows), size))
