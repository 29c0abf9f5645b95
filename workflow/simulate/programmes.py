"""Contribution of a programme of motion to the record of a realization."""

import math
from typing import Any

import numpy as np

from ...kernels import MOTION_TRACES, Case, Quantities, SceneCase
from ...kernels.compile.clock import computing_seconds
from .bodies import body_of
from .layout import CONTACT_LENGTH_EDGES, Layout
from .recorded_steps import trace_steps
from .tasks import SCALARS, Batch, Recording, Task

STEADY_ONLY = Quantities(steady=True, jump=False, relaxation=False, areas=True)


def add_programme(
    batch: Batch, line: Any, task: Task, places: Layout, values: np.ndarray, lines: int
) -> float:
    """Add one realization of a task to the sums of its row; return the CPU seconds.

    places : layout of the row. lines : number of lines so far, including this one. Times and
    positions of a trace enter as a running mean over the lines. It is exact if all lines move
    alike, unlike a sum that is divided by the number of lines.
    """
    if not batch.recording.requested:
        return 0.0
    began = computing_seconds()
    scene = scene_of(task, batch.scheme, batch.recording)
    body, drive = body_of(batch), task.problem.drive
    resumed = batch.resumed
    results = body.pull(line, scene, drive) if drive else body.run_scene(line, scene, resumed)
    for name, (first, shape) in places.items():
        if name in results:
            total, value = values[first : first + math.prod(shape)], np.ravel(results[name])
            total += (value - total) / lines if name in MOTION_TRACES else value
    return computing_seconds() - began


def scene_of(task: Task, scheme: str, recording: Recording) -> SceneCase:
    """Return the scene of a task for the kernels."""
    problem, steps = task.problem, task.steps_per_spacing
    recorded = trace_steps(problem, steps, recording)
    return SceneCase(
        spectrum=problem.spectrum,
        scheme=scheme,
        programme=problem.programme,
        load=problem.load if problem.indentation is None else math.nan,
        indentation=problem.indentation,
        start=problem.start,
        requested=recording.requested,
        recorded=recorded,
        edges=CONTACT_LENGTH_EDGES,
        frames=recorded if "snapshots" in recording.requested else np.empty(0, np.int64),
        effects=problem.kernel_effects,
    )


def steady_ends(batch: Batch, line: Any, task: Task) -> dict[str, Any]:
    """Return the steady values at the first and the last slide of a programme, by scalar name.

    A map also has "areas", the real contact, "hot", its temperatures if it is heated, and a single
    one "tiles", the sums over its tiles.

    Empty if these are the speeds before and after the velocity step, which the case computes.
    """
    problem = task.problem
    if not (problem.programme and batch.quantities.steady):
        return {}
    first, last = problem.ends
    if (first, last) == (problem.speed, problem.ratio * problem.speed):
        return {}
    case = Case(
        problem.load,
        first,
        (last / first,),
        (),
        batch.scheme,
        problem.spectrum,
        stepped=batch.stepped,
        tiles=batch.recording.tiles,
        effects=problem.kernel_effects,
    )
    body = body_of(batch)
    ((outcome,),) = body.run([line], body.prepare([case], task.steps_per_spacing, STEADY_ONLY))
    values = {name: getattr(outcome, name) for name in SCALARS if name not in ("mu_2", "jump")}
    if outcome.tiles is not None:
        values["tiles"] = outcome.tiles[0]
    if outcome.areas is not None:
        values["areas"] = outcome.areas
    if outcome.hot is not None:
        values["hot"] = outcome.hot
    return values | {"mu_2": float(outcome.mu_2[0])}
