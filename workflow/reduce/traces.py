"""What a programme of motion tells: traces, energies, peaks, healing, loops, rate and state.

Without a dashpot friction does not jump with the velocity. What an experiment calls its direct
effect is then the peak, and the time at which it is reached. Of a loop, mu' and mu'' are the parts
of mu(t) = ... + mu' sin(2 pi f t) + mu'' cos(2 pi f t) in phase with the superposed displacement
A sin(2 pi f t) and with its velocity.
"""

import math
from collections.abc import Callable
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from ...kernels import ENERGIES, MOTION_TRACES, Hold, Oscillation, Programme, Slide
from ...kernels.drive import PULLED_TRACES, SLIP_EVENTS, SLIPS
from ...kernels.motion.legs import leg_duration
from .blocks import Blocks, Estimates, columns, enter
from .jackknife import replicates, standard_error
from .rate_state import LAWS, RateState, fit_rate_state

ALONG = (*PULLED_TRACES, *ENERGIES)  # the way of a programme
CHANGING = ("trace_mu", "trace_indentation")
ALONE = ("snapshot_", "state_")  # of one realization: no error


def reduce_steps(
    estimates: Estimates,
    blocks: Blocks,
    time: np.ndarray,
    curves: np.ndarray,
    values: dict[str, np.ndarray],
) -> None:
    """Enter what follows from the friction after the velocity step: its peak, rate and state.

    time : since the step, in tau, shape (tasks, samples). curves : mu, shape (tasks, replicates,
    samples). values : replicates of the scalars, each of shape (tasks, replicates).
    """
    if "peak" in blocks.quantities:
        found = []
        for at, own, (before, after) in zip(time, curves, blocks.speeds, strict=True):
            kept = np.isfinite(at)
            found.append(extremum(at[kept], own[:, kept], 1.0 if after > before else -1.0))
        peaks, times = np.moveaxis(np.array(found), 1, 0)
        enter(estimates, "peak", peaks - values["mu_1"])
        enter(estimates, "peak_time", times)
        if "initial_rate" in blocks.values:
            enter(estimates, "initial_rate", replicates(blocks.values["initial_rate"], 1))
    if "rate_state" in blocks.quantities:
        change = values["mu_2"] - values["mu_1"]
        deviation = curves - values["mu_2"][..., None]
        enter(estimates, "rate_state_a_minus_b", _a_minus_b(blocks.speeds, change))
        _rate_state(estimates, blocks, time, deviation, change)


