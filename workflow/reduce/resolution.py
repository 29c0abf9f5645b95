"""Resolution of contacts, and upper bounds of the discretisation error."""

import numpy as np

from ...kernels import ZERO_ORIGIN, Origin
from ...kernels.drive import SLIPS
from ...kernels.motion.legs import speed_at_start
from ..plan import (
    BIAS,
    FIRST_ORDER,
    discretisation_error,
    equivalent_steps,
    map_error,
    remembered_share,
    shape_error,
    stepped_error,
)
from ..simulate import Task
from ..study import HALF_SPACE, Numerics
from .blocks import Estimates

UNRESOLVED, COARSE, RESOLVED = 0, 1, 2
RESOLUTION_MEANINGS = "unresolved coarse resolved"
RESOLVED_SAMPLES = 4.0  # smallest number of samples across a resolved contact
UNRESOLVED_SAMPLES = 1.0  # largest number of samples across an unresolved contact
MAP_BIAS = 0.05  # largest relative bias of any stated estimate at a resolved point of a half-space
RESOLUTION_COMMENT: str = (
    f"resolved: samples_per_contact is {RESOLVED_SAMPLES:g} or more, and bias_bound at most "
    f"{BIAS:g} for measured lines and {MAP_BIAS:g} for maps; coarse: above "
    f"{UNRESOLVED_SAMPLES:g} sample; unresolved: contacts are no wider than a sample, so that "
    "points touch singly"
)
NARROW_CONTACTS = f"contacts of fewer than {RESOLVED_SAMPLES:g} samples"
LARGE_BIAS = (
    f"a discretisation error above {100.0 * BIAS:g} % ({100.0 * MAP_BIAS:g} % on a half-space)"
)
MAX_SENSITIVITY = 4.0  # relative change of a quantity of a drive over that of the heights
MAX_RELATIVE_BIAS = 1.0  # larger values are clipped, as they only mean a large error


def resolution_status(
    samples: np.ndarray, bias: np.ndarray | float = 0.0, max_bias: float = BIAS
) -> np.ndarray:
    """Return the status of each point from its samples per contact, int8; -1 where NaN.

    bias : relative upper bound; zero or NaN if unknown. max_bias : of a resolved point.
    """
    fine = np.logical_not(bias > max_bias)
    status = np.where((samples >= RESOLVED_SAMPLES) & fine, RESOLVED, COARSE)
    status = np.where(samples <= UNRESOLVED_SAMPLES, UNRESOLVED, status)
    return np.where(np.isnan(samples), -1, status).astype(np.int8)


def resolution(
    tasks: list[Task], estimates: dict[str, np.ndarray], names: tuple[str, ...], numerics: Numerics
) -> dict[str, np.ndarray]:
    """Return the resolution_status of tasks, and NAME_bias of their estimates.

    A bias is an upper bound of the relative discretisation error; bias_bound is the largest. It
    follows from the laws of error in plan, with the measured samples per contact and rate b instead
    of predicted ones.
    """
    biases: dict[str, np.ndarray] = {}
    if not names:  # no steady quantity
        return biases
    samples = estimates["samples_per_contact"]
    rates = np.nan_to_num(estimates.get("relaxation_rate", np.zeros(len(tasks))))
    for name in names:
        if f"{name}_bias" in estimates:  # measured, for lines without an error law
            biases[f"{name}_bias"] = np.minimum(estimates[f"{name}_bias"], MAX_RELATIVE_BIAS)
            continue
        errors = [
            discretisation_error(name, t.problem, t.steps_per_spacing, numerics, width, rate)
            for t, width, rate in zip(tasks, samples, rates, strict=True)
        ]
        bias = np.array(errors) * _excess_of_parts(estimates, name)
        biases[f"{name}_bias"] = np.minimum(bias, MAX_RELATIVE_BIAS)
    biases["bias_bound"] = np.fmax.reduce(list(biases.values()))
    # On maps and on lines without an error law, the width of contacts does not bound the error.
    lawless = any(f"{name}_bias" in estimates for name in names)
    bounded = lawless or _on_maps(tasks)
    biases["resolution_status"] = resolution_status(
        samples, biases["bias_bound"] if bounded else 0.0, _max_bias(tasks)
    )
    return biases


