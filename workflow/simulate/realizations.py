"""Run of a batch: draw its lines, run every realization, average over each block."""

from collections.abc import Callable, Iterable, Iterator
from functools import lru_cache
from itertools import groupby, islice, repeat
from operator import attrgetter, itemgetter
from typing import Any, NamedTuple

import numpy as np

from ...kernels import MOTION_TRACES, Case, HotParts, Outcome, Quantities
from ...kernels.compile.clock import computing_seconds
from ..system import keep_memory, peak_bytes, this_maker
from .bodies import BODIES, CaseGroup, body_of
from .drawing import Draw
from .halved_steps import REFINEMENT_FACTOR, add_halved_steps
from .layout import Layout, add_to, row_layout, row_width, unpack
from .programmes import add_programme, at_jump, scalars_of, steady_ends
from .recorded_steps import record_steps
from .tasks import PHASES, SCALARS, Batch, BatchResult

MAX_SHORT_SAMPLES = 8192  # of a line whose computation is cheaper than a call from Python
MAX_CALL_SAMPLES = 4 * MAX_SHORT_SAMPLES  # of all short lines in one call


class BlockSums(NamedTuple):
    """Sums over the lines of a block; times and positions of a trace are running means."""

    scalars: np.ndarray  # shape (tasks, len(SCALARS))
    parts: list[dict[str, np.ndarray]]  # of the row of each task, by name
    lines: int  # number of lines in these sums


@lru_cache
def load_kernels(body: str, scheme: str, requested: Quantities) -> None:
    """Compile the kernels of a body, or load them from the cache, once per process."""
    BODIES[body].load(scheme, requested)


def block_means(batch: Batch) -> BatchResult:
    """Run a batch on one thread of any process, and return its block means."""
    keep_memory()
    if batch.quantities.anything:
        load_kernels(batch.tasks[0].problem.surface.body, batch.scheme, batch.quantities)
    began = computing_seconds()
    layouts = [row_layout(t, batch.quantities, batch.scheme, batch.recording) for t in batch.tasks]
    widths = [row_width(layout) for layout in layouts]
    scalars = np.zeros((len(batch.tasks), batch.blocks, len(SCALARS)))
    curves = np.zeros((len(batch.tasks), batch.blocks, max(1, *widths)))
    spent = np.zeros((len(batch.tasks), len(PHASES)))
    groups = _case_groups(batch)
    for draws in _draws(batch, layouts, scalars, curves):
        _add_realizations(batch, groups, draws, spent)
    if batch.recording.refined_blocks > batch.first_block:
        halved = _case_groups(batch, REFINEMENT_FACTOR)
        add_halved_steps(batch, layouts, groups, halved, curves, spent)
    for row, (width, places) in enumerate(zip(widths, layouts, strict=True)):
        curves[row, :, width:] = np.nan
        for name, part in unpack(curves[row], places).items():
            if name not in MOTION_TRACES:
                part /= batch.realizations_per_block
    scalars /= batch.realizations_per_block
    used = computing_seconds() - began
    return BatchResult(scalars, curves, spent, used, peak_bytes(), this_maker())


