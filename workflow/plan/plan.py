"""Plan of a study: problems and predicted cost, as plain data."""

import math
from typing import NamedTuple

import numpy as np

from ...kernels import ZERO_ORIGIN, Origin
from ..ground import UserError, garbage_collection_paused
from ..simulate import REFINEMENT_FACTOR, Batch, Task, max_leg_counts, row_layout, row_width
from ..study import HALF_SPACE, Study
from ..system import core_time
from .cost import COST_FACTOR
from .goal import FIRST_SHARE, whole_blocks
from .half_space import WORKER_BYTES, map_bytes
from .other_body import MAX_COST_SHARE, MODEL_LABEL, compared_label, study_of_other_body
from .variant import Variant, problems_of, variant_of

DRIVER_BYTES = 330e6  # interpreter and libraries of the process that plans and collects
BYTES_PER_STEP = 65  # per step of the longest programme
BYTES_PER_SAMPLE = 130  # line, state and temporaries at the peak
BYTES_PER_TASK = 2000  # memory of the plan
BYTES_PER_RECORD = 1  # many records share an entry of the index
BYTES_PER_POINT = 4500  # per grid point, for all estimates of the result
MOST_RECORDS = 20_000_000  # a run plans, indexes and collects them in minutes and 2 GiB
BYTES_PER_CURVE_SAMPLE = 80  # per sample of a curve and grid point


class Plan(NamedTuple):
    """Work and predicted cost of a study."""

    study: Study
    variants: list[Variant]
    first: dict[str, int]  # blocks of the first round, by task key; all blocks without a goal
    expected: dict[str, int]  # blocks that the goals are predicted to need, by task key
    other_body: Variant | None = None  # steady friction on the other body (other_body.py)
    no_other_body: str = ""  # the reason if it is not computed

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
        """Number of records (task, block) of the whole study, predicted if goals are set."""
        return sum(sum(map(self.expected.__getitem__, v.rows)) for v in self.variants)

    def longest_line(self) -> int:
        """Return the largest number of samples of any line."""
        return max(variant.longest for variant in self.variants)

    def widest_row(self, variant: Variant) -> int:
        """Return the largest number of values in a row of the store for a variant."""
        tasks = variant.tasks if variant.recording.requested else variant.tasks[:1]
        scheme, recording = variant.numerics.scheme, variant.recording
        return max(
            1, *(row_width(row_layout(t, variant.quantities, scheme, recording)) for t in tasks)
        )

    def predicted_worker_bytes(self) -> float:
        """Return the predicted peak memory of a worker."""
        steps = BYTES_PER_STEP * self.longest_programme()
        return WORKER_BYTES + max(map(_surface_bytes, self.variants)) + steps

    def longest_programme(self) -> float:
        """Return an upper bound of the steps of any programme; 0 without one."""
        marched = (
            max_leg_counts(task.problem, task.steps_per_spacing, variant.recording.origin).sum()
            for variant in self.variants
            if variant.recording.requested
            for task in variant.tasks
        )
        return float(max(marched, default=0.0))

    def predicted_driver_bytes(self) -> float:
        """Return the predicted peak memory of the process that plans, stores and collects."""
        tasks = sum(len(v.tasks) for v in self.variants)
        widest = max(self.widest_row(variant) for variant in self.variants)
        estimates = self.points * (BYTES_PER_POINT + BYTES_PER_CURVE_SAMPLE * widest)
        stored = tasks * BYTES_PER_TASK + self.records * BYTES_PER_RECORD
        return DRIVER_BYTES + stored + estimates + BYTES_PER_STEP * self.longest_programme()

    def predicted_seconds(self) -> float:
        """Return the predicted core-seconds of the whole study, within a factor of COST_FACTOR."""
        return sum(variant.total_seconds(self.expected) for variant in self.variants)

    def variant_of_batch(self, batch: Batch) -> Variant:
        """Return the variant that a batch belongs to."""
        return next(v for v in self.variants if batch.tasks[0].key in v.rows)

    def first_point(self, task: Task) -> dict[str, float]:
        """Return the first grid point of a task: axis -> value."""
        variant = next(v for v in self.variants if task in v.tasks)
        point = int(np.argmax(variant.point_task == variant.tasks.index(task)))
        index = np.unravel_index(point, variant.point_task.shape)
        return {
            axis: self.study.grid[axis][i] for axis, i in zip(self.study.axes, index, strict=True)
        }


def _surface_bytes(variant: Variant) -> float:
    """Return the peak memory of the longest line, or of the largest map, of a variant."""
    if variant.lines.body == HALF_SPACE:
        quantities = variant.study.scene.quantities
        return max(map_bytes(t.problem, t.steps_per_spacing, quantities) for t in variant.tasks)
    finer = REFINEMENT_FACTOR if variant.recording.refined_blocks else 1
    return finer * BYTES_PER_SAMPLE * variant.longest


def make_plan(study: Study, origin: Origin = ZERO_ORIGIN) -> Plan:
    """Return the plan of a study. Raises UserError for a problem that is too large.

    origin : start of a resumed programme.
    """
    with garbage_collection_paused():  # saves a fifth of the time with 1e5 tasks
        problems = problems_of(study)
        variants = [variant_of(study, label, problems[label], origin) for label in study.variants]
    plan = _with_other_body(Plan(study, variants, *_blocks_of(variants)))
    records = sum(plan.expected.values())
    if records > MOST_RECORDS:  # more than a run can index
        least = study.realizations_per_block * math.ceil(records / MOST_RECORDS)
        raise UserError(
            f"study.realizations_per_block = {study.realizations_per_block}: {records} records "
            f"(problem x block), more than {MOST_RECORDS}; set it to {least} or more"
        )
    return plan


def _blocks_of(variants: list[Variant]) -> tuple[dict[str, int], dict[str, int]]:
    """Return the blocks of the first round, and those expected, by task key."""
    first = {t.key: variant.study.blocks for variant in variants for t in variant.tasks}
    expected = dict(first)
    for variant in variants:
        most = variant.numerics.max_realizations
        needs = np.array([goal.realizations for goal in variant.goals.values()])
        for blocks, share in ((first, FIRST_SHARE), (expected, 1.0)):
            counts = whole_blocks(variant.study, share * needs, most).tolist()
            blocks.update(zip(variant.goals, counts, strict=True))
    return first, expected


def _with_other_body(plan: Plan) -> Plan:
    """Return the plan with a variant for the other body, or the reason why it has none.

    The variant is added if it is requested, or costs at most MAX_COST_SHARE of the study.
    """
    study = plan.study
    if label := compared_label(study):
        return plan._replace(other_body=next(v for v in plan.variants if v.label == label))
    try:
        other = study_of_other_body(study)
        if isinstance(other, str):
            return plan._replace(no_other_body=other)
        problems = problems_of(other)[MODEL_LABEL]
        variant = variant_of(other, MODEL_LABEL, problems, ZERO_ORIGIN)
    except UserError as error:  # the map or line is not possible
        return plan._replace(no_other_body=str(error))
    blocks = _blocks_of([variant])
    seconds = variant.total_seconds(blocks[1])
    costly = seconds > MAX_COST_SHARE * plan.predicted_seconds()
    if costly and "model_ratio" not in study.scene.quantities:
        cost = core_time(seconds / COST_FACTOR, seconds * COST_FACTOR)
        return plan._replace(no_other_body=f'the quantity "model_ratio" measures it in {cost}')
    first, expected = ({**ours, **more} for ours, more in zip(plan[2:4], blocks, strict=True))
    return plan._replace(
        variants=[*plan.variants, variant], first=first, expected=expected, other_body=variant
    )
