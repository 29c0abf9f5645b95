"""The errors that a run is expected to have, before anything is computed, by the laws of error."""

import math
from typing import NamedTuple

import numpy as np

from ..study import accuracy_estimates
from .error_laws import known
from .goal import FIRST_ORDER
from .half_space import laws_of
from .plan import Plan

LOOKED_AT = 300  # problems, spread over all of them


class ExpectedErrors(NamedTuple):
    """Relative errors of one estimate at each problem that was looked at, shape (P,)."""

    chance: np.ndarray  # standard error
    discretisation: np.ndarray  # bound


def expected_errors(plan: Plan) -> dict[str, ExpectedErrors]:
    """Return the errors of the estimates of a study at problems for which the laws hold.

    Empty where the laws hold for none: they are known of Kelvin bodies on random surfaces. For b of
    the first-order scheme no bound is known before a run.
    """
    variant = plan.variants[0]
    every = variant.tasks[:: math.ceil(len(variant.tasks) / LOOKED_AT)]
    tasks = [task for task in every if known(task.problem, task.problem.surface.body)]
    found: dict[str, ExpectedErrors] = {}
    if not tasks:
        return found
    refines = variant.numerics.refines
    first_order = variant.numerics.scheme == "implicit-euler"
    for name in accuracy_estimates(plan.study.scene.quantities):
        if name not in laws_of(tasks[0].problem):
            continue
        chance, bound = np.empty(len(tasks)), np.full(len(tasks), np.nan)
        for row, task in enumerate(tasks):
            laws = laws_of(task.problem)
            lines = plan.expected[task.key] * plan.study.realizations_per_block
            worth = task.steps_per_spacing / (FIRST_ORDER if first_order else 1)
            chance[row] = laws[name].scatter(task.problem) / math.sqrt(lines)
            if not (first_order and name == "relaxation_rate"):
                bound[row] = laws[name].error(task.problem, worth, refines)
        found[name] = ExpectedErrors(chance, bound)
    return found