def _draws(
    batch: Batch, layouts: list[Layout], scalars: np.ndarray, curves: np.ndarray
) -> Iterator[list[tuple[Draw, BlockSums]]]:
    """Yield lists of drawings to run in one call, each with the sums of its block."""
    size, draw = body_of(batch).drawing(batch)
    numbers = range(0, batch.blocks * batch.realizations_per_block, size)
    count = max(1, MAX_CALL_SAMPLES // (size * batch.tasks[0].problem.elements))
    for first in range(0, len(numbers), count):
        draws = []
        for number in numbers[first : first + count]:
            block, before = divmod(number, batch.realizations_per_block)
            parts = [
                unpack(row[block], layout) for row, layout in zip(curves, layouts, strict=True)
            ]
            draws.append((draw(number), BlockSums(scalars[:, block], parts, before)))
        yield draws


def _add_realizations(
    batch: Batch, groups: list[CaseGroup], draws: list[tuple[Draw, BlockSums]], spent: np.ndarray
) -> None:
    """Add the realizations of some drawings to the sums of their blocks."""
    drawing_seconds = 0.0
    for prepared, shared in groups:
        steps = prepared.steps_per_spacing
        count = lines_at_once(batch.tasks[0].problem.elements * steps)
        all_lines = (
            (line, sums._replace(lines=sums.lines + number))
            for draw, sums in draws
            for number, line in enumerate(draw(steps), start=1)
        )
        while True:
            began = computing_seconds()
            lines = list(islice(all_lines, count))
            drawing_seconds += computing_seconds() - began
            if not lines:
                break
            results: Iterable = repeat([None] * len(shared))
            if batch.quantities.anything:
                results = body_of(batch).run([line for line, _ in lines], prepared)
            for (line, sums), outcomes in zip(lines, results, strict=False):
                for rows, outcome in zip(shared, outcomes, strict=True):
                    _add_case(batch, line, (rows, outcome), sums, spent)
    spent[:, 0] += drawing_seconds / len(batch.tasks)


def lines_at_once(samples: Any) -> Any:
    """Return the number of lines to run in one call: several if they are short.

    samples : of each line; a number or an array.
    """
    return 1 + (samples <= MAX_SHORT_SAMPLES) * (MAX_CALL_SAMPLES // samples - 1)


def _add_case(
    batch: Batch,
    line: Any,
    case: tuple[list[int], Outcome | None],
    sums: BlockSums,
    spent: np.ndarray,
) -> None:
    """Add the outcome of a case, and the programmes of its tasks, to the sums of their rows."""
    rows, outcome = case
    for k, row in enumerate(rows):
        task, parts = batch.tasks[row], sums.parts[row]
        if outcome is None:
            sums.scalars[row] = np.nan
        else:
            spent[row, 1:] += [seconds / len(rows) for seconds in outcome.seconds]
            ends = steady_ends(batch, line, task)
            sums.scalars[row] += scalars_of(outcome, k, ends)
            _add_parts(outcome, k, ends, parts)
        spent[row, -1] += add_programme(batch, line, task, parts, sums.lines)


def _case_groups(batch: Batch, refinement: int = 1) -> list[CaseGroup]:
    """Return the cases to run on every line; tasks with the same steady state at v1 share one.

    refinement : factor on the steps per spacing of the tasks.
    """
    shared: dict[tuple, list[int]] = {}
    for row, task in enumerate(batch.tasks):
        problem = task.problem
        key = task.steps_per_spacing, problem.speed, problem.load, problem.kernel_effects
        shared.setdefault(key, []).append(row)
    groups = []
    for steps, keys in groupby(sorted(shared, key=itemgetter(0, 1, 2)), itemgetter(0)):
        rows = [shared[key] for key in keys]
        cases = [_case(batch, r, refinement) for r in rows] if batch.quantities.anything else ()
        prepared = body_of(batch).prepare(cases, refinement * steps, batch.quantities)
        groups.append(CaseGroup(prepared, rows))
    return groups


def _case(batch: Batch, rows: list[int], refinement: int) -> Case:
    tasks = [batch.tasks[row] for row in rows]
    recorded: tuple[np.ndarray, ...] = ()
    if batch.quantities.relaxation:
        samples = batch.recording.samples
        recorded = tuple(
            refinement * record_steps(task.march_steps, samples, task.problem.spectrum)
            for task in tasks
        )
    return Case(
        load=tasks[0].problem.load,
        speed=tasks[0].problem.speed,
        ratios=tuple(task.problem.ratio for task in tasks),
        kept_steps=recorded,
        scheme=batch.scheme,
        spectrum=tasks[0].problem.spectrum,
        refine=batch.refine,
        stepped=batch.stepped,
        tiles=batch.recording.tiles,
        effects=tasks[0].problem.kernel_effects,
    )


# Parts of a row and the fields of an outcome that they sum, by velocity jump.
FIELDS: dict[str, Callable[[Any], Any]] = {
    "curve": attrgetter("curves"),
    "initial_rate": attrgetter("initial_rate"),
    "contact_2": attrgetter("areas.final"),
    "contact_step": lambda case: [(case.areas.before, after) for after in case.areas.after],
    "contact_curve": attrgetter("areas.curves"),
    **{name: attrgetter(f"hot.{name}") for name in HotParts._fields},
}
# Parts that belong to the first and the last slide of a programme, not to its velocity step.
OF_ENDS = ("contact_2", "contact_temperature", "flash_temperature", "mu_1_shear", "mu_2_shear")


def _add_parts(
    outcome: Outcome, k: int, ends: Outcome | None, parts: dict[str, np.ndarray]
) -> None:
    """Add velocity jump k of a case to the parts of one row; ends : as for ``scalars_of``."""
    for name, part in parts.items():
        if name in FIELDS:
            source, jump = (ends, 0) if ends is not None and name in OF_ENDS else (outcome, k)
            add_to(part, at_jump(FIELDS[name](source), jump))
    if outcome.tiles is not None:
        tiles = outcome.tiles[k]
        if ends is not None and ends.tiles is not None:
            tiles = np.concatenate([ends.tiles[0][:-1], tiles[-1:]])  # the last is the jump
        add_to(parts["tiles"], tiles)
