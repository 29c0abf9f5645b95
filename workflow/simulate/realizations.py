"""Run a batch: draw its lines, run every realization, average over blocks."""

import time
from functools import lru_cache

import numpy as np

from kernels import SCHEMES, Case, Line, Outcome, Quantities, amplitudes, draw_phases, run_case
from kernels.cache import compiling
from workflow.simulate.tasks import PHASES, SCALARS, Batch, BatchResult, Task
from workflow.system import peak_bytes, this_maker


def record_steps(march_steps: int, curve_samples: int) -> np.ndarray:
    """Return the numbers of the steps that the curve of a record keeps.

    They increase from 1 to ``march_steps``, and are ``curve_samples`` - 1 at most. Sample 0 of a
    curve is the moment just after the jump and needs no step.
    """
    return np.unique(np.round(np.linspace(1, march_steps, curve_samples - 1)).astype(np.int64))


def record_times(kept_steps: np.ndarray, steps_per_tau: float, scheme: str) -> np.ndarray:
    """Return the times since the jump, in tau, to which the friction of kept steps belongs.

    It is a mean over the step and acts ``lag`` of a step before its end (rheology/law.py). At
    the end it would be an error of first order. steps_per_tau : of the march.
    """
    return (kept_steps - SCHEMES[scheme](1.0 / steps_per_tau).lag) / steps_per_tau


def line_generator(seed: int, hurst: float, elements: int, index: int) -> np.random.Generator:
    """Return the generator of one line: a function of study seed, H, N and index alone.

    Every m, scheme, load and speed sees the same line; batching and order play no part.
    """
    hurst_bits = int(np.float64(hurst).view(np.uint64))
    return np.random.default_rng([seed, hurst_bits, elements, index])


@lru_cache
def load_kernels(scheme: str, asked: Quantities) -> None:
    """Compile the kernels, or load them from the cache, once per process.

    One process of a machine at a time: the others find what the first one compiled.
    """
    with compiling():
        line = Line.self_affine(amplitudes(0.5, 16), np.linspace(0.0, 6.0, 8), 16, 2)
        run_case(line, Case(0.1, 1.0, (1.2,), (np.arange(1, 3),), scheme), asked)


def block_means(batch: Batch) -> BatchResult:
    """Run the batch, on one thread of any process."""
    load_kernels(batch.scheme, batch.quantities)
    began = time.thread_time()
    scalars = np.zeros((len(batch.tasks), batch.blocks, len(SCALARS)))
    curves = np.zeros((len(batch.tasks), batch.blocks, batch.curve_samples - 1))
    spent = np.zeros((len(batch.tasks), len(PHASES)))
    problem = batch.tasks[0].problem  # all tasks are of its H and N
    amplitude = amplitudes(problem.hurst, problem.elements, batch.normalisation)
    for block in range(batch.blocks):
        first = (batch.first_block + block) * batch.realizations_per_block
        for index in range(first, first + batch.realizations_per_block):
            sums = scalars[:, block], curves[:, block]
            _add_realization(batch, amplitude, index, sums, spent)
    scalars /= batch.realizations_per_block
    curves /= batch.realizations_per_block
    used = time.thread_time() - began
    return BatchResult(scalars, curves, spent, used, peak_bytes(), this_maker())


def _add_realization(
    batch: Batch,
    amplitude: np.ndarray,
    index: int,
    sums: tuple[np.ndarray, np.ndarray],
    spent: np.ndarray,
) -> None:
    """Add one realization of every task to the sums of scalars and curves, one row per task."""
    began = time.thread_time()
    hurst, elements = batch.tasks[0].problem.hurst, batch.tasks[0].problem.elements
    phases = draw_phases(line_generator(batch.seed, hurst, elements, index), elements)
    line = None
    drawing = 0.0
    for rows in _shared_cases(batch.tasks):
        steps = batch.tasks[rows[0]].steps_per_spacing
        if line is None or line.steps_per_spacing != steps:
            line = Line.self_affine(amplitude, phases, elements, steps)
            drawing += time.thread_time() - began
        outcome = run_case(line, _case(batch, rows), batch.quantities)
        _add_outcome(outcome, rows, *sums)
        spent[rows, 1:] += np.array(outcome.seconds) / len(rows)
        began = time.thread_time()
    spent[:, 0] += drawing / len(batch.tasks)


def _shared_cases(tasks: tuple[Task, ...]) -> list[list[int]]:
    """Return rows of tasks that share a steady state at v1, those of one m together."""
    cases: dict[tuple, list[int]] = {}
    for row, task in enumerate(tasks):
        problem = task.problem
        key = (task.steps_per_spacing, problem.speed, problem.load)
        cases.setdefault(key, []).append(row)
    return [cases[key] for key in sorted(cases)]


def _case(batch: Batch, rows: list[int]) -> Case:
    tasks = [batch.tasks[row] for row in rows]
    return Case(
        load=tasks[0].problem.load,
        speed=tasks[0].problem.speed,
        ratios=tuple(task.problem.ratio for task in tasks),
        kept_steps=tuple(record_steps(task.march_steps, batch.curve_samples) for task in tasks),
        scheme=batch.scheme,
    )


def _add_outcome(
    outcome: Outcome, rows: list[int], scalars: np.ndarray, curves: np.ndarray
) -> None:
    for column, name in enumerate(SCALARS):  # one number, or one per velocity jump
        scalars[rows, column] += getattr(outcome, name)
    for k, row in enumerate(rows):
        curve = outcome.curves[k] if outcome.curves else np.empty(0)
        curves[row, : curve.size] += curve
        curves[row, curve.size :] = np.nan
