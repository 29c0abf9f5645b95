"""Predicted errors of the estimates of a run, by the laws of error."""

import math
from typing import NamedTuple

import numpy as np

from ..study import FOUNDATION, accuracy_estimates
from .error_laws import known, stepped_error
from .goal import FIRST_ORDER
from .half_space import euler_map_error, laws_of
from .plan import Plan

MAX_PROBLEMS = 300  # problems with predictions, at equal intervals


class PredictedErrors(NamedTuple):
    """Relative errors of one estimate at some problems, shape (P,)."""

    chance: np.ndarray  # standard error
    discretisation: np.ndarray  # upper bound; NaN where no law is known


def predicted_errors(plan: Plan) -> dict[str, PredictedErrors]:
    """Return the errors of each estimate of a study, at problems for which the laws hold.

    The laws hold for Kelvin bodies on random surfaces. The result is empty without such a problem.
    For b by the first-order scheme no bound is known before a run.
    """
    variant = plan.variants[0]
    chosen = variant.tasks[:: math.ceil(len(variant.tasks) / MAX_PROBLEMS)]
    tasks = [task for task in chosen if known(task.problem, task.problem.surface.body)]
    errors: dict[str, PredictedErrors] = {}
    if not tasks:
        return errors
    refines = variant.numerics.refines
    first_order = variant.numerics.scheme == "implicit-euler"
    laws = laws_of(tasks[0].problem)
    for name in accuracy_estimates(plan.study.scene.quantities):
        if name not in laws:
            continue
        chance, bound = np.empty(len(tasks)), np.full(len(tasks), np.nan)
        for row, task in enumerate(tasks):
            lines = plan.expected[task.key] * variant.block_size
            equivalent_steps = task.steps_per_spacing / (FIRST_ORDER if first_order else 1)
            chance[row] = laws[name].scatter(task.problem) / math.sqrt(lines)
            if not (first_order and name == "relaxation_rate"):
                bound[row] = laws[name].error(task.problem, equivalent_steps, refines)
                if first_order and task.problem.surface.body != FOUNDATION:
                    bound[row] = euler_map_error(name, task.steps_per_spacing)
                elif first_order and not refines:
                    bound[row] = stepped_error(task.steps_per_spacing)
        errors[name] = PredictedErrors(chance, bound)
    return errors
