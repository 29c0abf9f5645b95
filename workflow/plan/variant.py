"""Variants of a study: the tasks of each discretisation, with steps, goals and predicted times."""

import hashlib
import struct
from collections.abc import Sequence
from itertools import groupby
from typing import NamedTuple

import numpy as np

from ...kernels import Origin, Quantities
from ..simulate import CODE_HASH, REFINEMENT_FACTOR, LineShape, Problem, Recording, Task, trace_size
from ..study import Material, Numerics, Study, Surface
from .cost import HALVED_STEPS_COST, drawing_seconds, realization_seconds
from .goal import Goal, fits_worker, goal_of, horizon_steps, steps_per_spacing
from .motion import check_programme, kernel_quantities, recording_of
from .problems import distinct_problems, stack_problems

PROBLEM_BYTES = struct.Struct("<dqddd")  # H, N, load, speed, ratio, hashed in a task key
STEPS_BYTES = struct.Struct("<qq")


class Variant(NamedTuple):
    """All tasks of one discretisation of a study, grouped by random line."""

    label: str
    study: Study
    quantities: Quantities  # of the kernels
    numerics: Numerics
    material: Material
    lines: Surface
    recording: Recording
    events: int  # samples of the longest trace; 0 without a trace
    point_task: np.ndarray  # index into tasks per grid point, shape of the grid
    # In the order of the distinct problems. Problems that differ only in effects of the reduction
    # share a key, and thus their records.
    tasks: list[Task]
    by_line: list[list[Task]]  # one task per key of one (H, N); those that share sweeps together
    goals: dict[str, Goal]  # by key of the task; empty without a requested accuracy
    rows: dict[str, int]  # index of the last task by key
    seconds: list[float]  # predicted, of one realization without the drawing of its line
    longest: int  # largest number of samples of a line

    @property
    def block_size(self) -> int:
        """Realizations per block."""
        return self.study.realizations_per_block

    def realization_seconds(self, tasks: Sequence[Task]) -> float:
        """Return the predicted time of one realization of tasks that share their lines."""
        lines = {samples_of(task) for task in tasks}
        drawing = sum(map(drawing_seconds, sorted(lines)))
        return drawing + sum(self.seconds[self.rows[task.key]] for task in tasks)

    def total_seconds(self, blocks: dict[str, int]) -> float:
        """Return the predicted time. blocks : number by task key."""
        total = sum(blocks[key] * self.seconds[row] for key, row in self.rows.items())
        for line in self.by_line:
            for samples, tasks in groupby(line, samples_of):
                total += drawing_seconds(samples) * max([blocks[task.key] for task in tasks])
        return self.block_size * total


class Problems(NamedTuple):
    """Distinct problems of a variant. Variants of one material and surface share them."""

    problems: list[Problem]
    key_bytes: list[bytes]  # bytes of each problem that are hashed in its task key
    points: np.ndarray  # index of the problem of each grid point
    stacks: list[tuple[np.ndarray, Problem]]  # as ``stack_problems`` returns them


def problems_of(study: Study) -> dict[str, Problems]:
    """Return the distinct problems of each variant by its label."""
    problems: dict[str, Problems] = {}
    for label, material in study.materials.items():
        same = (
            other
            for other in problems
            if (material, study.surfaces[label], study.effects[label])
            == (study.materials[other], study.surfaces[other], study.effects[other])
        )
        other = next(same, None)
        problems[label] = _distinct(study, label) if other is None else problems[other]
    return problems


def _distinct(study: Study, label: str) -> Problems:
    problems, points = distinct_problems(study, label)
    # Many problems share all fields but the first five: these are converted to text once.
    settings = {
        p[5:]: repr(p._replace(effects=p.marched_effects(study.scene.quantities))[5:]).encode()
        for p in problems
    }
    key_bytes = [PROBLEM_BYTES.pack(*p[:5]) + settings[p[5:]] for p in problems]
    return Problems(problems, key_bytes, points, stack_problems(problems))


class Sizes(NamedTuple):
    """Steps, goals and predicted times, for each problem of a variant."""

    steps: list[int]  # per spacing
    march_steps: list[int]  # after the jump
    seconds: list[float]  # of one realization
    goals: list[Goal]  # empty without a requested accuracy


