"""Whether contacts are resolved, and how large the discretisation error is at most."""

import numpy as np

from ...kernels import ZERO_ORIGIN, Origin
from ...kernels.motion.legs import speed_at_start
from ..plan import (
    BIAS,
    FIRST_ORDER,
    LAWS,
    first_order_rate_error,
    known,
    map_error,
    rate_error,
    shape_error,
)
from ..simulate import Task
from ..study import HALF_SPACE, Numerics
from .blocks import Estimates

UNRESOLVED, COARSE, RESOLVED = 0, 1, 2
RESOLUTION_MEANINGS = "unresolved coarse resolved"
ENOUGH = 4.0  # samples per contact, with which it is resolved
TOO_FEW = 1.0  # with which it is not
RESOLUTION_COMMENT: str = (
    f"resolved: samples_per_contact is {ENOUGH:g} or more, and of measured lines bias_bound at "
    f"most {BIAS:g}; coarse: above {TOO_FEW:g}; unresolved: contacts are no wider than a sample, "
    "so that points touch one by one"
)
NARROW = f"contacts of fewer than {ENOUGH:g} samples"
OFF = f"a discretisation error above {100.0 * BIAS:g} %"
WHOLE = 1.0  # a bias beyond its own value says no more


def resolution_status(samples: np.ndarray, bias: np.ndarray | float = 0.0) -> np.ndarray:
    """Return the status of each point from its samples per contact, int8; -1 where NaN.

    bias : relative bound, as far as it is known; otherwise zero, or NaN.
    """
    status = np.where((samples >= ENOUGH) & np.logical_not(bias > BIAS), RESOLVED, COARSE)
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
        if f"{name}_bias" in estimates:  # of lines without a law
            found[f"{name}_bias"] = np.minimum(estimates[f"{name}_bias"], WHOLE)
            continue
        bias = np.empty(len(tasks))
        for row, task in enumerate(tasks):
            problem, steps = task.problem, task.steps_per_spacing
            if problem.surface.body == HALF_SPACE:
                bias[row] = np.nan if problem.programme else map_error(name, steps, samples[row])
                continue
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
    found["bias_bound"] = np.fmax.reduce(list(found.values()))
    lawless = any(f"{name}_bias" in estimates for name in names)
    # There the width of contacts alone does not say how far off they are.
    found["resolution_status"] = resolution_status(samples, found["bias_bound"] if lawless else 0.0)
    return found


def trace_resolution(
    tasks: list[Task], estimates: Estimates, numerics: Numerics, origin: Origin
) -> Estimates:
    """Return the trace_resolution_status of some tasks, and trace_mu_bias.

    samples per contact : the fewest at which anything touches. The bias is that of the shape, or of
    mu_1 of lines without a law, together with what the march itself has at the start instead of
    mu_1, which is found by better means (branches/dissipation.py, quick/contacts). It is NaN where
    the trace does not start with steady sliding at v1, or that was not asked for.
    origin : where the programme begins.
    """
    samples, first = estimates["trace_samples_per_contact"], estimates["trace_mu"][:, 0]
    fewest = np.min(samples, axis=1, where=samples > 0.0, initial=np.inf)
    own, start = np.empty(len(tasks)), np.full(len(tasks), np.nan)
    for row, task in enumerate(tasks):
        problem, steps = task.problem, task.steps_per_spacing
        worth = steps / FIRST_ORDER if numerics.scheme == "implicit-euler" else steps
        half_space = problem.surface.body == HALF_SPACE
        own[row] = map_error("mu_1", worth, np.nan) if half_space else shape_error(worth)
        steady = problem.start == "steady" and origin == ZERO_ORIGIN and "mu_1" in estimates
        if steady and speed_at_start(problem.programme) == problem.ends[0]:
            start[row] = abs(first[row] / estimates["mu_1"][row] - 1.0)
    measured = estimates.get("mu_1_bias", np.nan)  # by halved steps, as no law knows programmes
    own = np.where(np.isnan(measured), own, measured)
    bias = np.minimum(np.hypot(own, start), WHOLE)
    least = np.where(np.isinf(fewest), 0.0, fewest)
    status = resolution_status(least, np.fmax(bias, own))
    return {"trace_mu_bias": bias, "trace_resolution_status": status}
