"""Contribution of a programme of motion to the record of a realization."""

import math
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from ...kernels import MOTION_TRACES, Case, Quantities, SceneCase
from ...kernels.compile.clock import computing_seconds
from ...kernels.drive import SLIPS
from .bodies import body_of
from .layout import CONTACT_LENGTH_EDGES, Layout
from .recorded_steps import trace_steps
from .tasks import SCALARS, Batch, Recording, Task

SHAPE_ERROR = 0.5  # times m^-2: of heights, due to straight lines between samples
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
    if "slip_changes" in places:
        pull = partial(body.pull, scene=scene._replace(slider_steps=0), drive=drive)
        results["slip_changes"] = slip_changes(pull, line, results)
    for name, (first, shape) in places.items():
        if name in results:
            total, value = values[first : first + math.prod(shape)], np.ravel(results[name])
            total += (value - total) / lines if name in MOTION_TRACES else value
    return computing_seconds() - began


def slip_changes(pull: Callable[..., dict], line: Any, results: dict) -> np.ndarray:
    """Return the relative changes of SLIPS under heights that differ by the error of the steps.

    pull : from a line to its results. results : of ``line``. Changes are zero for a drive that
    neither slips nor turns. A slip period of only one of the two runs counts as a change by 1.
    """
    if not results["is_unsteady"]:
        return np.zeros(len(SLIPS))
    factor = 1.0 + SHAPE_ERROR / line.steps_per_spacing**2
    repeated = pull(line._replace(z=factor * line.z, slope=factor * line.slope))
    values, others = (np.array([run[name] for name in SLIPS]) for run in (results, repeated))
    with np.errstate(all="ignore"):
        changes = np.nan_to_num(np.abs(others / values - 1.0), nan=1.0, posinf=1.0)
    same = (values == others) | (np.isnan(values) & np.isnan(others))
    return np.where(same, 0.0, changes)


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
        effects=problem.marched_effects(recording.requested),
        slider_steps=recording.every if recording.one_slider else 0,
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
