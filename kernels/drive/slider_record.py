"""What is kept of a slider on its way."""

import math
from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel


class Moment(NamedTuple):
    """What is known where the force of a step acts, in the order of PULLED_TRACES (slider.py)."""

    mu: float  # in h/dx
    indentation: float  # in h
    normal: float  # in the units of the load
    friction: float  # in the units of the drive
    touching: float  # share of the surface
    samples: float  # in a patch of contact
    time: float  # in tau
    place: float  # of the slider, in dx
    speed: float  # in dx/tau
    force: float  # of the drive


class SliderRecord(NamedTuple):
    """What is kept of a slider's way."""

    times: np.ndarray  # at which its moments are kept, in tau, increasing
    kept: np.ndarray  # shape (10, times): those moments, field by field
    many: np.ndarray  # shape (2,): how many of them are, and how many events
    tally: np.ndarray  # shape (11,): of sticking and slipping, see ``follow_slips``
    sticks: float  # a stick lasts so long at least, in tau
    events: np.ndarray  # shape (2, room): times (tau) and kinds of the first events, NaN beyond


SAMPLES = Moment._fields.index("samples")
SINCE, LEAST, MOST, FASTEST, SLIPS, BEGAN, LATEST, STICKS, SLOW, LAST, SLIDES = range(11)
BEGINS, ENDS, REVERSES = range(3)  # kinds of events: a slip begins, it ends, the slider turns


@kernel
def add_to_tally(tally, now):
    """Add a moment to the tally, from a time on.

    tally : that time; the least and the greatest force of the drive; the highest speed; the
    number of slips, and when the first and the last of them began; then what ``follow_slips`` goes
    by: whether the slider has stuck, since when it has been slow, or inf, when it last was, and
    whether it slips.
    """
    if now.time >= tally[SINCE]:
        tally[LEAST], tally[MOST] = min(tally[LEAST], now.force), max(tally[MOST], now.force)
        tally[FASTEST] = max(tally[FASTEST], abs(now.speed))


@kernel
def follow_slips(record, before, now, driven):
    """Note and count what the slider does between two moments, by the speed of the drive.

    It is slow where it is less than half as fast as the drive, either way, and has stuck once it
    was slow for half a free swing of the mass, and for as long as the drive takes over a sample: a
    mass that swings about steady sliding is slow for less than that, and so is a line without one
    between the jumps of one slip. A slip begins where it is then twice as fast as the drive, and
    ends where the next stick begins.
    """
    tally = record.tally
    if before.speed * now.speed < 0.0:
        note_event(record, time_at_speed(before, now, 0.0), REVERSES)
    if driven == 0.0:
        return
    add_to_tally(tally, now)
    share = now.speed / driven
    if abs(share) < 0.5:
        if tally[SLOW] == np.inf:
            tally[SLOW] = time_at_speed(before, now, math.copysign(0.5 * driven, before.speed))
        tally[LAST] = now.time
        if now.time - tally[SLOW] >= record.sticks:
            tally[STICKS] = 1.0
            if tally[SLIDES] > 0.0:
                note_event(record, tally[SLOW], ENDS)
            tally[SLIDES] = 0.0
        return
    tally[SLOW] = np.inf
    if share > 2.0 and tally[STICKS] > 0.0:
        note_event(record, time_at_speed(before, now, 2.0 * driven), BEGINS)
        tally[STICKS], tally[SLIDES] = 0.0, 1.0
        if tally[LAST] >= tally[SINCE]:
            tally[BEGAN] = now.time if tally[SLIPS] == 0.0 else tally[BEGAN]
            tally[SLIPS], tally[LATEST] = tally[SLIPS] + 1.0, now.time


@kernel
def time_at_speed(before, now, speed):
    """Return when the slider was as fast as ``speed`` between two moments, at one of them else."""
    change = now.speed - before.speed
    share = (speed - before.speed) / change if change != 0.0 else 1.0
    return before.time + min(max(share, 0.0), 1.0) * (now.time - before.time)


@kernel
def note_event(record, time, kind):
    """Note an event, where there is room for it."""
    k = record.many[1]
    if k < record.events.shape[1]:
        record.events[0, k], record.events[1, k] = time, kind
        record.many[1] = k + 1


@kernel
def keep(record, before, now, driven):
    """Keep what lies between two moments at the times asked for; linear in between.

    driven : speed of the drive.
    """
    times, kept, count = record.times, record.kept, record.many
    follow_slips(record, before, now, driven)
    while count[0] < times.size and times[count[0]] <= now.time:
        share = 1.0
        if now.time > before.time:
            share = (times[count[0]] - before.time) / (now.time - before.time)
        for row in range(len(now)):
            kept[row, count[0]] = before[row] + share * (now[row] - before[row])
        kept[SAMPLES, count[0]] = now.samples  # counted where they are kept alone
        count[0] += 1
