"""Accuracy reached by estimates, and the number of further realizations."""

from typing import NamedTuple

import numpy as np

from ..plan import Goal, allowed
from ..simulate import Task
from ..study import Numerics
from .blocks import Estimates
from .fits import NEGLIGIBLE, NO_RELAXATION, NOT_EXPONENTIAL, NOT_FINITE
from .resolution import resolution

MISSED, MET, MET_WHERE_DEFINED = 0, 1, 2
MODERATED_GROUPS = 8  # of the jackknife; with fewer, errors are averaged with the scatter law
MIN_SHAPE_GROUPS = 16  # of the jackknife, to accept that a mean curve is not exponential
SCATTER_FREEDOM = 3.0  # degrees of freedom: two in three scatters are within 1.7 of the law
ACCURACY_MEANINGS = "missed met met_where_defined"


class Attained(NamedTuple):
    """Accuracy of tasks; arrays of shape (tasks,)."""

    reached: np.ndarray  # relative standard error plus bias of the worst estimate; inf: unknown
    status: np.ndarray  # int8, see ACCURACY_MEANINGS
    growth: np.ndarray  # factor by which realizations must grow; inf: unknown


def with_measured_bias(
    goals: list[Goal], tasks: list[Task], estimates: Estimates, numerics: Numerics
) -> list[Goal]:
    """Return the goals of tasks with the larger of the predicted and the measured bias.

    If the user gives the number of steps, the bias does not count and no goal changes.
    """
    names = tuple(goals[0].bias)
    if numerics.steps_per_spacing is not None:
        return goals
    measured = resolution(tasks, estimates, names, numerics)
    return [
        goal._replace(bias={n: np.fmax(goal.bias[n], measured[f"{n}_bias"][row]) for n in names})
        for row, goal in enumerate(goals)
    ]


def attained(
    estimates: Estimates,
    goals: list[Goal],
    ratios: np.ndarray,
    wanted: float,
    realizations: np.ndarray,
) -> Attained:
    """Return the accuracy reached by the estimates of tasks.

    Values without a relative error (negligible relaxation, not exponential, exactly zero) are left
    out, and the status says so; ``reached`` is NaN if no value remains. Few groups may agree too
    well by chance (two groups: in one of ten cases). Their variance is therefore averaged with that
    of the scatter law, which counts as SCATTER_FREEDOM degrees of freedom (G. K. Smyth, Stat. Appl.
    Genet. Mol. Biol. 3, 3 (2004), doi:10.2202/1544-6115.1027).
    estimates : with the ``degrees_of_freedom`` of the errors. wanted : relative accuracy. ratios :
    v2/v1, shape (tasks,). realizations : of each task, shape (tasks,).
    """
    freedom = estimates["degrees_of_freedom"]
    reached = np.full(len(goals), -np.inf)
    growth = np.zeros(len(goals))
    partly = np.zeros(len(goals), bool)
    for name in goals[0].bias:
        bias = np.array([goal.bias[name] for goal in goals])
        permitted = np.array([allowed(wanted, value) for value in bias])
        with np.errstate(all="ignore"):
            relative = estimates[f"{name}_error"] / np.abs(estimates[name])
        relative[~np.isfinite(relative)] = np.inf
        law = np.array([goal.scatter[name] for goal in goals]) / np.sqrt(realizations)
        averaged = np.sqrt(
            (SCATTER_FREEDOM * law**2 + freedom * relative**2) / (SCATTER_FREEDOM + freedom)
        )
        moderated = np.where(freedom + 1 < MODERATED_GROUPS, averaged, relative)
        relative = np.maximum(relative, moderated)
        undefined = (relative > permitted) & _undefined(name, estimates, ratios, wanted)
        partly |= undefined
        reached = np.maximum(reached, np.where(undefined, -np.inf, relative + bias))
        short = np.maximum(moderated / permitted, 1.0 + 1e-9)
        lacking = np.where(relative > permitted, short, relative / permitted)
        growth = np.maximum(growth, np.where(undefined, 0.0, lacking**2))
    if "fit_status" in estimates:
        growth[estimates["fit_status"] == NOT_FINITE] = 0.0  # more lines do not help
    missed = reached > wanted * (1.0 + 1e-9)
    status = np.where(missed, MISSED, np.where(partly, MET_WHERE_DEFINED, MET))
    return Attained(np.where(reached < 0.0, np.nan, reached), status.astype(np.int8), growth)


def _undefined(name: str, estimates: Estimates, ratios: np.ndarray, wanted: float) -> np.ndarray:
    """Return the mask of estimates for which more realizations do not help."""
    if name != "relaxation_rate":
        return (estimates[name] == 0.0) & (estimates[f"{name}_error"] == 0.0)
    status = estimates["fit_status"]
    first = np.abs(estimates["deviation"][:, 1])
    error = estimates["deviation_error"][:, 1]
    change = np.abs(estimates["mu"][:, 0] * (ratios - 1.0))  # scale: change of a viscous force
    nothing = (status == NO_RELAXATION) & (first + 2.0 * error <= wanted * change)
    # A mean over few groups may deviate from an exponential by chance.
    shaped = (status == NOT_EXPONENTIAL) & (estimates["degrees_of_freedom"] + 1 >= MIN_SHAPE_GROUPS)
    return nothing | shaped | (status == NEGLIGIBLE)
