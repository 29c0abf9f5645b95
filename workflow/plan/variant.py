"""The variants of a study: all tasks of each discretisation, as the laws size them."""

import hashlib
import struct
from collections.abc import Sequence
from itertools import groupby
from typing import NamedTuple

import numpy as np

from ...kernels import Origin, Quantities
from ..simulate import (
    CODE_HASH,
    REFINEMENT_FACTOR,
    LineShape,
    Problem,
    Recording,
    Task,
    leg_counts,
    trace_steps,
)
from ..study import Material, Numerics, Study, Surface
from .cost import PARTS, Pace, Work, drawing_seconds, kind_of, typical_seconds
from .goal import Goal, goal_of, horizon_steps, may_have, steps_per_spacing
from .motion import check_programme, recording_of
from .problems import distinct_problems, sharers, together

NUMBERS = struct.Struct("<dqddd")  # of a problem, as they stand in its key: to the bit
STEPS = struct.Struct("<qq")


class Variant(NamedTuple):
    """All tasks of one discretisation of the study, grouped by random line."""

    label: str
    numerics: Numerics
    material: Material
    lines: Surface
    recording: Recording
    events: int  # samples of the longest trace; 0 where none is kept
    point_task: np.ndarray  # index into tasks per grid point, shape of the grid
    tasks: list[Task]  # in the order of the distinct problems
    by_line: list[list[Task]]  # tasks of one (H, N), what shares sweeps side by side
    goals: dict[str, Goal]  # by key of the task; empty where no accuracy is asked for
    kind: str  # of the work
    rows: dict[str, int]  # numbers of the tasks by key
    typical: np.ndarray  # s, of one realization but for its line, shape (tasks, PARTS)
    factors: np.ndarray  # by which this machine takes longer, shape (PARTS,)
    seconds: list[float]  # predicted, of one realization but for its line
    longest: int  # samples of a line

    def typical_of(self, tasks: Sequence[Task]) -> np.ndarray:
        """Return the typical seconds of one realization of tasks that share their lines."""
        found = self.typical[[self.rows[task.key] for task in tasks]].sum(axis=0)
        found[0] += sum(map(drawing_seconds, sorted(set(map(samples_of, tasks)))))
        return found

    def drawing_of(self, blocks: dict[str, int]) -> float:
        """Return the typical seconds of drawing the lines of so many blocks of each task once."""
        total = 0.0
        for line in self.by_line:
            for samples, tasks in groupby(line, samples_of):
                total += drawing_seconds(samples) * max([blocks[task.key] for task in tasks])
        return total

    def leg_counts(self) -> np.ndarray:
        """Return the steps of each leg of the programme, shape (tasks, legs)."""
        return np.array([leg_counts(t.problem, t.steps_per_spacing) for t in self.tasks])


class Problems(NamedTuple):
    """The distinct problems of a variant, which others may share."""

    each: list[Problem]
    written: list[bytes]  # as they stand in keys
    points: np.ndarray  # number of the problem of each grid point
    together: list[tuple[np.ndarray, Problem]]  # for the laws


def problems_of(study: Study) -> dict[str, Problems]:
    """Return the problems of each variant, once for those of one material and surface."""
    found: dict[str, Problems] = {}
    for label, material in study.materials.items():
        own = material, study.surfaces[label]
        others = (
            other for other in found if own == (study.materials[other], study.surfaces[other])
        )
        if (other := next(others, None)) is not None:
            found[label] = found[other]
            continue
        each, points = distinct_problems(study, label)
        # What a scene adds, which many share, is written out once.
        settings = {added: repr(added).encode() for added in {one[5:] for one in each}}
        written = [NUMBERS.pack(*one[:5]) + settings[one[5:]] for one in each]
        found[label] = Problems(each, written, points, together(each))
    return found