def _excess_of_parts(estimates: Estimates, name: str) -> np.ndarray | float:
    """Return the sum of the |parts| of an estimate over its |total|; 1 without shear.

    The law of the viscoelastic part bounds the error of the contact area too. No law bounds a
    rate b that is fitted to a sum (NaN): at m = 2 and 4 its error was 2 to 3 times that bound.
    """
    parts = [estimates.get(f"{name}_{part}") for part in ("viscoelastic", "shear")]
    if name == "relaxation_rate" and "mu_shear" in estimates:
        return np.nan
    if parts[0] is None or parts[1] is None:
        return 1.0
    with np.errstate(all="ignore"):
        return (np.abs(parts[0]) + np.abs(parts[1])) / np.abs(estimates[name])


def _on_maps(tasks: list[Task]) -> bool:
    """Return whether tasks are those of a half-space (all share one body)."""
    return bool(tasks) and tasks[0].problem.surface.body == HALF_SPACE


def _max_bias(tasks: list[Task]) -> float:
    """Return the largest bias of a resolved point."""
    return MAP_BIAS if _on_maps(tasks) else BIAS


def trace_resolution(
    tasks: list[Task], estimates: Estimates, numerics: Numerics, origin: Origin
) -> Estimates:
    """Return the trace_resolution_status of tasks, trace_mu_bias and trace_remembered.

    The status follows from the smallest number of samples per contact during contact, and from the
    bias. The bias adds two errors in quadrature: the shape error (for lines without an error law,
    the bias of mu_1), and the difference between the first marched mu and mu_1, which is more
    accurate (branches/memory_friction.py, quick/contacts). It is NaN unless the trace starts with
    steady sliding at v1 and mu_1 is known. origin : start of the programme.
    """
    samples, first = estimates["trace_samples_per_contact"], estimates["trace_mu"][:, 0]
    fewest = np.min(samples, axis=1, where=samples > 0.0, initial=np.inf)
    bias, start = np.empty(len(tasks)), np.full(len(tasks), np.nan)
    for row, task in enumerate(tasks):
        problem, steps = task.problem, task.steps_per_spacing
        equivalent = steps / FIRST_ORDER if numerics.scheme == "implicit-euler" else steps
        on_map = problem.surface.body == HALF_SPACE
        bias[row] = (
            map_error("mu_1", equivalent_steps(problem, equivalent), np.nan)
            if on_map
            else shape_error(equivalent)
        )
        if numerics.scheme == "implicit-euler" and not (numerics.refines or on_map):
            bias[row] = np.hypot(bias[row], stepped_error(steps))
        steady = problem.start == "steady" and origin == ZERO_ORIGIN and "mu_1" in estimates
        if steady and speed_at_start(problem.programme) == problem.ends[0]:
            start[row] = abs(first[row] / estimates["mu_1"][row] - 1.0)
    # Error laws do not cover programmes; lines without a law have a bias from halved steps.
    measured = estimates.get("mu_1_bias", np.nan)
    bias = np.where(np.isnan(measured), bias, measured)
    total = np.minimum(np.hypot(bias, start), MAX_RELATIVE_BIAS)
    smallest = np.where(np.isinf(fewest), 0.0, fewest)
    status = resolution_status(smallest, np.fmax(total, bias), _max_bias(tasks))
    remembered = np.array([remembered_share(task.problem) for task in tasks])
    return {
        "trace_mu_bias": total,
        "trace_resolution_status": status,
        "trace_remembered": remembered,
    }


def slip_resolution(tasks: list[Task], estimates: Estimates, changes: np.ndarray) -> Estimates:
    """Return the slip_resolution_status of tasks, their trace status, and the biases of SLIPS.

    changes : of SLIPS under heights that differ by the shape error of the steps, relative, shape
    (tasks, len(SLIPS)). A change far above that of the heights means that the slider stops in
    another valley; the drive is then unresolved even if its contacts are resolved. Without a mass
    the peak velocity is ignored, as only a mass limits it.
    """
    heights = shape_error([task.steps_per_spacing for task in tasks])
    massive = np.array(
        [task.problem.drive is not None and task.problem.drive.mass > 0.0 for task in tasks]
    )
    counts = massive[:, None] | (np.array(SLIPS) != "peak_velocity")
    largest = np.max(changes, axis=1, where=counts, initial=0.0)
    status = np.where(largest > _max_bias(tasks), COARSE, RESOLVED)
    far = (status == COARSE) & (largest > MAX_SENSITIVITY * heights)
    status = np.where(far, UNRESOLVED, status).astype(np.int8)
    biases = {f"{name}_bias": changes[:, k] for k, name in enumerate(SLIPS) if name in estimates}
    if "trace_resolution_status" in estimates:
        trace = estimates["trace_resolution_status"]
        biases["trace_resolution_status"] = np.where(far, np.minimum(trace, status), trace)
    return biases | {"slip_resolution_status": status}
