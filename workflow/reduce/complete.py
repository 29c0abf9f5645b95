"""Completion of the estimates of a variant: resolution, model ratios, exponents of eq. 13."""

from functools import lru_cache, partial
from typing import NamedTuple

import numpy as np

from ...kernels import MOTION_TRACES, equivalent_of_cut
from ...kernels.half_space.persson import (
    Waves,
    persson_theory,
    waves_of_line,
    waves_of_map,
    waves_of_self_affine,
)
from ..plan import (
    Plan,
    Variant,
    line_slope,
    model_ratio,
    nominal_pressure,
    speed_ratio,
)
from ..simulate import LineShape, Task
from ..study import HALF_SPACE, Surface, accuracy_estimates
from .blocks import Estimates, columns, enter
from .fits import FITTED
from .resolution import UNRESOLVED, resolution, trace_resolution

CUT_KINDS = ("measured", "random-phase")  # lines that are cuts through the rough surface


def completed(
    plan: Plan, variant: Variant, estimates: Estimates, sound: np.ndarray, counts: np.ndarray
) -> Estimates:
    """Return name -> array over all tasks of a variant.

    estimates : of the tasks at the rows ``sound``; other rows become NaN or -1. counts :
    realizations of each task, shape (tasks,). Errors of the times and positions of trace samples
    are omitted if all are zero.
    """
    tasks = variant.tasks
    names = accuracy_estimates(plan.study.scene.quantities)
    done = [tasks[row] for row in sound]
    estimates = estimates | resolution(done, estimates, names, variant.numerics)
    if "trace_samples_per_contact" in estimates:
        estimates |= trace_resolution(done, estimates, variant.numerics, variant.recording.origin)
    errors = {f"{name}_error" for name in MOTION_TRACES}
    without_error = {name for name in errors if not np.any(estimates.get(name, 0.0) > 0.0)}
    spread = {
        n: _spread(v, sound, len(tasks)) for n, v in estimates.items() if n not in without_error
    }
    spread |= _model_ratios(tasks, variant.lines.normalisation) if "mu_1" in names else {}
    if "persson" in plan.study.scene.quantities:
        spread |= _persson_estimates(tasks, variant.lines)
    slopes = [line_slope(task.problem, variant.lines.normalisation) for task in tasks]
    return spread | {
        "realizations": counts,
        "rms_slope": np.array(slopes),
        "speed_ratio": np.array([speed_ratio(task.problem) for task in tasks]),
        "steps_per_spacing": np.array([t.steps_per_spacing for t in tasks], np.int32),
    }


def _model_ratios(tasks: list[Task], normalisation: str) -> Estimates:
    """Return mu_1 on a foundation over mu_1 on a half-space, if known for any task."""
    ratios = np.array([model_ratio(task.problem, normalisation) for task in tasks])
    if np.isnan(ratios).all():
        return {}
    return {"model_ratio": ratios[:, 0], "model_ratio_error": ratios[:, 1]}


def _persson_estimates(tasks: list[Task], lines: Surface) -> Estimates:
    """Return friction and contact area at v1 by Persson's theory, for the study's spectrum."""
    theory = np.empty((len(tasks), 2))
    waves_of = lru_cache(maxsize=100)(partial(_waves, lines))
    for row, task in enumerate(tasks):
        problem = task.problem
        waves = waves_of(*problem[:2], problem.surface)
        theory[row] = persson_theory(
            waves, problem.spectrum, nominal_pressure(problem), problem.ends[0]
        )
    return {"mu_persson": theory[:, 0], "area_persson": theory[:, 1]}


def _waves(lines: Surface, hurst: float, elements: int, shape: LineShape) -> Waves:
    """Return the waves of the rough surface, which are the same for both bodies."""
    if lines.profile is None or lines.spectrum is None:
        modes = shape.rolloff, shape.cutoff
        return waves_of_self_affine(hurst, elements, *modes, lines.normalisation)
    spectrum = lines.spectrum / lines.profile.roughness
    if lines.body == HALF_SPACE:
        return waves_of_map(spectrum, elements)
    if lines.lines in CUT_KINDS:
        spectrum = equivalent_of_cut(spectrum)
    return waves_of_line(spectrum, elements)


def exponents_of(plan: Plan, variant: Variant, estimates: Estimates) -> Estimates:
    """Remove the replicates of b from the estimates, and fit the exponents of eq. 13 to them."""
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
