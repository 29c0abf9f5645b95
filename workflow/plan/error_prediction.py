"""Bounds of the discretisation error, and predicted errors of a run, by the laws of both bodies."""

import math
from typing import NamedTuple

import numpy as np

from ..simulate import Problem
from ..study import HALF_SPACE, Numerics, accuracy_estimates
from .error_laws import (
    LAWS,
    contact_width,
    first_order_rate_error,
    known,
    rate_error,
    stepped_error,
)
from .goal import FIRST_ORDER
from .half_space import equivalent_steps, euler_map_error, expected_samples, laws_of, map_error
from .plan import Plan
from .problems import expected_rate

MAX_PROBLEMS = 300  # problems with predictions, at equal intervals


def discretisation_error(
    name: str, problem: Problem, steps: int, numerics: Numerics, samples: float, rate: float
) -> float:
    """Return an upper bound of the relative discretisation error; NaN where no law is known.

    samples : per contact. rate : b. A second-order step counts as FIRST_ORDER first-order steps,
    unless friction is that of the steps (stepped_error).
    """
    first_order = numerics.scheme == "implicit-euler"
    if problem.surface.body == HALF_SPACE:
        same = equivalent_steps(problem, steps)
        error = math.nan if problem.programme else map_error(name, same, samples)
        return np.hypot(error, euler_map_error(name, steps)) if first_order else error
    if not known(problem):
        return math.nan
    if name == "relaxation_rate":
        error = rate_error(problem, steps, samples, rate)
        return error + first_order_rate_error(problem, steps, rate) if first_order else error
    if first_order and not numerics.refines:
        return stepped_error(steps)
    equivalent = steps / FIRST_ORDER if first_order else steps
    return LAWS[name].error(problem, equivalent, refine=numerics.refines)


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
    for name in accuracy_estimates(plan.study.scene.quantities) if tasks else ():
        if name not in laws_of(tasks[0].problem):
            continue
        chance, bound = np.empty(len(tasks)), np.full(len(tasks), np.nan)
        for row, task in enumerate(tasks):
            problem, steps = task.problem, task.steps_per_spacing
            lines = plan.expected[task.key] * variant.block_size
            chance[row] = laws_of(problem)[name].scatter(problem) / math.sqrt(lines)
            if name != "relaxation_rate" or variant.numerics.scheme == "exponential":
                samples = contact_width(problem) * steps
                if problem.surface.body == HALF_SPACE:
                    samples = expected_samples(problem, equivalent_steps(problem, steps))
                expected = samples, expected_rate(problem)
                bound[row] = discretisation_error(name, problem, steps, variant.numerics, *expected)
        errors[name] = PredictedErrors(chance, bound)
    return errors
