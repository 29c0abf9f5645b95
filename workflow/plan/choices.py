"""Time, memory and discretisation error of a half-space at three numbers of steps per spacing."""

from dataclasses import replace
from typing import NamedTuple

from ..study import HALF_SPACE
from .half_space import MAX_MAP_SAMPLES, STEPS_OF_MAPS, largest_error
from .plan import Plan, make_plan


class MapChoice(NamedTuple):
    """Predictions for a study with one number of steps per spacing."""

    steps_per_spacing: int
    predicted_core_seconds: float
    predicted_worker_bytes: int
    bias_bound: float  # largest relative discretisation error of the requested quantities
    chosen: bool


def map_choices(plan: Plan) -> list[MapChoice]:
    """Return predictions for the planned number of steps and its neighbours.

    The result is empty for a foundation, and if a requested accuracy chooses the steps.
    """
    study, ours = plan.study, plan.variants[0]
    if ours.lines.body != HALF_SPACE or ours.goals:
        return []
    problems = [task.problem for task in ours.tasks]
    chosen = max(task.steps_per_spacing for task in ours.tasks)
    fitting = (
        m
        for m in {*STEPS_OF_MAPS, chosen}
        if max(problem.samples(m) for problem in problems) <= MAX_MAP_SAMPLES
    )
    candidates = sorted(fitting)
    first = max(min(candidates.index(chosen) - 1, len(candidates) - 3), 0)
    choices = []
    for steps in candidates[first : first + 3]:
        numerics = ours.numerics._replace(steps_per_spacing=steps)
        other = make_plan(replace(study, variants=study.variants | {ours.label: numerics}))
        choices.append(
            MapChoice(
                steps,
                other.predicted_seconds(),
                round(other.predicted_worker_bytes()),
                max(float(largest_error(p, study.scene.quantities, steps)) for p in problems),
                steps == chosen,
            )
        )
    return choices