def _a_minus_b(speeds: np.ndarray, change: np.ndarray) -> np.ndarray:
    """Return (mu_2 - mu_1)/ln(v2/v1), NaN where the velocity does not step or turns round.

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
    """Enter a, b and D_c (in dx) of both laws; arrays of shape (tasks, laws)."""
    fits: list[list[RateState]] = []
    for task, (before, after) in enumerate(blocks.speeds):
        kept = np.isfinite(time[task])
        distance, curves = abs(after) * time[task][kept], deviation[task][:, kept]
        ratio, sign = after / before, np.sign(before)
        data = distance, sign * curves, sign * change[task], ratio
        fits.append([fit_rate_state(*data, law) for law in LAWS])
    found = columns([columns(own) for own in fits])  # over (tasks, laws)
    for name in ("a", "b", "dc"):
        enter(estimates, f"rate_state_{name}", np.moveaxis(getattr(found, name), 2, 1))
    estimates["rate_state_residual"] = found.residual
    estimates["rate_state_status"] = found.status.astype(np.int8)


def reduce_programmes(estimates: Estimates, blocks: Blocks) -> None:
    """Enter what a programme was asked for."""
    asked, values, legs = blocks.quantities, blocks.values, blocks.legs
    means = {name: replicates(own, 1) for name, own in values.items() if name in ALONG}
    means |= {name: _motion(values[name]) for name in MOTION_TRACES if name in values}
    if "trace" in asked or "energy" in asked:
        for name in MOTION_TRACES:
            estimates[name] = means[name][:, 0]
            estimates[f"{name}_error"] = standard_error(means[name] - means[name][:, :1], 1)
        estimates["trace_segment"] = np.where(np.isnan(legs), -1, legs).astype(np.int32)
    for name in PULLED_TRACES if "trace" in asked else ():
        if name not in MOTION_TRACES and name in means:
            enter(estimates, name, means[name])
        if name in CHANGING:
            enter(estimates, f"{name}_change", _changes(means[name], legs))
    if "energy" in asked:
        for name in ENERGIES:
            enter(estimates, name, means[name])
        enter(estimates, "balance_residual", _residual(means))
    if "healing" in asked:
        way, mu = means["trace_distance"], means["trace_mu"]
        _each(estimates, blocks, healing, legs[:, None], way, mu)
    if "loop" in asked:
        names = ("trace_time", "trace_mu", "trace_friction_force")
        _each(estimates, blocks, loop, *map(means.__getitem__, names))
    for name in (*SLIPS, "mu_cycle_mean", "contact_length"):
        if name in values:
            enter(estimates, name, replicates(values[name], 1))
    if "slip_events" in asked:
        times, kinds = (values[name].mean(axis=1) for name in SLIP_EVENTS)
        many = int(np.isfinite(times).sum(axis=1).max())
        estimates["slip_event_time"] = times[:, :many]
        estimates["slip_event_kind"] = np.nan_to_num(kinds[:, :many], nan=-1.0).astype(np.int8)
    estimates |= {name: own.mean(axis=1) for name, own in values.items() if name.startswith(ALONE)}


def _motion(values: np.ndarray) -> np.ndarray:
    """Return the replicates of when or where traces are kept, shape (tasks, replicates, events).

    values : shape (tasks, blocks, events). What is equal in all blocks stays as it is, to the bit.
    """
    first = values[:, :1]
    return first + replicates(values - first, 1)


def _changes(traces: np.ndarray, legs: np.ndarray) -> np.ndarray:
    """Return what each trace has changed by since the last sample before the leg of a sample.

    traces : shape (tasks, replicates, events). legs : of the events, ascending, NaN beyond the
    last one, shape (tasks, events). Lines scatter together, so that the error of a change is much
    less than that of its two ends.
    """
    before = [np.maximum(np.searchsorted(leg, leg) - 1, 0) for leg in legs]
    return traces - np.take_along_axis(traces, np.array(before)[:, None], axis=2)


def _residual(means: dict[str, np.ndarray]) -> np.ndarray:
    """Return what the work lacks of stored, dissipated and closing energy, over what is dissipated.

    Shape (tasks, replicates): at the last kept sample of each trace.
    """
    stored, dissipated, work, closing = (_last(means[name]) for name in ENERGIES)
    with np.errstate(all="ignore"):
        change = stored - means["stored_energy"][:, :, 0]
        return (work - change - dissipated - closing) / dissipated


def _last(traces: np.ndarray) -> np.ndarray:
    """Return the last sample of each trace that is not NaN, shape (tasks, replicates)."""
    known = np.isfinite(traces[:, 0])
    ends = known.shape[1] - 1 - np.argmax(known[:, ::-1], axis=1)
    return np.take_along_axis(traces, ends[:, None, None], axis=2)[:, :, 0]


def _each(
    estimates: Estimates, blocks: Blocks, find: Callable[..., Any], *traces: np.ndarray
) -> None:
    """Enter the fields of what ``find`` says of every task, from replicates of its traces."""
    found = []
    for task, programme in enumerate(blocks.programmes):
        kept = np.isfinite(blocks.legs[task])
        found.append(find(programme, *(trace[task][:, kept] for trace in traces)))
    for name, values in columns(found)._asdict().items():
        enter(estimates, name, values)


class Healing(NamedTuple):
    """Of the mean trace, then of its jackknife replicates; each of shape (replicates,)."""

    static_peak: np.ndarray  # mu
    healing: np.ndarray  # mu: the static peak over the friction before the hold
    mu_end_of_hold: np.ndarray
    peak_distance: np.ndarray  # slid since the end of the hold, in dx


def last_hold(programme: Programme) -> tuple[int, float] | None:
    """Return the number of the last hold that is followed by a slide, and the speed of that."""
    found = [
        (k, after.speed)
        for k, (before, after) in enumerate(pairwise(programme))
        if isinstance(before, Hold) and isinstance(after, Slide)
    ]
    return found[-1] if found else None


def healing(
    programme: Programme, legs: np.ndarray, distance: np.ndarray, mu: np.ndarray
) -> Healing:
    """Return what the last hold of a programme did; NaN where there is none.

    legs : of the kept samples, shape (1, samples). distance (dx), mu : shape (replicates, samples),
    the mean trace first.
    """
    found = last_hold(programme)
    nothing = np.full(len(mu), np.nan)
    if found is None:
        return Healing(nothing, nothing, nothing, nothing)
    k, speed = found
    held, slid = legs[0] == k, legs[0] == k + 1
    before = np.flatnonzero(legs[0] < k)  # the last of them ends the slide before the hold
    if not (held.any() and slid.any() and before.size):
        return Healing(nothing, nothing, nothing, nothing)
    end = np.flatnonzero(held)[-1]
    slipped = np.abs(distance[0, slid] - distance[0, end])
    peak, where = extremum(slipped, mu[:, slid], float(np.sign(speed)))
    return Healing(peak, peak - mu[:, before[-1]], mu[:, end], where)


class Loop(NamedTuple):
    """Of the last cycle: of the mean trace, then of its replicates; each shape (replicates,)."""

    loop_work: np.ndarray  # in 4 G L h^2
    mu_in_phase: np.ndarray
    mu_quadrature: np.ndarray


def loop(programme: Programme, times: np.ndarray, mu: np.ndarray, force: np.ndarray) -> Loop:
    """Return the loop of the last cycle of the last oscillation; NaN where there is none.

    times (tau), mu, force (4 G L h^2/dx) : shape (replicates, samples), the mean trace first.
    Integrals over the cycle are by trapezoids over the mean times.
    """
    swung = [(k, leg) for k, leg in enumerate(programme) if isinstance(leg, Oscillation)]
    nothing = np.full(len(mu), np.nan)
    if not swung:
        return Loop(nothing, nothing, nothing)
    k, leg = swung[-1]
    begin = sum(leg_duration(before) for before in programme[:k])
    end, period = begin + leg_duration(leg), 1.0 / leg.frequency
    time = times[0]
    cycle = (time > end - period * (1.0 + 1e-9)) & (time <= end * (1.0 + 1e-12))
    at = time[cycle]
    if at.size < 4:
        return Loop(nothing, nothing, nothing)
    omega = 2.0 * math.pi * leg.frequency
    phase = omega * (at - begin)
    weight = _trapezoids(at, period)
    speed = leg.speed + leg.amplitude * omega * np.cos(phase)
    share = 2.0 / period * weight
    return Loop(
        force[:, cycle] @ (weight * speed),
        mu[:, cycle] @ (share * np.sin(phase)),
        mu[:, cycle] @ (share * np.cos(phase)),
    )


def _trapezoids(time: np.ndarray, period: float) -> np.ndarray:
    """Return the weights of samples of one period of a periodic function, shape (samples,)."""
    gaps = np.diff(time, append=time[0] + period)
    return 0.5 * (gaps + np.roll(gaps, 1))


def extremum(place: np.ndarray, curves: np.ndarray, sign: float) -> tuple[np.ndarray, np.ndarray]:
    """Return (value, place) of the largest ``sign`` times value of each curve, shape (replicates,).

    place : times or distances, increasing, shape (samples,). curves : shape (replicates, samples).
    Between samples by the parabola through the largest and its neighbours; at either end the
    sample itself. NaN where a curve holds NaN.
    """
    found = np.full((2, len(curves)), np.nan)
    for row, curve in enumerate(curves):
        if np.isfinite(curve).all():
            found[:, row] = _highest(place, sign * curve)
    return sign * found[0], found[1]


def _highest(x: np.ndarray, y: np.ndarray) -> tuple[float, float]:
    k = int(np.argmax(y))
    if not 0 < k < y.size - 1:
        return float(y[k]), float(x[k])
    before, after = x[k] - x[k - 1], x[k + 1] - x[k]
    fall, rise = (y[k] - y[k - 1]) / before, (y[k + 1] - y[k]) / after
    bend = (rise - fall) / (before + after)  # not positive, as y[k] is the largest
    if bend == 0.0:
        return float(y[k]), float(x[k])
    slope = fall + bend * before  # of the parabola at x[k]
    shift = -slope / (2.0 * bend)
    return float(y[k] + 0.5 * slope * shift), float(x[k] + shift)
