"""Reduction of block means to estimates with standard errors, on the workers."""

import numpy as np

from ..plan import JACKKNIFE_GROUPS
from ..simulate import HALVED_STEP_SCALARS, SCALARS
from ..study import QUANTITIES
from .blocks import Blocks, Estimates, columns, enter
from .fits import FITTED, NEGLIGIBLE, RelaxationFit, fit_exponential, fit_relaxation
from .jackknife import errors_needed, padded, replicates
from .models import COEFFICIENTS, GAINS, Comparison, compare_models
from .tile_errors import enter_tile_errors
from .traces import reduce_programmes, reduce_steps

HALVING_ERROR = 2.0  # bound of the error, relative to the change by halved steps


def reduce_blocks(blocks: Blocks) -> Estimates:
    """Return name -> array over tasks (first axis), with NAME_error for each estimate.

    ``rate_replicates`` holds the jackknife replicates for the fit of eq. 13, padded to the same
    number of groups for all tasks: shape (tasks, JACKKNIFE_GROUPS + 1). ``NAME_replicates`` holds
    those of ``blocks.carried`` for point_quantities.py.
    """
    requested = blocks.quantities
    values = dict(zip(SCALARS, np.moveaxis(replicates(blocks.scalars, 1), 2, 0), strict=True))
    estimates: Estimates = {}
    freedom = np.full(len(blocks.scalars), blocks.scalars.shape[1] - 1, np.int32)
    estimates["degrees_of_freedom"] = freedom
    enter(estimates, "samples_per_contact", values["samples_per_contact"])
    for quantity in requested:
        for name in QUANTITIES[quantity].means:
            enter(estimates, name, values[name])
    if "steady" in requested and "contact_temperature" in blocks.values:
        for name in ("contact_temperature", "flash_temperature"):
            enter(estimates, name, replicates(blocks.values[name], 1))
    for name in blocks.carried:
        estimates[f"{name}_replicates"] = padded(values[name], JACKKNIFE_GROUPS)
    if "curve" in blocks.values:
        start = values["mu_1"] + values["jump"]
        curves = np.concatenate([start[..., None], replicates(blocks.values["curve"], 1)], axis=2)
        zero = np.zeros((len(blocks.time), 1))
        time = np.concatenate([zero, blocks.time], axis=1)
        if "relaxation" in requested:
            enter(estimates, "mu", curves)
            estimates["time"] = time
            deviation = curves - values["mu_2"][..., None]
            enter(estimates, "deviation", deviation)
            _relaxations(estimates, blocks, deviation[:, :, 1:])
        reduce_steps(estimates, blocks, time, curves, values)
    reduce_programmes(estimates, blocks)
    for name, part in (blocks.parts or {}).items():
        if name.rpartition("_")[0] in estimates:
            enter(estimates, name, replicates(part, 1))
    if "tiles" in blocks.values:
        enter_tile_errors(estimates, blocks)
    if "steady" in requested and "cycle_mean" in requested:
        mean = replicates(blocks.values["mu_cycle_mean"], 1)
        enter(estimates, "mu_cycle_share", mean / values["mu_1"])
    if "halved_steps" in blocks.values:
        _halved(estimates, blocks)
    return estimates


def _halved(estimates: Estimates, blocks: Blocks) -> None:
    """Store the biases of estimates, from their changes with halved steps on a few lines.

    The error is 4/3 of the change if it is of second order in the step, and twice the change if it
    is of first order. The larger factor is used.
    """
    sums = blocks.values["halved_steps"].mean(axis=1)
    with np.errstate(all="ignore"):
        change = dict(zip(HALVED_STEP_SCALARS, (sums[:, 1:] / sums[:, :1]).T, strict=True))
        for name in ("mu_1", "jump"):
            if name in estimates:
                bias = HALVING_ERROR * np.abs(change[name] / estimates[name])
                estimates[f"{name}_bias"] = bias
        if "relaxation" in blocks.quantities:
            curves = blocks.values["halved_steps_curve"].mean(axis=1) / sums[:, :1]
            after = curves - change["mu_2"][:, None]
            estimates["relaxation_rate_bias"] = HALVING_ERROR * np.array(
                [_rate_change(estimates, blocks, task, curve) for task, curve in enumerate(after)]
            )


def _rate_change(estimates: Estimates, blocks: Blocks, task: int, change: np.ndarray) -> float:
    """Return the relative change of b due to a change of the mean curve; NaN without b."""
    if estimates["fit_status"][task] != FITTED:
        return np.nan
    time, deviation = blocks.time[task], estimates["deviation"][task, 1:]
    relaxing = _relaxing(blocks, task, deviation)
    before, after = (
        fit_exponential(time[relaxing], curve[relaxing])[1]
        for curve in (deviation, deviation + change)
    )
    return float(abs(after / before - 1.0))


def _relaxing(blocks: Blocks, task: int, deviation: np.ndarray) -> np.ndarray:
    """Return the mask of the samples of the relaxation; deviation : mu - mu_2 of the mean curve."""
    relaxing = np.isfinite(blocks.time[task])
    if not blocks.jumps:  # without a jump friction rises before it relaxes
        relaxing &= np.arange(relaxing.size) >= np.nanargmax(np.abs(deviation))
    return relaxing


def _relaxations(estimates: Estimates, blocks: Blocks, deviation: np.ndarray) -> None:
    """Store the fits of eq. 6, and their comparison with other models if requested.

    deviation : mu - mu_2, shape (tasks, replicates, samples).
    """
    final = blocks.scalars[:, :, SCALARS.index("mu_2"), None]
    fits: list[RelaxationFit] = []
    comparisons: list[Comparison] = []
    for task in range(len(blocks.time)):
        relaxing = _relaxing(blocks, task, deviation[task][0])
        time, curves = blocks.time[task][relaxing], deviation[task][:, relaxing]
        fits.append(fit_relaxation(time, curves, blocks.rms_slope[task]))
        if "models" in blocks.quantities:
            block_curves = (blocks.values["curve"][task] - final[task])[:, relaxing]
            comparisons.append(compare_models(time, curves, block_curves, fits[-1].rate[0]))
    status, rate, amplitude, rate_free, window, quality = columns(fits)
    enter(estimates, "relaxation_rate", rate)
    enter(estimates, "amplitude", amplitude)
    enter(estimates, "relaxation_rate_free", rate_free)
    # A relaxation is negligible if its upper bound is below the given share of the jump. A share
    # of zero, or NaN in the curve, changes no status.
    groups = max(blocks.scalars.shape[1], 2)
    error = np.nan_to_num(estimates["deviation_error"][:, 0])  # unknown for one block
    most = np.abs(estimates["deviation"][:, 0]) + errors_needed(groups, 2.0, 0.05) * error
    jump = np.abs(np.mean(blocks.scalars[:, :, SCALARS.index("jump")], axis=1))
    status = np.where(most < blocks.negligible * jump, NEGLIGIBLE, status)
    estimates["fit_status"] = status.astype(np.int8)
    estimates |= {"fit_window": window, "fit_quality": quality}
    estimates["rate_replicates"] = padded(rate, JACKKNIFE_GROUPS)
    if comparisons:
        compared = columns(comparisons)
        estimates["best_model"] = compared.best.astype(np.int8)
        for name in COEFFICIENTS:
            enter(estimates, name, getattr(compared, name))
        for name in GAINS:
            estimates[name], estimates[f"{name}_error"] = getattr(compared, name).T
