"""What a programme of motion adds to the record of a realization."""

import math
from typing import Any

import numpy as np

from ...kernels import MOTION_TRACES, Case, Quantities, SceneCase
from ...kernels.compile.clock import computing_seconds
from .bodies import body_of
from .layout import EDGES, Layout
from .recorded_steps import trace_steps
from .tasks import SCALARS, Batch, Recording, Task

STEADY = Quantities(steady=True, jump=False, relaxation=False)


def add_programme(
    batch: Batch, line: Any, task: Task, places: Layout, values: np.ndarray, lines: int
) -> float:
    """Add one realization of a task to the sums of its row, laid out as ``places`` say.

    When and where a trace is kept enters as the mean over the lines until now, which with this one
    are ``lines``: where all are moved alike it stays what it is to the bit, as no sum would over
    its number. Returns the CPU seconds that it took.
    """
    seconds = 0.0
    if batch.recording.requested:
        began = computing_seconds()
        scene = scene_of(task, batch.scheme, batch.recording)
        body, drive = body_of(batch), task.problem.drive
        found = (
            body.pull(line, scene, drive) if drive else body.run_scene(line, scene, batch.resumed)
        )
        for name, (first, shape) in places.items():
            if name not in found:
                continue
            own, value = values[first : first + math.prod(shape)], np.ravel(found[name])
            own += (value - own) / lines if name in MOTION_TRACES else value
        seconds = computing_seconds() - began
    return seconds


def scene_of(task: Task, scheme: str, recording: Recording) -> SceneCase:
    """Return the scene of a task for the kernels."""
    problem, steps = task.problem, task.steps_per_spacing
    requested = recording.requested
    recorded = trace_steps(problem, steps, recording)
    return SceneCase(
        spectrum=problem.spectrum,
        scheme=scheme,
        programme=problem.programme,
        load=problem.load if problem.indentation is None else math.nan,
        indentation=problem.indentation,
        start=problem.start,
        requested=requested,
        recorded=recorded,
        edges=EDGES,
        frames=recorded if "snapshots" in requested else np.empty(0, np.int64),
    )


def steady_ends(batch: Batch, line: Any, task: Task) -> dict[str, float]:
    """Return steady values at the first and the last slide of a programme, by name of the scalar.

    Empty where they are those before and after the velocity step, which the case gives.
    """
    problem = task.problem
    if not (problem.programme and batch.quantities.steady):
        return {}
    first, last = problem.ends
    if (first, last) == (problem.speed, problem.ratio * problem.speed):
        return {}
    case = Case(problem.load, first, (last / first,), (), batch.scheme, problem.spectrum)
    body = body_of(batch)
    ((found,),) = body.run([line], body.prepare([case], task.steps_per_spacing, STEADY))
    values = {name: getattr(found, name) for name in SCALARS if name not in ("mu_2", "jump")}
    return values | {"mu_2": float(found.mu_2[0])}
