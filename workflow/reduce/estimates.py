"""Reduction of block means to estimates with standard errors; runs on the workers."""

from typing import NamedTuple

import numpy as np

from workflow.reduce.fits import FITTED, RelaxationFit, fit_power_law, fit_relaxation
from workflow.reduce.models import COEFFICIENTS, GAINS, Comparison, compare_models
from workflow.reduce.statistics import replicates, standard_error
from workflow.simulate import SCALARS
from workflow.study import QUANTITIES

Estimates = dict[str, np.ndarray]


class Blocks(NamedTuple):
    """Block means of some tasks, dimensionless, and what is needed to reduce them."""

    scalars: np.ndarray  # shape (tasks, blocks, len(SCALARS))
    curves: np.ndarray  # shape (tasks, blocks, samples - 1)
    time: np.ndarray  # shape (tasks, samples - 1), in tau; NaN beyond the recorded steps
    rms_slope: np.ndarray  # shape (tasks,), in h/dx
    quantities: tuple[str, ...]


def reduce_blocks(blocks: Blocks) -> Estimates:
    """Return name -> array over tasks (first axis); NAME_error beside each estimate.

    ``rate_replicates`` (tasks, blocks + 1) carries the jackknife on to the fit of eq. 13.
    """
    asked = blocks.quantities
    values = dict(zip(SCALARS, np.moveaxis(replicates(blocks.scalars, 1), 2, 0), strict=True))
    estimates: Estimates = {}
    for quantity in asked:
        for name in QUANTITIES[quantity].means:
            _estimate(estimates, name, values[name])
    if "relaxation" in asked:
        start = values["mu_1"] + values["jump"]
        curves = np.concatenate([start[..., None], replicates(blocks.curves, 1)], axis=2)
        _estimate(estimates, "mu", curves)
        zero = np.zeros((len(blocks.time), 1))
        estimates["time"] = np.concatenate([zero, blocks.time], axis=1)
        deviation = curves - values["mu_2"][..., None]
        _estimate(estimates, "deviation", deviation)
        _relaxations(estimates, blocks, deviation[:, :, 1:])
    return estimates


def _estimate(estimates: Estimates, name: str, values: np.ndarray) -> None:
    """Enter the estimate and its error from replicates along axis 1."""
    estimates[name] = values[:, 0]
    estimates[f"{name}_error"] = standard_error(values, 1)


def _relaxations(estimates: Estimates, blocks: Blocks, deviation: np.ndarray) -> None:
    final = blocks.scalars[:, :, SCALARS.index("mu_2"), None]
    fits: list[RelaxationFit] = []
    compared: list[Comparison] = []
    for task in range(len(blocks.time)):
        kept = np.isfinite(blocks.time[task])
        time, curves = blocks.time[task][kept], deviation[task][:, kept]
        fits.append(fit_relaxation(time, curves, blocks.rms_slope[task]))
        if "models" in blocks.quantities:
            each = (blocks.curves[task] - final[task])[:, kept]
            compared.append(compare_models(time, curves, each, fits[-1].rate[0]))
    _estimate(estimates, "relaxation_rate", np.array([fit.rate for fit in fits]))
    _estimate(estimates, "amplitude", np.array([fit.amplitude for fit in fits]))
    _estimate(estimates, "relaxation_rate_free", np.array([fit.rate_free for fit in fits]))
    estimates["fit_status"] = np.array([fit.status for fit in fits], dtype=np.int8)
    estimates["fit_window"] = np.array([fit.window for fit in fits])
    estimates["fit_quality"] = np.array([fit.quality for fit in fits])
    estimates["rate_replicates"] = np.array([fit.rate for fit in fits])
    if compared:
        _models(estimates, compared)


def _models(estimates: Estimates, found: list[Comparison]) -> None:
    estimates["best_model"] = np.array([c.best for c in found], dtype=np.int8)
    for name in COEFFICIENTS:
        _estimate(estimates, name, np.array([getattr(c, name) for c in found]))
    for name in GAINS:
        gains = np.array([getattr(c, name) for c in found])
        estimates[name], estimates[f"{name}_error"] = gains.T


def fit_exponents(
    axis: tuple[float, ...], hurst: np.ndarray, x: np.ndarray, status: np.ndarray, rates: np.ndarray
) -> Estimates:
    """Return name -> array over ``axis``: the fits of eq. 13 over distinct problems with x > 1.

    axis : the Hurst exponents to fit for. hurst, x, status : per task, shape (tasks,). rates : b
    and its jackknife replicates, shape (tasks, blocks + 1).
    """
    usable = (status == FITTED) & (x > 1.0)
    chosen = [usable & (hurst == value) for value in axis]
    laws = [fit_power_law(x[rows], rates[rows]) for rows in chosen]
    found: Estimates = {}
    _estimate(found, "alpha", np.array([law.alpha for law in laws]))
    _estimate(found, "alpha_free", np.array([law.alpha_free for law in laws]))
    _estimate(found, "alpha_prefactor", np.array([law.prefactor for law in laws]))
    found["alpha_scatter"] = np.array([law.scatter for law in laws])
    found["alpha_points"] = np.array([law.points for law in laws], dtype=np.int32)
    return found
