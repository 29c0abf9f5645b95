"""Reduction of block means to estimates with standard errors; runs on the workers."""

import numpy as np

from ..plan import JACKKNIFE_GROUPS
from ..simulate import HALVED_STEP_SCALARS, SCALARS
from ..study import QUANTITIES
from .blocks import Blocks, Estimates, columns, enter
from .fits import FITTED, NEGLIGIBLE, RelaxationFit, fit_exponential, fit_relaxation
from .jackknife import errors_needed, padded, replicates
from .models import COEFFICIENTS, GAINS, Comparison, compare_models
from .traces import reduce_programmes, reduce_steps

WHOLE_ERROR = 2.0  # times what halved steps change


def reduce_blocks(blocks: Blocks) -> Estimates:
    """Return name -> array over tasks (first axis); NAME_error beside each estimate.

    ``rate_replicates`` carries the jackknife on to the fit of eq. 13, for which all points have as
    many groups: shape (tasks, JACKKNIFE_GROUPS + 1).
    """
    asked = blocks.quantities
    values = dict(zip(SCALARS, np.moveaxis(replicates(blocks.scalars, 1), 2, 0), strict=True))
    estimates: Estimates = {}
    freedom = np.full(len(blocks.scalars), blocks.scalars.shape[1] - 1, np.int32)
    estimates["degrees_of_freedom"] = freedom
    enter(estimates, "samples_per_contact", values["samples_per_contact"])
    for quantity in asked:
        for name in QUANTITIES[quantity].means:
            enter(estimates, name, values[name])
    if "curve" in blocks.values:
        start = values["mu_1"] + values["jump"]
        curves = np.concatenate([start[..., None], replicates(blocks.values["curve"], 1)], axis=2)
        zero = np.zeros((len(blocks.time), 1))
        time = np.concatenate([zero, blocks.time], axis=1)
        if "relaxation" in asked:
            enter(estimates, "mu", curves)
            estimates["time"] = time
            deviation = curves - values["mu_2"][..., None]
            enter(estimates, "deviation", deviation)
            _relaxations(estimates, blocks, deviation[:, :, 1:])
        reduce_steps(estimates, blocks, time, curves, values)
    reduce_programmes(estimates, blocks)
    if "steady" in asked and "cycle_mean" in asked:
        mean = replicates(blocks.values["mu_cycle_mean"], 1)
        enter(estimates, "mu_cycle_share", mean / values["mu_1"])
    if "halved_steps" in blocks.values:
        _halved(estimates, blocks)
    return estimates


def _halved(estimates: Estimates, blocks: Blocks) -> None:
    """Enter the biases of estimates from what halved steps changed on a few lines.

    The whole error is a third more than the change where it falls with the square of the step,
    and as much again where it falls with the step itself, which is what is stated.
    """
    sums = blocks.values["halved_steps"].mean(axis=1)
    with np.errstate(all="ignore"):
        change = dict(zip(HALVED_STEP_SCALARS, (sums[:, 1:] / sums[:, :1]).T, strict=True))
        for name in ("mu_1", "jump"):
            if name in estimates:
                bias = WHOLE_ERROR * np.abs(change[name] / estimates[name])
                estimates[f"{name}_bias"] = bias
        if "relaxation" in blocks.quantities:
            curves = blocks.values["halved_steps_curve"].mean(axis=1) / sums[:, :1]
            after = curves - change["mu_2"][:, None]
            estimates["relaxation_rate_bias"] = WHOLE_ERROR * np.array(
                [_rate_changes(estimates, blocks, task, own) for task, own in enumerate(after)]
            )


def _rate_changes(estimates: Estimates, blocks: Blocks, task: int, change: np.ndarray) -> float:
    """Return by which share b of a mean curve changes with a change of it; NaN without b."""
    if estimates["fit_status"][task] != FITTED:
        return np.nan
    time, deviation = blocks.time[task], estimates["deviation"][task, 1:]
    kept = _relaxing(blocks, task, deviation)
    before, after = (
        fit_exponential(time[kept], curve[kept])[1] for curve in (deviation, deviation + change)
    )
    return float(abs(after / before - 1.0))


def _relaxing(blocks: Blocks, task: int, deviation: np.ndarray) -> np.ndarray:
    """Return of which samples a task relaxes; deviation : mu - mu_2 of its mean curve."""
    kept = np.isfinite(blocks.time[task])
    if not blocks.jumps:  # then friction rises before it relaxes
        kept &= np.arange(kept.size) >= np.nanargmax(np.abs(deviation))
    return kept


def _relaxations(estimates: Estimates, blocks: Blocks, deviation: np.ndarray) -> None:
    final = blocks.scalars[:, :, SCALARS.index("mu_2"), None]
    fits: list[RelaxationFit] = []
    compared: list[Comparison] = []
    for task in range(len(blocks.time)):
        kept = _relaxing(blocks, task, deviation[task][0])
        time, curves = blocks.time[task][kept], deviation[task][:, kept]
        fits.append(fit_relaxation(time, curves, blocks.rms_slope[task]))
        if "models" in blocks.quantities:
            each = (blocks.values["curve"][task] - final[task])[:, kept]
            compared.append(compare_models(time, curves, each, fits[-1].rate[0]))
    status, rate, amplitude, rate_free, window, quality = columns(fits)
    enter(estimates, "relaxation_rate", rate)
    enter(estimates, "amplitude", amplitude)
    enter(estimates, "relaxation_rate_free", rate_free)
    # Negligible is what surely relaxes less than that share of the jump; a bound of zero leaves
    # every fit as it is, and so does a curve that holds no numbers.
    groups = max(blocks.scalars.shape[1], 2)
    error = np.nan_to_num(estimates["deviation_error"][:, 0])  # of one block nothing is known
    most = np.abs(estimates["deviation"][:, 0]) + errors_needed(groups, 2.0, 0.05) * error
    jump = np.abs(np.mean(blocks.scalars[:, :, SCALARS.index("jump")], axis=1))
    status = np.where(most < blocks.negligible * jump, NEGLIGIBLE, status)
    estimates["fit_status"] = status.astype(np.int8)
    estimates |= {"fit_window": window, "fit_quality": quality}
    estimates["rate_replicates"] = padded(rate, JACKKNIFE_GROUPS)
    if compared:
        found = columns(compared)
        estimates["best_model"] = found.best.astype(np.int8)
        for name in COEFFICIENTS:
            enter(estimates, name, getattr(found, name))
        for name in GAINS:
            estimates[name], estimates[f"{name}_error"] = getattr(found, name).T
