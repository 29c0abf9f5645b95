"""Contribution of a programme of motion to the record of a realization."""

import math
from collections.abc import Callable
from functools import partial
from operator import attrgetter
from typing import Any

import numpy as np

from ...kernels import MOTION_TRACES, Case, Outcome, Quantities, SceneCase
from ...kernels.compile.clock import computing_seconds
from ...kernels.drive import SLIPS
from .bodies import body_of
from .layout import CONTACT_LENGTH_EDGES
from .recorded_steps import trace_steps
from .tasks import SCALARS, Batch, Recording, Task

SHAPE_ERROR = 0.5  # times m^-2: of heights, due to straight lines between samples
FIELDS_OF_SCALARS = attrgetter(*SCALARS)
STEADY_ONLY = Quantities(steady=True, jump=False, relaxation=False, areas=True)


def add_programme(
    batch: Batch, line: Any, task: Task, parts: dict[str, np.ndarray], lines: int
) -> float:
    """Add one realization of a task to the parts of its row; return the CPU seconds.

    lines : number of lines so far, including this one. Times and positions of a trace enter as a
    running mean over the lines. It is exact if all lines move alike, unlike a sum that is divided
    by the number of lines.
    """
    if not batch.recording.requested:
        return 0.0
    began = computing_seconds()
    scene = scene_of(task, batch.scheme, batch.recording)
    body, drive = body_of(batch), task.problem.drive
    resumed = batch.resumed
    results = body.pull(line, scene, drive) if drive else body.run_scene(line, scene, resumed)
    if "slip_changes" in parts:
        pull = partial(body.pull, scene=scene._replace(slider_steps=0), drive=drive)
        results["slip_changes"] = slip_changes(pull, line, results)
    for name, total in parts.items():
        if name in results:
            value = np.reshape(results[name], total.shape)
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


def steady_ends(batch: Batch, line: Any, task: Task) -> Outcome | None:
    """Return steady sliding at the speeds of the first and the last slide of a programme.

    The second speed is that of the only velocity jump of the outcome. None if these are the speeds
    before and after the velocity step, which the case of the task computes.
    """
    problem = task.problem
    if not (problem.programme and batch.quantities.steady):
        return None
    first, last = problem.ends
    if (first, last) == (problem.speed, problem.ratio * problem.speed):
        return None
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
    return outcome


def scalars_of(outcome: Outcome, k: int, ends: Outcome | None) -> list[float]:
    """Return the SCALARS of velocity jump k of a case.

    ends : as ``steady_ends`` returns it; its scalars replace all but the jump.
    """
    scalars = [at_jump(value, k) for value in FIELDS_OF_SCALARS(outcome)]
    if ends is None:
        return scalars
    jump = SCALARS.index("jump")
    at_ends = [at_jump(value, 0) for value in FIELDS_OF_SCALARS(ends)]
    return [*at_ends[:jump], scalars[jump], *at_ends[jump + 1 :]]


def at_jump(value: Any, k: int) -> Any:
    """Return the entry of velocity jump k of a field of an outcome; a number has no entries."""
    return value[k] if isinstance(value, np.ndarray | list) else value
