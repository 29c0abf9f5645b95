"""Run a batch: draw its lines, run every realization, average over blocks."""

import math
from collections.abc import Iterable
from functools import lru_cache
from itertools import groupby, islice, repeat
from operator import attrgetter, itemgetter
from typing import Any, NamedTuple

import numpy as np

from ...kernels import MOTION_TRACES, Case, Outcome, Quantities
from ...kernels.compile.clock import computing_seconds
from ..system import keep_memory, peak_bytes, this_maker
from .bodies import BODIES, body_of
from .drawing import Draw
from .halved_steps import REFINEMENT_FACTOR, add_halved_steps
from .layout import Layout, row_layout, row_width
from .programmes import add_programme, steady_ends
from .recorded_steps import curve_steps
from .tasks import PHASES, SCALARS, Batch, BatchResult

scalars_of = attrgetter(*SCALARS)
SHORT = 8192  # samples of a line on which a call from Python takes longer than what is computed
TOGETHER = 4 * SHORT  # samples of lines that are short, at most, in one call
# All cases on a line of some steps per spacing, and of each the rows of its tasks.
Cases = list[tuple[Any, list[list[int]]]]


class BlockSums(NamedTuple):
    """Of a block: sums over its lines, and of when and where a trace is kept the means."""

    scalars: np.ndarray  # shape (tasks, len(SCALARS)), or those of one task
    curves: np.ndarray  # shape (tasks, values), likewise
    lines: int  # that are in them


@lru_cache
def load_kernels(body: str, scheme: str, asked: Quantities) -> None:
    """Compile the kernels of a body, or load them from the cache, once per process."""
    BODIES[body].load(scheme, asked)