def _sizes_of(
    study: Study, quantities: Quantities, label: str, problems: Problems, origin: Origin
) -> Sizes:
    """Return the sizes of all problems, computed for each stack of problems at once."""
    numerics, recording = study.variants[label], recording_of(study, label)
    count = len(problems.problems)
    steps, march_steps = np.zeros((2, count), np.int64)
    seconds, goals = np.zeros(count), dict[int, Goal]()
    refined = min(recording.refined_blocks, study.blocks) / study.realizations
    for rows, many in problems.stacks:
        if numerics.accuracy:
            goal = goal_of(many, study.scene, numerics)
            steps[rows] = goal.steps
            for row, single in zip(rows.tolist(), goal.split(rows.size), strict=True):
                goals[row] = single
        else:
            steps[rows] = steps_per_spacing(many, study.scene, numerics)
        check_programme(many, steps[rows], origin)
        if quantities.relaxation:
            march_steps[rows] = horizon_steps(many, numerics, steps[rows])
        seconds[rows] = (1.0 + HALVED_STEPS_COST * refined) * realization_seconds(
            many, steps[rows], march_steps[rows], quantities, recording, numerics.scheme
        )
    in_order = [goals[row] for row in sorted(goals)]
    return Sizes(steps.tolist(), march_steps.tolist(), seconds.tolist(), in_order)


def variant_of(study: Study, label: str, problems: Problems, origin: Origin) -> Variant:
    """Return a variant of a study. problems : of the variant. origin : as for ``make_plan``."""
    quantities = kernel_quantities(study)
    sizes = _sizes_of(study, quantities, label, problems, origin)
    recording = _recording(study, label, problems.problems, sizes.steps)._replace(origin=origin)
    tasks = _tasks(study, quantities, label, recording, problems, sizes)
    keys = [task.key for task in tasks]
    events = 0
    if recording.requested:
        events = max(trace_size(t.problem, t.steps_per_spacing, recording) for t in tasks)
    return Variant(
        label=label,
        study=study,
        quantities=quantities,
        numerics=study.variants[label],
        material=study.materials[label],
        lines=study.surfaces[label],
        recording=recording,
        events=events,
        point_task=problems.points,
        tasks=tasks,
        by_line=_by_line(tasks),
        goals=dict(zip(keys, sizes.goals, strict=True)) if sizes.goals else {},
        rows={key: row for row, key in enumerate(keys)},
        seconds=sizes.seconds,
        longest=max(map(samples_of, tasks)),
    )


def _recording(study: Study, label: str, problems: list[Problem], steps: list[int]) -> Recording:
    """Return the recording of a variant; without halved steps if they do not fit a worker."""
    recording = recording_of(study, label)
    pairs = zip(problems, steps, strict=True)
    if recording.refined_blocks and not all(
        fits_worker(problem, REFINEMENT_FACTOR * count) for problem, count in pairs
    ):
        return recording._replace(refined_blocks=0)
    return recording


def _tasks(
    study: Study,
    quantities: Quantities,
    label: str,
    recording: Recording,
    problems: Problems,
    sizes: Sizes,
) -> list[Task]:
    """Return the tasks of a variant, each with the key of its results."""
    # The part of the key that all tasks share is hashed once, as a plan has up to 1e5 tasks.
    numerics = study.variants[label]
    shared = repr((CODE_HASH, study.seed, study.surfaces[label].normalisation, numerics.scheme))
    shared += repr((recording, quantities, study.realizations_per_block, numerics.refines))
    shared_hash, tasks = hashlib.sha256(shared.encode()), []
    for problem, key_bytes, steps, march_steps in zip(
        problems.problems, problems.key_bytes, sizes.steps, sizes.march_steps, strict=True
    ):
        digest = shared_hash.copy()
        digest.update(key_bytes + STEPS_BYTES.pack(steps, march_steps))
        tasks.append(Task(problem, steps, march_steps, digest.hexdigest()[:32]))
    return tasks


def _by_line(tasks: list[Task]) -> list[list[Task]]:
    """Return one task per key of each random line; tasks that share sweeps are neighbours."""
    lines: dict[tuple[float, int, LineShape], list[Task]] = {}
    for task in {task.key: task for task in tasks}.values():
        hurst, elements = task.problem[:2]
        lines.setdefault((hurst, elements, task.problem.surface), []).append(task)
    return [sorted(line, key=lambda t: (*sharing(t), t.problem[:5])) for line in lines.values()]


def sharing(task: Task) -> tuple[int, float]:
    """Return a key that tasks share if their steady states on a line are computed in one call.

    Loads may differ: thresholds do not depend on them, and sweeps run together (quick/steady).
    """
    return task.steps_per_spacing, task.problem.speed


def samples_of(task: Task) -> int:
    """Return the number of samples of the lines, or maps, of a task."""
    return int(task.problem.samples(task.steps_per_spacing))
