"""Completion of the estimates of a variant: resolution, model ratios, exponents of eq. 13."""

from typing import NamedTuple

import numpy as np

from ...kernels import MOTION_TRACES
from ..plan import Plan, Variant, line_slope, speed_ratio
from ..study import accuracy_estimates
from .blocks import Estimates, columns, enter
from .fits import FITTED
from .model_ratio import model_ratios
from .persson_estimates import persson_values
from .resolution import UNRESOLVED, resolution, slip_resolution, trace_resolution
from .shear_sums import per_contact


def completed(
    plan: Plan,
    variant: Variant,
    estimates: Estimates,
    sound: np.ndarray,
    counts: np.ndarray,
    other: Estimates | None = None,
) -> Estimates:
    """Return name -> array over all tasks of a variant.

    estimates : of the tasks ``sound``; other rows become NaN or -1. counts : realizations of each
    task, shape (tasks,). other : completed estimates of ``plan.other_body``. Errors of the times
    and positions of trace samples are omitted if all are zero.
    """
    tasks = variant.tasks
    names = accuracy_estimates(variant.study.scene.quantities)
    done = [tasks[row] for row in sound]
    estimates = estimates | resolution(done, estimates, names, variant.numerics)
    if "trace_samples_per_contact" in estimates:
        estimates |= trace_resolution(done, estimates, variant.numerics, variant.recording.origin)
    if "slip_changes" in estimates:
        estimates |= slip_resolution(done, estimates, estimates.pop("slip_changes"))
    errors = {f"{name}_error" for name in MOTION_TRACES}
    without_error = {name for name in errors if not np.any(estimates.get(name, 0.0) > 0.0)}
    spread = {
        n: _spread(v, sound, len(tasks)) for n, v in estimates.items() if n not in without_error
    }
    if "persson" in plan.study.scene.quantities:
        spread |= persson_values(tasks, variant.lines, variant.study.grid["roughness"][0])
        if tasks[0].problem.effects.shear is not None:
            problems = [task.problem for task in tasks]
            shear = per_contact(problems, [problem.ends[0] for problem in problems])
            shear *= spread["area_persson"]
            total = spread["mu_persson"] + shear
            spread |= {"mu_persson_shear": shear, "mu_persson_total": total}
    if variant is plan.variants[0] and "mu_1" in names:
        spread |= model_ratios(plan, spread, other)
    slopes = [line_slope(task.problem, variant.lines.normalisation) for task in tasks]
    return spread | {
        "realizations": counts,
        "rms_slope": np.array(slopes),
        "speed_ratio": np.array([speed_ratio(task.problem) for task in tasks]),
        "steps_per_spacing": np.array([t.steps_per_spacing for t in tasks], np.int32),
    }


def exponents_of(plan: Plan, variant: Variant, estimates: Estimates) -> Estimates:
    """Fit the exponents of eq. 13 to the replicates of b, which are removed from the estimates."""
    rates = estimates.pop("rate_replicates", None)
    if rates is None:
        return {}
    hurst = np.array([task.problem.hurst for task in variant.tasks])
    return fit_exponents(plan.study.grid["hurst"], hurst, estimates, rates)


def _spread(values: np.ndarray, sound: np.ndarray, count: int) -> np.ndarray:
    """Return estimates of the sound tasks as an array over all tasks, NaN or -1 elsewhere."""
    if sound.size == count:
        return values
    nothing = np.nan if values.dtype.kind == "f" else -1
    spread = np.full((count, *values.shape[1:]), nothing, values.dtype)
    spread[sound] = values
    return spread


class PowerLaw(NamedTuple):
    """Fit of eq. 13; arrays hold the estimate, then its jackknife replicates."""

    alpha: np.ndarray  # b = x^alpha, shape (replicates,)
    alpha_free: np.ndarray  # b = c x^alpha, shape (replicates,)
    alpha_prefactor: np.ndarray  # c, shape (replicates,)
    alpha_scatter: float  # rms of log10(b / x^alpha)
    alpha_bias: float  # of alpha if b is biased in one direction at all points
    alpha_free_bias: float  # of alpha_free if b is biased oppositely at fast and slow points
    alpha_points: int


def fit_power_law(x: np.ndarray, rate: np.ndarray, bias: np.ndarray) -> PowerLaw:
    """Fit log b = alpha log x (eq. 13) to points with x > 1, without and with a prefactor.

    x : shape (points,). rate : b, shape (points, replicates). bias : relative bound of the bias
    of b, shape (points,). NaN for fewer than 3 points, or for equal x.
    """
    count, size = rate.shape
    if count < 3 or np.ptp(x) == 0.0:
        nothing = np.full(size, np.nan)
        return PowerLaw(nothing, nothing, nothing, np.nan, np.nan, np.nan, count)
    log_x, log_b = np.log(x), np.log(rate)
    alpha = log_x @ log_b / (log_x @ log_x)
    centred = log_x - log_x.mean()
    free = centred @ log_b / (centred @ centred)
    prefactor = np.exp(log_b.mean(axis=0) - free * log_x.mean())
    residual = (log_b[:, 0] - alpha[0] * log_x) / np.log(10.0)
    scatter, shift = float(np.sqrt(np.mean(residual**2))), np.log1p(bias)
    alpha_bias = float(shift @ log_x / (log_x @ log_x))
    free_bias = float(shift @ np.abs(centred) / (centred @ centred))
    return PowerLaw(alpha, free, prefactor, scatter, alpha_bias, free_bias, count)


def fit_exponents(
    axis: tuple[float, ...], hurst: np.ndarray, points: Estimates, rates: np.ndarray
) -> Estimates:
    """Return name -> array over ``axis``: the fits of eq. 13 to distinct problems with x > 1.

    axis : Hurst exponents, one fit each. hurst and points : per task, shape (tasks,). rates : b
    and its jackknife replicates, shape (tasks, blocks + 1). Points whose contacts are unresolved
    are left out and counted.
    """
    x = points["speed_ratio"]
    fitted = (points["fit_status"] == FITTED) & (x > 1.0)
    resolved = points["resolution_status"] != UNRESOLVED
    chosen = [fitted & resolved & (hurst == value) for value in axis]
    bias = points["relaxation_rate_bias"]
    unresolved = [np.sum(fitted & ~resolved & (hurst == value)) for value in axis]
    laws = columns([fit_power_law(x[rows], rates[rows], bias[rows]) for rows in chosen])
    exponents: Estimates = {}
    for name in ("alpha", "alpha_free", "alpha_prefactor"):
        enter(exponents, name, getattr(laws, name))
    for name in ("alpha_scatter", "alpha_bias", "alpha_free_bias"):
        exponents[name] = getattr(laws, name)
    exponents["alpha_unresolved"] = np.array(unresolved, dtype=np.int32)
    exponents["alpha_points"] = laws.alpha_points.astype(np.int32)
    return exponents