def block_means(batch: Batch) -> BatchResult:
    """Run the batch, on one thread of any process."""
    keep_memory()
    if batch.quantities.anything:
        load_kernels(batch.tasks[0].problem.surface.body, batch.scheme, batch.quantities)
    began = computing_seconds()
    layouts = [row_layout(t, batch.quantities, batch.scheme, batch.recording) for t in batch.tasks]
    widths = [row_width(own) for own in layouts]
    scalars = np.zeros((len(batch.tasks), batch.blocks, len(SCALARS)))
    curves = np.zeros((len(batch.tasks), batch.blocks, max(1, *widths)))  # no empty rows in netCDF
    spent = np.zeros((len(batch.tasks), len(PHASES)))
    cases = _cases(batch)
    size, draw = body_of(batch).drawing(batch)
    numbers = range(0, batch.blocks * batch.realizations_per_block, size)
    several = max(1, TOGETHER // (size * batch.tasks[0].problem.elements))  # drawings
    for first in range(0, len(numbers), several):
        some: list[tuple[Draw, BlockSums]] = []
        for number in numbers[first : first + several]:
            block, before = divmod(number, batch.realizations_per_block)
            some.append((draw(number), BlockSums(scalars[:, block], curves[:, block], before)))
        _add_realizations(batch, layouts, cases, some, spent)
    if batch.recording.refined_blocks > batch.first_block:
        add_halved_steps(batch, layouts, cases, _cases(batch, REFINEMENT_FACTOR), curves, spent)
    for row, (width, places) in enumerate(zip(widths, layouts, strict=True)):
        curves[row, :, width:] = np.nan
        for name, (first, shape) in places.items():
            if name not in MOTION_TRACES:
                curves[row, :, first : first + math.prod(shape)] /= batch.realizations_per_block
    scalars /= batch.realizations_per_block
    used = computing_seconds() - began
    return BatchResult(scalars, curves, spent, used, peak_bytes(), this_maker())


def _add_realizations(
    batch: Batch,
    layouts: list[Layout],
    cases: Cases,
    draws: list[tuple[Draw, BlockSums]],
    spent: np.ndarray,
) -> None:
    """Add the realizations of some drawings to the sums of their blocks."""
    drawing = 0.0
    for prepared, shared in cases:
        steps = prepared.steps_per_spacing
        several = lines_at_once(batch.tasks[0].problem.elements * steps)
        lines = (
            (line, sums._replace(lines=sums.lines + count))
            for draw, sums in draws
            for count, line in enumerate(draw(steps), start=1)
        )
        while True:
            began = computing_seconds()
            some = list(islice(lines, several))
            drawing += computing_seconds() - began
            if not some:
                break
            found: Iterable = repeat([None] * len(shared))
            if batch.quantities.anything:
                found = body_of(batch).run([line for line, _ in some], prepared)
            for (line, sums), outcomes in zip(some, found, strict=False):
                for rows, outcome in zip(shared, outcomes, strict=True):
                    _add_case(batch, layouts, line, (rows, outcome), sums, spent)
    spent[:, 0] += drawing / len(batch.tasks)


def lines_at_once(samples: Any) -> Any:
    """Return how many lines of so many samples are run in one call: several that are short.

    samples : a number, or an array of them.
    """
    return 1 + (samples <= SHORT) * (TOGETHER // samples - 1)


def _add_case(
    batch: Batch,
    layouts: list[Layout],
    line: Any,
    case: tuple[list[int], Outcome | None],
    sums: BlockSums,
    spent: np.ndarray,
) -> None:
    """Add what a case, and the programmes of its tasks, give on a line to the sums of its rows."""
    rows, outcome = case
    for k, row in enumerate(rows):
        record = BlockSums(sums.scalars[row], sums.curves[row], sums.lines)
        task, places = batch.tasks[row], layouts[row]
        if outcome is None:
            record.scalars[:] = np.nan
        else:
            spent[row, 1:] += [seconds / len(rows) for seconds in outcome.seconds]
            _add_outcome(outcome, k, steady_ends(batch, line, task), places, record)
        spent[row, -1] += add_programme(batch, line, task, places, record.curves, record.lines)


def _cases(batch: Batch, times: int = 1) -> Cases:
    """Return what is run on every line; tasks that share a steady state at v1 are one case.

    times : as many steps per spacing as the tasks say.
    """
    shared: dict[tuple, list[int]] = {}
    for row, task in enumerate(batch.tasks):
        problem = task.problem
        key = (task.steps_per_spacing, problem.speed, problem.load)
        shared.setdefault(key, []).append(row)
    found: Cases = []
    for steps, keys in groupby(sorted(shared), itemgetter(0)):
        rows = [shared[key] for key in keys]
        given = [_case(batch, some, times) for some in rows] if batch.quantities.anything else ()
        found.append((body_of(batch).prepare(given, times * steps, batch.quantities), rows))
    return found


def _case(batch: Batch, rows: list[int], times: int) -> Case:
    tasks = [batch.tasks[row] for row in rows]
    kept: tuple[np.ndarray, ...] = ()
    if batch.quantities.relaxation:
        samples = batch.recording.samples
        steps = (curve_steps(t.march_steps, samples, t.problem.spectrum) for t in tasks)
        kept = tuple(times * own for own in steps)
    return Case(
        load=tasks[0].problem.load,
        speed=tasks[0].problem.speed,
        ratios=tuple(task.problem.ratio for task in tasks),
        kept_steps=kept,
        scheme=batch.scheme,
        spectrum=tasks[0].problem.spectrum,
        refine=batch.refine,
    )


def _add_outcome(
    outcome: Outcome, k: int, ends: dict[str, float], places: Layout, sums: BlockSums
) -> None:
    """Add velocity jump k of a case to the sums of one record, scalars and row.

    ends : what of the scalars belongs to other slides of a programme.
    """
    scalars, values, _ = sums
    found = scalars_of(outcome)
    if ends:
        found = tuple((dict(zip(SCALARS, found, strict=True)) | ends).values())
    # Each is one number, or one per velocity jump.
    scalars += [own[k] if isinstance(own, np.ndarray) else own for own in found]
    if outcome.curves:
        first, (size,) = places["curve"]
        curve = outcome.curves[k]
        values[first : first + curve.size] += curve
        values[first + curve.size : first + size] = np.nan
    if "initial_rate" in places:
        values[places["initial_rate"][0]] += outcome.initial_rate[k]
