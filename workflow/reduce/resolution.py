"""How far results are those of the limit of fine samples: contacts resolved, bias expected."""

import numpy as np

from ..plan import FIRST_ORDER, LAWS, first_order_rate_error, known, rate_error
from ..simulate import Task
from ..study import Numerics

UNRESOLVED, COARSE, RESOLVED = 0, 1, 2
RESOLUTION_MEANINGS = "unresolved coarse resolved"
RESOLUTION_COMMENT = (
    "resolved: samples_per_contact is 4 or more; coarse: above 1; unresolved: contacts are no "
    "wider than a sample, so that points touch one by one"
)
ENOUGH, TOO_FEW = 4.0, 1.0  # samples per contact
WHOLE = 1.0  # a bias beyond its own value says no more


def resolution_status(samples: np.ndarray) -> np.ndarray:
    """Return the status of each point from its samples per contact, int8; -1 where NaN."""
    status = np.where(samples >= ENOUGH, RESOLVED, COARSE)
    status = np.where(samples <= TOO_FEW, UNRESOLVED, status)
    return np.where(np.isnan(samples), -1, status).astype(np.int8)


def resolution(
    tasks: list[Task], estimates: dict[str, np.ndarray], names: tuple[str, ...], numerics: Numerics
) -> dict[str, np.ndarray]:
    """Return the resolution_status of some tasks, and NAME_bias of some of their estimates.

    A bias is a bound of the relative discretisation error; bias_bound is the largest. By the laws
    of plan/error_laws.py, with the samples per contact and the rate b that were found in place of
    those expected. Of a first order scheme FIRST_ORDER steps are worth one.
    """
    found: dict[str, np.ndarray] = {}
    if not names:  # nothing steady: a programme alone
        return found
    samples = estimates["samples_per_contact"]
    rates = np.nan_to_num(estimates.get("relaxation_rate", np.zeros(len(tasks))))
    first_order = numerics.scheme == "implicit-euler"
    for name in names:
        bias = np.empty(len(tasks))
        for row, task in enumerate(tasks):
            problem, steps = task.problem, task.steps_per_spacing
            if not known(problem):
                bias[row] = np.nan
                continue
            if name != "relaxation_rate":
                worth = steps / FIRST_ORDER if first_order else steps
                bias[row] = LAWS[name].error(problem, worth, numerics.refines)
                continue
            bias[row] = rate_error(problem, steps, samples[row], rates[row])
            if first_order:
                bias[row] += first_order_rate_error(problem, steps, rates[row])
        found[f"{name}_bias"] = np.minimum(bias, WHOLE)
    found["bias_bound"] = np.max(list(found.values()), axis=0)
    found["resolution_status"] = resolution_status(samples)
    return found
