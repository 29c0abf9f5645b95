"""Estimates of velocity steps and programmes: peaks, rate and state, traces, energies.

Without a dashpot friction does not jump with the velocity. The peak and its time then correspond
to the direct effect of an experiment.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from ...kernels import ENERGIES, MOTION_TRACES
from ...kernels.drive import DRIVE_ENERGIES, SLIP_EVENTS, SLIPS
from .blocks import PROGRAMME_TRACES, TRACE_ESTIMATES, Blocks, Estimates, columns, enter
from .extremum import extremum
from .healing import healing
from .jackknife import replicates, standard_error
from .loop import loop
from .rate_state import STATE_LAWS, RateState, fit_rate_state

CHANGE_TRACES = ("trace_mu", "trace_indentation")  # their changes within a leg are also estimates
SINGLE_REALIZATION = ("snapshot_", "state_")  # prefixes of values of one realization, without error

Means = dict[str, np.ndarray]  # replicates of traces, shape (tasks, replicates, events)


def reduce_steps(
    estimates: Estimates,
    blocks: Blocks,
    time: np.ndarray,
    curves: np.ndarray,
    values: dict[str, np.ndarray],
) -> None:
    """Store estimates of the friction after the velocity step: peak, initial rate, rate and state.

    time : since the step, in tau, shape (tasks, samples). curves : mu, shape (tasks, replicates,
    samples). values : replicates of the scalars, each of shape (tasks, replicates).
    """
    if "peak" in blocks.quantities:
        extrema = []
        for times, mu, (before, after) in zip(time, curves, blocks.speeds, strict=True):
            sampled = np.isfinite(times)
            sign = 1.0 if after > before else -1.0
            extrema.append(extremum(times[sampled], mu[:, sampled], sign))
        peaks, peak_times = np.moveaxis(np.array(extrema), 1, 0)
        enter(estimates, "peak", peaks - values["mu_1"])
        enter(estimates, "peak_time", peak_times)
        if "initial_rate" in blocks.values:
            enter(estimates, "initial_rate", replicates(blocks.values["initial_rate"], 1))
    if "rate_state" in blocks.quantities:
        change = values["mu_2"] - values["mu_1"]
        deviation = curves - values["mu_2"][..., None]
        enter(estimates, "rate_state_a_minus_b", _a_minus_b(blocks.speeds, change))
        _rate_state(estimates, blocks, time, deviation, change)


def _a_minus_b(speeds: np.ndarray, change: np.ndarray) -> np.ndarray:
    """Return (mu_2 - mu_1)/ln(v2/v1); NaN without a step, and for a reversal.

    speeds : before and after, shape (tasks, 2). change : mu_2 - mu_1, shape (tasks, replicates).
    """
    before, after = speeds.T
    steps = (before * after > 0.0) & (before != after)
    logs = np.log(after / before, where=steps, out=np.full(before.shape, np.nan))
    return change * (np.sign(before) / logs)[:, None]


def _rate_state(
    estimates: Estimates,
    blocks: Blocks,
    time: np.ndarray,
    deviation: np.ndarray,
    change: np.ndarray,
) -> None:
    """Store a, b and D_c (in dx) of both laws; arrays of shape (tasks, laws)."""
    fits: list[list[RateState]] = []
    for task, (before, after) in enumerate(blocks.speeds):
        sampled = np.isfinite(time[task])
        distance, curves = abs(after) * time[task][sampled], deviation[task][:, sampled]
        ratio, sign = after / before, np.sign(before)
        data = distance, sign * curves, sign * change[task], ratio
        fits.append([fit_rate_state(*data, law) for law in STATE_LAWS])
    laws = columns([columns(of_task) for of_task in fits])  # axes: tasks, laws
    for name in ("a", "b", "dc"):
        enter(estimates, f"rate_state_{name}", np.moveaxis(getattr(laws, name), 2, 1))
    estimates["rate_state_residual"] = laws.residual
    estimates["rate_state_status"] = laws.status.astype(np.int8)


def reduce_programmes(estimates: Estimates, blocks: Blocks) -> None:
    """Store the requested estimates of a programme."""
    values = blocks.values
    means = {name: replicates(v, 1) for name, v in values.items() if name in PROGRAMME_TRACES}
    means |= {name: _motion(values[name]) for name in MOTION_TRACES if name in values}
    for quantities, reduce_quantity in QUANTITY_REDUCERS:
        if any(quantity in blocks.quantities for quantity in quantities):
            reduce_quantity(estimates, blocks, means)
    for name in (*SLIPS, "mu_cycle_mean", "contact_length"):
        if name in values:
            enter(estimates, name, replicates(values[name], 1))
    if "slip_changes" in values:
        estimates["slip_changes"] = values["slip_changes"].mean(axis=1)
    single = [name for name in values if name.startswith(SINGLE_REALIZATION)]
    estimates |= {name: values[name].mean(axis=1) for name in single}


def _store_motion(estimates: Estimates, blocks: Blocks, means: Means) -> None:
    """Store the times and positions of the trace samples, and their segments."""
    for name in MOTION_TRACES:
        estimates[name] = means[name][:, 0]
        estimates[f"{name}_error"] = standard_error(means[name] - means[name][:, :1], 1)
    legs = blocks.legs
    estimates["trace_segment"] = np.where(np.isnan(legs), -1, legs).astype(np.int32)


def _store_traces(estimates: Estimates, blocks: Blocks, means: Means) -> None:
    """Store the traces, and the changes of friction and indentation."""
    for name in TRACE_ESTIMATES:
        if name not in MOTION_TRACES and name in means:
            enter(estimates, name, means[name])
        if name in CHANGE_TRACES:
            enter(estimates, f"{name}_change", _changes(means[name], blocks.legs))


def _store_energies(estimates: Estimates, _: Blocks, means: Means) -> None:
    """Store the energies and the residual of their balance at the end.

    It is (work - change of stored energy - dissipated - closing work)/dissipated, and with a drive
    (work of the drive - losses - change of stored energies - step work)/work.
    """
    of_drive = "drive_work" in means
    energies = {name: means[name] for name in (DRIVE_ENERGIES if of_drive else ENERGIES)}
    for name, values in energies.items():
        enter(estimates, name, values)
    start = {name: values[:, :, 0] for name, values in energies.items()}
    with np.errstate(all="ignore"):
        if of_drive:
            driven, rubbed, spring, kinetic, damped, error = map(_last, energies.values())
            change = spring + kinetic - start["spring_energy"] - start["kinetic_energy"]
            residual = (driven - rubbed - damped - error - change) / driven
        else:
            stored, dissipated, work, closing = map(_last, energies.values())
            change = stored - start["stored_energy"]
            residual = (work - change - dissipated - closing) / dissipated
    enter(estimates, "balance_residual", residual)


def _store_healing(estimates: Estimates, blocks: Blocks, means: Means) -> None:
    """Store the static peak after the last hold."""
    distance, mu = means["trace_distance"], means["trace_mu"]
    _store_by_task(estimates, blocks, healing, blocks.legs[:, None], distance, mu)


def _store_loop(estimates: Estimates, blocks: Blocks, means: Means) -> None:
    """Store the loop of the last oscillation."""
    names = ("trace_time", "trace_mu", "trace_friction_force")
    _store_by_task(estimates, blocks, loop, *map(means.__getitem__, names))


def _store_slip_events(estimates: Estimates, blocks: Blocks, _: Means) -> None:
    """Store the times and kinds of slip events, cut to the largest number of events of a task."""
    times, kinds = (blocks.values[name].mean(axis=1) for name in SLIP_EVENTS)
    count = int(np.isfinite(times).sum(axis=1).max())
    estimates["slip_event_time"] = times[:, :count]
    estimates["slip_event_kind"] = np.nan_to_num(kinds[:, :count], nan=-1.0).astype(np.int8)


# Quantities of a programme, and the function that stores their estimates.
QUANTITY_REDUCERS: tuple[tuple[tuple[str, ...], Callable[..., None]], ...] = (
    (("trace", "energy"), _store_motion),
    (("trace",), _store_traces),
    (("energy",), _store_energies),
    (("healing",), _store_healing),
    (("loop",), _store_loop),
    (("slip_events",), _store_slip_events),
)


def _motion(values: np.ndarray) -> np.ndarray:
    """Return the replicates of times or positions of samples, shape (tasks, replicates, events).

    values : shape (tasks, blocks, events). Values equal in all blocks stay exactly equal.
    """
    first = values[:, :1]
    return first + replicates(values - first, 1)


def _changes(traces: np.ndarray, legs: np.ndarray) -> np.ndarray:
    """Return the change of traces since the last sample of the previous leg.

    traces : shape (tasks, replicates, events). legs : of the events, ascending, NaN after the
    last one, shape (tasks, events). Lines shift both ends of a change alike, so that its error is
    much smaller than the errors of the two ends.
    """
    before = [np.maximum(np.searchsorted(leg, leg) - 1, 0) for leg in legs]
    return traces - np.take_along_axis(traces, np.array(before)[:, None], axis=2)


def _last(traces: np.ndarray) -> np.ndarray:
    """Return the last sample of each trace that is not NaN, shape (tasks, replicates)."""
    known = np.isfinite(traces[:, 0])
    ends = known.shape[1] - 1 - np.argmax(known[:, ::-1], axis=1)
    return np.take_along_axis(traces, ends[:, None, None], axis=2)[:, :, 0]


def _store_by_task(
    estimates: Estimates, blocks: Blocks, estimator: Callable[..., Any], *traces: np.ndarray
) -> None:
    """Store the results of ``estimator`` for the replicates of the traces of every task."""
    results = []
    for task, programme in enumerate(blocks.programmes):
        sampled = np.isfinite(blocks.legs[task])
        results.append(estimator(programme, *(trace[task][:, sampled] for trace in traces)))
    for name, values in columns(results)._asdict().items():
        enter(estimates, name, values)
