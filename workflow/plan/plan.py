"""The plan: which problems, which batches, what they cost. Pure data; computes nothing."""

import hashlib
import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from kernels import START, Origin, Quantities
from workflow.errors import UserError
from workflow.plan.cost import TYPICAL, Timings, task_seconds
from workflow.plan.goal import FIRST_SHARE, JACKKNIFE_GROUPS, Goal, goal_of, whole_blocks
from workflow.plan.motion import asked_of, recording_of
from workflow.plan.problems import distinct_problems
from workflow.plan.resolution import horizon_steps, steps_per_spacing
from workflow.simulate import (
    CODE,
    Recording,
    Surface,
    Task,
    kept_steps,
    row_layout,
    row_width,
)
from workflow.study import Material, Numerics, Study
from workflow.study import Surface as LinesOfStudy

DRIVER_BYTES = 300e6  # interpreter and libraries of the process that plans and collects
WORKER_BYTES = 200e6  # interpreter, libraries, machine code
BYTES_PER_SAMPLE = 130  # line, state and temporaries at the peak
BYTES_PER_TASK = 2000  # of the plan
BYTES_PER_RECORD = 1  # many share an entry of the index
BYTES_PER_POINT = 1000  # of the result, all estimates
MOST_RECORDS = 20_000_000  # planned, indexed and collected in minutes and in 2 GiB
BYTES_PER_CURVE_SAMPLE = 80  # the same, curves


class Variant(NamedTuple):
    """All tasks of one discretisation of the study, grouped by random line."""

    label: str
    numerics: Numerics
    material: Material
    lines: LinesOfStudy
    recording: Recording
    events: int  # samples of the longest trace; 0 where none is kept
    point_task: np.ndarray  # index into tasks per grid point, shape of the grid
    tasks: list[Task]  # in the order of the distinct problems
    by_line: list[list[Task]]  # tasks of one (H, N), steps per spacing ascending
    goals: dict[str, Goal]  # by key of the task; empty where no accuracy is asked for


class Plan(NamedTuple):
    """Everything a study will do."""

    study: Study
    variants: list[Variant]
    asked: Quantities  # of the kernels
    timings: Timings  # of the machine that the prediction is for
    task_seconds: dict[str, float]  # predicted, of one realization, by key of the task
    first: dict[str, int]  # blocks of the first round by key of the task, all where no goals are
    expected: dict[str, int]  # blocks that the goals are predicted to need

    @property
    def points(self) -> int:
        """Number of grid points."""
        return int(self.variants[0].point_task.size)

    @property
    def problems(self) -> int:
        """Number of distinct dimensionless problems."""
        return len(self.variants[0].tasks)

    @property
    def records(self) -> int:
        """Number of records (task, block) of the whole study, predicted where there are goals."""
        return sum(self.expected[t.key] for v in self.variants for t in v.tasks)

    def jackknife_groups(self, variant: Variant) -> int:
        """Return the number of groups of blocks for the jackknife."""
        return JACKKNIFE_GROUPS if variant.goals else self.study.blocks

    def longest_line(self) -> int:
        """Return the largest number of samples of any line."""
        return max(t.problem.elements * t.steps_per_spacing for v in self.variants for t in v.tasks)

    def widest_row(self, variant: Variant) -> int:
        """Return the largest number of values in a row of the store, of any task of a variant."""
        tasks = variant.tasks if variant.recording.asked else variant.tasks[:1]
        scheme, recording = variant.numerics.scheme, variant.recording
        return max(
            1, *(row_width(row_layout(task, self.asked, scheme, recording)) for task in tasks)
        )

    def predicted_worker_bytes(self) -> float:
        """Return the predicted peak memory of a worker."""
        return WORKER_BYTES + BYTES_PER_SAMPLE * self.longest_line()

    def predicted_driver_bytes(self) -> float:
        """Return the predicted peak memory of the process that plans, stores and collects."""
        tasks = sum(len(v.tasks) for v in self.variants)
        widest = max(self.widest_row(variant) for variant in self.variants)
        estimates = self.points * (BYTES_PER_POINT + BYTES_PER_CURVE_SAMPLE * widest)
        return DRIVER_BYTES + tasks * BYTES_PER_TASK + self.records * BYTES_PER_RECORD + estimates

    def first_point(self, task: Task) -> dict[str, float]:
        """Return the first grid point of a task: axis -> value."""
        variant = next(v for v in self.variants if task in v.tasks)
        point = int(np.argmax(variant.point_task == variant.tasks.index(task)))
        index = np.unravel_index(point, variant.point_task.shape)
        return {
            axis: self.study.grid[axis][i] for axis, i in zip(self.study.axes, index, strict=True)
        }


