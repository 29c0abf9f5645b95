"""Steps of half the length on a few lines, from which a bias is read where no law tells it.

What changes is added up beside the number of lines that it was found on, so that means over any
blocks give the mean change.
"""

from typing import Any

import numpy as np

from ...kernels import Outcome
from .bodies import body_of
from .layout import Layout
from .programmes import steady_ends
from .recorded_steps import curve_steps, curve_times
from .tasks import Batch, Task

HALVED_STEP_SCALARS = (
    "mu_1",
    "jump",
    "mu_2",
)  # as the row of a record has them, after the count of lines
REFINEMENT_FACTOR = 2  # times the steps per spacing


def add_halved_steps(
    batch: Batch,
    layouts: list[Layout],
    cases: list,
    halved_cases: list,
    curves: np.ndarray,
    spent: np.ndarray,
) -> None:
    """Add the changes due to halved steps on the first line of the first blocks.

    cases, halved_cases : cases of every line, and the same at REFINEMENT_FACTOR times the steps.
    curves : sums over the lines of each block, shape (tasks, blocks, values). spent : CPU seconds
    of each phase, shape (tasks, phases); the time of this call is added.
    """
    body = body_of(batch)
    _, draw = body.drawing(batch)
    for block in range(min(batch.blocks, batch.recording.refined_blocks - batch.first_block)):
        drawn = draw(block * batch.realizations_per_block)
        for (prepared, shared), (halved, _) in zip(cases, halved_cases, strict=True):
            lines = [next(iter(drawn(own.steps_per_spacing))) for own in (prepared, halved)]
            (before,), (after,) = (
                body.run([line], own) for line, own in zip(lines, (prepared, halved), strict=True)
            )
            for rows, *pair in zip(shared, before, after, strict=True):
                spent[rows, 1:] += sum(np.array(own.seconds) for own in pair) / len(rows)
                for k, row in enumerate(rows):
                    _add(batch, lines, (k, row), pair, layouts[row], curves[row, block])


def _add(
    batch: Batch,
    lines: list[Any],
    place: tuple[int, int],
    pair: list[Outcome],
    places: Layout,
    values: np.ndarray,
) -> None:
    """Add what differs between two outcomes to the row of one record.

    place : number of the velocity jump in the case, and of the task in the batch.
    """
    k, row = place
    task = batch.tasks[row]
    tasks = task, task._replace(steps_per_spacing=REFINEMENT_FACTOR * task.steps_per_spacing)
    numbers = []
    for outcome, line, own in zip(pair, lines, tasks, strict=True):
        found = {"mu_1": outcome.mu_1, "jump": outcome.jump[k], "mu_2": outcome.mu_2[k]}
        found |= steady_ends(batch, line, own)
        numbers.append([found[name] for name in HALVED_STEP_SCALARS])
    first, (size,) = places["halved_steps"]
    values[first : first + size] += [1.0, *np.subtract(numbers[1], numbers[0])]
    if "halved_steps_curve" in places:
        coarse, fine = (outcome.curves[k] for outcome in pair)
        times, finer_times = _times(batch, task)
        started = pair[1].mu_1 + pair[1].jump[k]
        # Friction belongs to other times of a shorter step: read it at those of the longer.
        fine = np.interp(times, [0.0, *finer_times], [started, *fine])
        first, (size,) = places["halved_steps_curve"]
        values[first : first + coarse.size] += fine - coarse
        values[first + coarse.size : first + size] = np.nan


def _times(batch: Batch, task: Task) -> tuple[np.ndarray, np.ndarray]:
    """Return the times of a curve, with the steps of the task and with those halved."""
    problem, steps = task.problem, task.steps_per_spacing
    kept = curve_steps(task.march_steps, batch.recording.samples, problem.spectrum)
    per_tau = abs(problem.speed * problem.ratio) * steps
    how = batch.scheme, problem.spectrum
    return curve_times(kept, per_tau, *how), curve_times(
        REFINEMENT_FACTOR * kept, REFINEMENT_FACTOR * per_tau, *how
    )
