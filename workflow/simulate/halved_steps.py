"""Changes due to halved steps on a few lines: the bias of lines for which no law predicts it.

The number of lines is stored with the sums of changes, so that means over any blocks give the mean
change.
"""

from typing import Any, NamedTuple

import numpy as np

from ...kernels import Outcome
from .bodies import CaseGroup, body_of
from .layout import HALVED_STEP_SCALARS, Layout, add_to, unpack
from .programmes import scalars_of, steady_ends
from .recorded_steps import curve_times, record_steps
from .tasks import SCALARS, Batch, Task

REFINEMENT_FACTOR = 2  # of the steps per spacing


class Pair(NamedTuple):
    """Lines of one realization and their outcomes, each with full and with halved steps."""

    lines: list[Any]
    outcomes: list[Outcome]


def add_halved_steps(
    batch: Batch,
    layouts: list[Layout],
    groups: list[CaseGroup],
    halved_groups: list[CaseGroup],
    curves: np.ndarray,
    spent: np.ndarray,
) -> None:
    """Add the changes due to halved steps on the first line of the first blocks.

    groups, halved_groups : cases of every line, with full and with halved steps.
    curves : sums over the lines of each block, shape (tasks, blocks, values). spent : CPU seconds
    by phase, shape (tasks, phases); the time of this call is added.
    """
    body = body_of(batch)
    _, draw = body.drawing(batch)
    for block in range(min(batch.blocks, batch.recording.refined_blocks - batch.first_block)):
        drawing = draw(block * batch.realizations_per_block)
        for group, halved_group in zip(groups, halved_groups, strict=True):
            both = group.prepared, halved_group.prepared
            lines = [next(iter(drawing(cases.steps_per_spacing))) for cases in both]
            (full,), (halved,) = (
                body.run([line], cases) for line, cases in zip(lines, both, strict=True)
            )
            for rows, *outcomes in zip(group.rows, full, halved, strict=True):
                seconds = sum(np.array(outcome.seconds) for outcome in outcomes)
                spent[rows, 1:] += seconds / len(rows)
                for k, row in enumerate(rows):
                    pair, task = Pair(lines, outcomes), batch.tasks[row]
                    _add_change(batch, task, k, pair, unpack(curves[row, block], layouts[row]))


def _add_change(batch: Batch, task: Task, k: int, pair: Pair, parts: dict[str, np.ndarray]) -> None:
    """Add the change between two outcomes to the parts of the row of one record.

    k : number of the velocity jump of the task in its case.
    """
    halved_task = task._replace(steps_per_spacing=REFINEMENT_FACTOR * task.steps_per_spacing)
    numbers = []
    for line, outcome, own_task in zip(*pair, (task, halved_task), strict=True):
        values = scalars_of(outcome, k, steady_ends(batch, line, own_task))
        scalars = dict(zip(SCALARS, values, strict=True))
        numbers.append([scalars[name] for name in HALVED_STEP_SCALARS])
    add_to(parts["halved_steps"], [1.0, *np.subtract(numbers[1], numbers[0])])
    if "halved_steps_curve" in parts:
        full, halved = pair.outcomes
        times, halved_times = _curve_times(batch, task)
        # Halved steps end at other times: interpolate friction to the times of full steps.
        start = halved.mu_1 + halved.jump[k]
        halved_curve = np.interp(times, [0.0, *halved_times], [start, *halved.curves[k]])
        add_to(parts["halved_steps_curve"], halved_curve - full.curves[k])


def _curve_times(batch: Batch, task: Task) -> tuple[np.ndarray, np.ndarray]:
    """Return the times of a curve with the steps of the task, and with halved steps."""
    problem = task.problem
    steps = record_steps(task.march_steps, batch.recording.samples, problem.spectrum)
    per_tau = abs(problem.speed * problem.ratio) * task.steps_per_spacing
    law, factor = (batch.scheme, problem.spectrum), REFINEMENT_FACTOR
    return curve_times(steps, per_tau, *law), curve_times(factor * steps, factor * per_tau, *law)
