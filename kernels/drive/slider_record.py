"""Record of a pulled slider: its motion at requested times, and its slips."""

import math
from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel


class Moment(NamedTuple):
    """State of the slider when the force of a step acts; rows of a trace, with energies."""

    mu: float  # in h/dx
    indentation: float  # in h
    normal: float  # in the units of the load
    friction: float  # in the units of the drive
    touching: float  # contact fraction of the surface
    samples: float  # per contact patch
    time: float  # in tau
    place: float  # position of the slider, in dx
    speed: float  # in dx/tau
    force: float  # force of the drive
    drive_work: float  # DriveEnergies at the end of the step
    friction_work: float
    spring_energy: float
    kinetic_energy: float
    damper_work: float
    step_work: float


# Counts and extremes of a slider: one record, changed in place. Times are in tau.
SLIDER_TALLY = np.dtype(
    [
        ("steps", np.int64),  # number of steps
        ("moments", np.int64),  # number of recorded moments
        ("events", np.int64),  # number of recorded events
        ("window_start", np.float64),  # extremes and slips are counted from this time on
        ("min_force", np.float64),  # minimum force of the drive
        ("max_force", np.float64),
        ("max_speed", np.float64),
        ("slips", np.int64),
        ("first_slip", np.float64),  # beginning of the first slip, or NaN
        ("last_slip", np.float64),
        ("slow_since", np.float64),  # time when the slider became slow; inf if it is not slow
        ("last_slow", np.float64),  # last time at which the slider was slow
        ("has_stuck", np.bool_),  # whether it has stuck since its last slip
        ("is_slipping", np.bool_),
        ("is_unsteady", np.bool_),  # whether it has ended a slip, or turned against its drive
    ]
)


class SliderRecord(NamedTuple):
    """Recorded moments and events of a slider, with room for the rest; changed in place."""

    times: np.ndarray  # times at which moments are recorded, in tau, increasing; inf: at a step
    every: int  # number of steps from one recorded step to the next, where times are inf
    moments: np.ndarray  # shape (16, times): one row per field of Moment
    tally: np.ndarray  # SLIDER_TALLY, shape (1,)
    min_stick_time: float  # minimum duration of a stick, in tau
    events: np.ndarray  # shape (2, room): times (tau) and kinds of the first events, NaN beyond


SAMPLES_ROW = Moment._fields.index("samples")
SLIP_BEGINS, SLIP_ENDS, SLIDER_TURNS = range(3)  # kinds of events


@kernel
def follow_slips(record, before, now, drive_speed):
    """Record and count the events of the slider between two moments.

    The slider is slow below half the speed of the drive, in either direction. It sticks if it is
    slow for min_stick_time: half a period of its mass on the spring, or the time in which the drive
    moves by a sample if that is longer. A mass that oscillates about steady sliding is slow for a
    shorter time, and so is a massless line between the jumps of one slip. After a stick, a slip
    begins when the speed exceeds twice that of the drive. It ends when the next stick begins.
    """
    tally = record.tally[0]
    if before.speed * now.speed < 0.0:
        record_event(record, time_at_speed(before, now, 0.0), SLIDER_TURNS)
        tally["is_unsteady"] |= now.speed * drive_speed <= 0.0
    if drive_speed == 0.0:
        return
    if now.time >= tally["window_start"]:
        tally["min_force"] = min(tally["min_force"], now.force)
        tally["max_force"] = max(tally["max_force"], now.force)
        tally["max_speed"] = max(tally["max_speed"], abs(now.speed))
    share = now.speed / drive_speed
    if abs(share) < 0.5:
        if tally["slow_since"] == np.inf:
            slow_speed = math.copysign(0.5 * drive_speed, before.speed)
            tally["slow_since"] = time_at_speed(before, now, slow_speed)
        tally["last_slow"] = now.time
        if now.time - tally["slow_since"] >= record.min_stick_time:
            tally["has_stuck"] = True
            if tally["is_slipping"]:
                record_event(record, tally["slow_since"], SLIP_ENDS)
                tally["is_unsteady"] = True
            tally["is_slipping"] = False
        return
    tally["slow_since"] = np.inf
    if share > 2.0 and tally["has_stuck"]:
        record_event(record, time_at_speed(before, now, 2.0 * drive_speed), SLIP_BEGINS)
        tally["has_stuck"], tally["is_slipping"] = False, True
        if tally["last_slow"] >= tally["window_start"]:
            if tally["slips"] == 0:
                tally["first_slip"] = now.time
            tally["slips"] += 1
            tally["last_slip"] = now.time


@kernel
def time_at_speed(before, now, speed):
    """Return the interpolated time at which the slider had a speed, clipped to the two moments."""
    change = now.speed - before.speed
    share = (speed - before.speed) / change if change != 0.0 else 1.0
    return before.time + min(max(share, 0.0), 1.0) * (now.time - before.time)


@kernel
def record_event(record, time, kind):
    """Record an event if there is room for it."""
    tally = record.tally[0]
    k = tally["events"]
    if k < record.events.shape[1]:
        record.events[0, k], record.events[1, k] = time, kind
        tally["events"] = k + 1


@kernel
def count_step(record, time):
    """Count a step, and let its moment be recorded if every n-th step is."""
    tally = record.tally[0]
    tally["steps"] += 1
    k = tally["moments"]
    if k < record.times.size and record.times[k] == np.inf and tally["steps"] % record.every == 0:
        record.times[k] = time


@kernel
def next_time_is_due(record, time):
    """Return whether the next time to record is not later than ``time``."""
    k = record.tally[0]["moments"]
    return k < record.times.size and record.times[k] <= time


@kernel
def record_between(record, before, now, drive_speed):
    """Record slips, and interpolate linearly to the requested times between two moments."""
    times, moments, tally = record.times, record.moments, record.tally[0]
    follow_slips(record, before, now, drive_speed)
    while next_time_is_due(record, now.time):
        k, share = tally["moments"], 1.0
        if now.time > before.time:
            share = (times[k] - before.time) / (now.time - before.time)
        for row in range(len(now)):
            moments[row, k] = before[row] + share * (now[row] - before[row])
        moments[SAMPLES_ROW, k] = now.samples  # computed only for recorded moments
        tally["moments"] = k + 1
