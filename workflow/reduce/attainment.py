"""Whether estimates have the accuracy that was asked for, and what they lack."""

from typing import NamedTuple

import numpy as np

from ..plan import Goal, allowed
from ..simulate import Task
from ..study import Numerics
from .blocks import Estimates
from .fits import NEGLIGIBLE, NO_RELAXATION, NOT_EXPONENTIAL, NOT_FINITE
from .resolution import resolution

MISSED, MET, MET_WHERE_DEFINED = 0, 1, 2
FEW_GROUPS = 8  # of the jackknife, below which a law has a say in what is met
ENOUGH_GROUPS = 16  # from which on a mean curve that is no exponential is believed
TRUST = 3.0  # degrees of freedom: the law of scatter is right within 1.7 for two in three
ACCURACY_MEANINGS = "missed met met_where_defined"


class Attained(NamedTuple):
    """The accuracy of some tasks; arrays of shape (tasks,)."""

    reached: np.ndarray  # relative standard error plus bias, the worst estimate; inf: unknown
    status: np.ndarray  # int8, see ACCURACY_MEANINGS
    growth: np.ndarray  # factor by which realizations must grow; inf: unknown


def with_found_bias(
    goals: list[Goal], tasks: list[Task], estimates: Estimates, numerics: Numerics
) -> list[Goal]:
    """Return the goals of some tasks with the bias that was found, where that is the larger.

    A number of steps given by the user stands, and its error is not counted.
    """
    names = tuple(goals[0].bias)
    if numerics.steps_per_spacing is not None:
        return goals
    found = resolution(tasks, estimates, names, numerics)
    return [
        goal._replace(bias={n: np.fmax(goal.bias[n], found[f"{n}_bias"][row]) for n in names})
        for row, goal in enumerate(goals)
    ]


def attained(
    estimates: Estimates,
    goals: list[Goal],
    ratios: np.ndarray,
    wanted: float,
    realizations: np.ndarray,
) -> Attained:
    """Judge the estimates of some tasks.

    Where a value has no relative error (next to nothing relaxes, not exponential, exactly zero) it
    is left out, and the status says so; reached is NaN where that leaves nothing. By chance two
    groups agree too well one time in ten, so that the law of scatter counts there as TRUST degrees
    of freedom (G. K. Smyth, Stat. Appl. Genet. Mol. Biol. 3, 3 (2004), doi:10.2202/1544-6115.1027).
    estimates : with ``degrees_of_freedom`` of the errors. ratios : v2/v1, realizations : of each
    task, both of shape (tasks,).
    """
    freedom = estimates["degrees_of_freedom"]
    reached = np.full(len(goals), -np.inf)
    growth = np.zeros(len(goals))
    partly = np.zeros(len(goals), bool)
    for name in goals[0].bias:
        bias = np.array([goal.bias[name] for goal in goals])
        left = np.array([allowed(wanted, each) for each in bias])
        with np.errstate(all="ignore"):
            relative = estimates[f"{name}_error"] / np.abs(estimates[name])
        relative[~np.isfinite(relative)] = np.inf
        law = np.array([goal.scatter[name] for goal in goals]) / np.sqrt(realizations)
        # Errors of few groups are a mean with what the law of their scatter says.
        both = np.sqrt((TRUST * law**2 + freedom * relative**2) / (TRUST + freedom))
        moderated = np.where(freedom + 1 < FEW_GROUPS, both, relative)
        relative = np.maximum(relative, moderated)
        undefined = (relative > left) & _undefined(name, estimates, ratios, wanted)
        partly |= undefined
        reached = np.maximum(reached, np.where(undefined, -np.inf, relative + bias))
        short = np.maximum(moderated / left, 1.0 + 1e-9)
        lacking = np.where(relative > left, short, relative / left)
        growth = np.maximum(growth, np.where(undefined, 0.0, lacking**2))
    if "fit_status" in estimates:
        growth[estimates["fit_status"] == NOT_FINITE] = 0.0  # no number of lines mends that
    missed = reached > wanted * (1.0 + 1e-9)
    status = np.where(missed, MISSED, np.where(partly, MET_WHERE_DEFINED, MET))
    return Attained(np.where(reached < 0.0, np.nan, reached), status.astype(np.int8), growth)


def _undefined(name: str, estimates: Estimates, ratios: np.ndarray, wanted: float) -> np.ndarray:
    """Return where an estimate has no relative error that more realizations could lessen."""
    if name != "relaxation_rate":
        return (estimates[name] == 0.0) & (estimates[f"{name}_error"] == 0.0)
    status = estimates["fit_status"]
    first = np.abs(estimates["deviation"][:, 1])
    error = estimates["deviation_error"][:, 1]
    change = np.abs(estimates["mu"][:, 0] * (ratios - 1.0))  # of a viscous force, for scale
    nothing = (status == NO_RELAXATION) & (first + 2.0 * error <= wanted * change)
    # A mean over few groups may look like no exponential by chance.
    shaped = (status == NOT_EXPONENTIAL) & (estimates["degrees_of_freedom"] + 1 >= ENOUGH_GROUPS)
    return nothing | shaped | (status == NEGLIGIBLE)
