"""Error of the model: mu_1 of the foundation over mu_1 of the half-space at every task.

If the other body is not computed, Persson's theory gives an order of magnitude. Its friction is
MIN_THEORY to MAX_THEORY of that of a half-space (docs/bodies.md).
"""

import math

import numpy as np

from ..plan import Plan, equivalent_steps, map_error
from ..study import FOUNDATION, HALF_SPACE
from .blocks import Estimates
from .persson_estimates import persson_values

MIN_THEORY, MAX_THEORY = 0.3, 0.94  # friction of Persson's theory over that of the half-space
MAX_THEORY_TASKS = 2000  # a task takes about a millisecond


def model_ratios(plan: Plan, estimates: Estimates, other: Estimates | None) -> Estimates:
    """Return model_ratio and its error at all tasks of a study; empty if nothing is known.

    estimates, other : over all tasks of the study and of ``plan.other_body``, which may be None.
    """
    if other is not None:
        return _measured(plan, estimates, other)
    if not theory_applies(plan):
        return {}
    ours = plan.variants[0]
    theory = estimates
    if "mu_persson" not in estimates:
        theory = persson_values(ours.tasks, ours.lines, ours.study.grid["roughness"][0])
    return _theoretical(estimates["mu_1"], theory["mu_persson"])


def theory_applies(plan: Plan) -> bool:
    """Return whether Persson's theory gives the order of magnitude of model_ratio."""
    ours = plan.variants[0]
    return ours.lines.body == FOUNDATION and len(ours.tasks) <= MAX_THEORY_TASKS


def _measured(plan: Plan, estimates: Estimates, other: Estimates) -> Estimates:
    """Return model_ratio, its error and the realizations of the other body.

    The error includes the bound of the discretisation error of the half-space.
    """
    ours, theirs = plan.variants[0], plan.other_body
    assert theirs is not None
    _, points = np.unique(ours.point_task.ravel(), return_index=True)  # the first of each task
    rows = theirs.point_task.ravel()[points]
    ratio = np.ones(rows.size)
    squares = np.zeros(rows.size)
    for variant, values in ((ours, estimates), (theirs, {n: v[rows] for n, v in other.items()})):
        profile = variant.lines.profile
        height = 1.0 if profile is None else profile.roughness  # unit of heights on either body
        power = 1.0 if variant.lines.body == FOUNDATION else -1.0
        # Both bodies have a viscoelastic part.
        name = "mu_1_viscoelastic" if "mu_1_viscoelastic" in values else "mu_1"
        with np.errstate(all="ignore"):
            ratio *= (values[name] * height) ** power
            squares += (values[f"{name}_error"] / values[name]) ** 2
        if variant.lines.body == HALF_SPACE:
            steps = [equivalent_steps(t.problem, t.steps_per_spacing) for t in variant.tasks]
            bias = map_error("mu_1", np.array(steps), np.nan)
            squares += (bias if variant is ours else bias[rows]) ** 2
    return {
        "model_ratio": ratio,
        "model_ratio_error": np.abs(ratio) * np.sqrt(squares),
        "model_realizations": other["realizations"][rows],
    }


def _theoretical(mu_1: np.ndarray, mu_persson: np.ndarray) -> Estimates:
    """Return model_ratio of a foundation by Persson's theory, and half of its range as error."""
    with np.errstate(all="ignore"):
        ratio = mu_1 / mu_persson
    middle = math.sqrt(MIN_THEORY * MAX_THEORY)
    return {
        "model_ratio": middle * ratio,
        "model_ratio_error": 0.5 * (MAX_THEORY - MIN_THEORY) * np.abs(ratio),
    }