def make_plan(study: Study, timings: Timings = TYPICAL, origin: Origin = START) -> Plan:
    """Return the plan of a study. Raises UserError where a problem would be too large.

    timings : how fast the machine is; the size of batches depends on it, no result does.
    origin : where a programme that is resumed begins.
    """
    asked = asked_of(study)
    variants = [_variant(study, asked, label, origin) for label in study.variants]
    tasks = [task for variant in variants for task in variant.tasks]
    first = {task.key: study.blocks for task in tasks}
    expected = dict(first)
    for variant in variants:
        most = variant.numerics.max_realizations
        for key, goal in variant.goals.items():
            first[key] = whole_blocks(study, FIRST_SHARE * goal.realizations, most)
            expected[key] = whole_blocks(study, goal.realizations, most)
    _check_records(study, sum(expected.values()))
    seconds = {
        task.key: task_seconds(timings, asked, task, v.recording)
        for v in variants
        for task in v.tasks
    }
    return Plan(study, variants, asked, timings, seconds, first, expected)


def _check_records(study: Study, records: int) -> None:
    """Raise UserError where there are more records than a run can keep account of."""
    if records > MOST_RECORDS:
        least = study.realizations_per_block * math.ceil(records / MOST_RECORDS)
        raise UserError(
            f"study.realizations_per_block = {study.realizations_per_block}: {records} records "
            f"(problem x block), more than {MOST_RECORDS}; set it to {least} or more"
        )


def _variant(study: Study, asked: Quantities, label: str, origin: Origin) -> Variant:
    numerics = study.variants[label]
    recording = recording_of(study, numerics)._replace(origin=origin)
    problems, point_task = distinct_problems(study, label)
    tasks: list[Task] = []
    goals = {}
    lines: dict[tuple[float, int, Surface], list[Task]] = {}
    # What all tasks share, and all of many: written out once, as a plan has up to 1e5 tasks.
    shared = repr((CODE, study.seed, study.surfaces[label].normalisation, numerics.scheme))
    shared += repr((recording, asked, study.realizations_per_block))
    for problem in problems:
        goal = goal_of(problem, study.scene, numerics) if numerics.accuracy else None
        steps = goal.steps if goal else steps_per_spacing(problem, study.scene, numerics)
        march_steps = horizon_steps(problem, numerics, steps) if asked.relaxation else 0
        what = (problem[:5], steps, march_steps)
        key = hashlib.sha256(f"{shared}{what!r}{_written(problem[5:])}".encode()).hexdigest()[:32]
        task = Task(problem, steps, march_steps, key)
        tasks.append(task)
        lines.setdefault((problem.hurst, problem.elements, problem.surface), []).append(task)
        if goal:
            goals[task.key] = goal
    by_line = [
        sorted(one, key=lambda t: (t.steps_per_spacing, t.problem[:5])) for one in lines.values()
    ]
    material = study.materials[label]
    events = 0
    if recording.asked:
        events = max(kept_steps(t.problem, t.steps_per_spacing, recording).size for t in tasks)
    return Variant(
        label,
        numerics,
        material,
        study.surfaces[label],
        recording,
        events,
        point_task,
        tasks,
        by_line,
        goals,
    )


@lru_cache(maxsize=1000)
def _written(setting: tuple) -> str:
    """Return what a scene adds to a problem, for its key."""
    return repr(setting)