def _sized(
    study: Study, asked: Quantities, label: str, problems: Problems, origin: Origin
) -> tuple[np.ndarray, np.ndarray, list[Goal]]:
    """Return what the laws say of each problem, of those that are alike at once.

    Steps per spacing and of the march, shape (2, problems); typical seconds by part, shape
    (problems, PARTS); goals, none where no accuracy is asked for.
    """
    numerics, recording = study.variants[label], recording_of(study, label)
    extra = (
        min(recording.refined_blocks, study.blocks) / study.realizations
    )  # lines with halved steps too
    count = len(problems.each)
    sizes, typical = np.zeros((2, count), np.int64), np.zeros((count, len(PARTS)))
    goals: list[Goal] = []
    for rows, many in problems.together:
        goal = goal_of(many, study.scene, numerics) if numerics.accuracy else None
        steps = goal.steps if goal else steps_per_spacing(many, study.scene, numerics)
        check_programme(many, steps, origin)
        march_steps = horizon_steps(many, numerics, steps) if asked.relaxation else 0 * steps
        for row, own in enumerate((steps, march_steps)):  # one for all if given
            sizes[row, rows] = own
        shared = sharers(many, steps)
        work = Work(many, steps, march_steps, numerics.refines, *shared, numerics.scheme)
        parts = typical_seconds(asked, work, recording)
        if recording.refined_blocks:
            halved = work._replace(
                steps=REFINEMENT_FACTOR * steps, march_steps=REFINEMENT_FACTOR * march_steps
            )
            alone = recording._replace(requested=())
            for each in (work, halved):
                more = typical_seconds(asked, each, alone)
                parts = {part: parts[part] + extra * more[part] for part in PARTS}
        for column, part in enumerate(PARTS):
            typical[rows, column] = parts[part]
        if goal:
            goals = goals or [goal] * count
            for row, single in zip(rows.tolist(), goal.each(rows.size), strict=True):
                goals[row] = single
    return sizes, typical, goals


def variant_of(
    study: Study,
    asked: Quantities,
    pace: Pace,
    label: str,
    problems: Problems,
    origin: Origin,
) -> Variant:
    """Return a variant of a study; ``problems`` are its own, ``origin`` as for ``make_plan``."""
    numerics = study.variants[label]
    recording = recording_of(study, label)._replace(origin=origin)
    sizes, typical, goals = _sized(study, asked, label, problems, origin)
    each, marches = sizes.tolist()
    pairs = zip(problems.each, each, strict=True)
    if recording.refined_blocks and not all(
        may_have(own, REFINEMENT_FACTOR * steps) for own, steps in pairs
    ):
        recording = recording._replace(refined_blocks=0)
    # What all tasks share, and all of many: written out once, as a plan has up to 1e5 tasks.
    shared = repr((CODE_HASH, study.seed, study.surfaces[label].normalisation, numerics.scheme))
    shared += repr((recording, asked, study.realizations_per_block, numerics.refines))
    begun, tasks = hashlib.sha256(shared.encode()), []
    for problem, written, steps, march_steps in zip(
        problems.each, problems.written, each, marches, strict=True
    ):
        digest = begun.copy()
        digest.update(written + STEPS.pack(steps, march_steps))
        tasks.append(Task(problem, steps, march_steps, digest.hexdigest()[:32]))
    lines: dict[tuple[float, int, LineShape], list[Task]] = {}
    for task in tasks:
        hurst, elements = task.problem[:2]
        lines.setdefault((hurst, elements, task.problem.surface), []).append(task)
    by_line = [sorted(one, key=lambda t: (*sharing(t), t.problem[:5])) for one in lines.values()]
    keys = [task.key for task in tasks]
    kind = kind_of(tasks[0].problem, recording)
    factors = np.array([pace.rate(kind, part).factor for part in PARTS])
    events = 0
    if recording.requested:
        events = max(trace_steps(t.problem, t.steps_per_spacing, recording).size for t in tasks)
    return Variant(
        label,
        numerics,
        study.materials[label],
        study.surfaces[label],
        recording,
        events,
        problems.points,
        tasks,
        by_line,
        dict(zip(keys, goals, strict=True)) if goals else {},
        kind,
        {key: row for row, key in enumerate(keys)},
        typical,
        factors,
        (typical @ factors).tolist(),
        max(map(samples_of, tasks)),
    )


def sharing(task: Task) -> tuple[int, float]:
    """Return what tasks on a line have in common whose steady states are found together.

    Those of all loads are: thresholds are the same, and sweeps lie side by side (quick/steady).
    """
    return task.steps_per_spacing, task.problem.speed


def samples_of(task: Task) -> int:
    """Return the number of samples of the lines, or maps, of a task."""
    return int(task.problem.samples(task.steps_per_spacing))
