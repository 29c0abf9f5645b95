"""What is kept of a slider on its way."""

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
    time: float  # in tau
    place: float  # of the slider, in dx
    speed: float  # in dx/tau
    force: float  # of the drive


class SliderRecord(NamedTuple):
    """What is kept of a slider's way."""

    times: np.ndarray  # at which its moments are kept, in tau, increasing
    kept: np.ndarray  # shape (9, times): those moments, field by field
    many: np.ndarray  # shape (1,): how many of them are
    tally: np.ndarray  # shape (9,): of sticking and slipping, see ``count_slips``
    ringing: float  # half a free swing of the mass on its spring, in tau: a stick lasts longer


SINCE, LEAST, MOST, FASTEST, SLIPS, BEGAN, LATEST, STICKS, SLOW = range(9)  # of the tally


@kernel
def count_slips(tally, now, driven, ringing):
    """Add a moment to the tally, from a time on.

    tally : that time; the least and the greatest force of the drive; the highest speed; the
    number of slips, when the first and the last of them began, whether the slider has stuck, and
    since when it has been slow, or inf. It is slow where it is less than half as fast as the drive,
    and has stuck once it was slow for the time ``ringing``: a mass that swings about steady sliding
    is slow for less than that. A slip begins where it is then twice as fast as the drive.
    """
    if now.time < tally[SINCE] or driven == 0.0:
        return
    tally[LEAST], tally[MOST] = min(tally[LEAST], now.force), max(tally[MOST], now.force)
    tally[FASTEST] = max(tally[FASTEST], abs(now.speed))
    share = now.speed / driven
    if abs(share) < 0.5:
        tally[SLOW] = min(tally[SLOW], now.time)
        if now.time - tally[SLOW] >= ringing:
            tally[STICKS] = 1.0
        return
    tally[SLOW] = np.inf
    if share > 2.0 and tally[STICKS] > 0.0:
        tally[STICKS] = 0.0
        tally[BEGAN] = now.time if tally[SLIPS] == 0.0 else tally[BEGAN]
        tally[SLIPS], tally[LATEST] = tally[SLIPS] + 1.0, now.time


@kernel
def keep(record, before, now, driven):
    """Keep what lies between two moments at the times asked for; linear in between.

    driven : speed of the drive.
    """
    times, kept, count = record.times, record.kept, record.many
    count_slips(record.tally, now, driven, record.ringing)
    while count[0] < times.size and times[count[0]] <= now.time:
        share = 1.0
        if now.time > before.time:
            share = (times[count[0]] - before.time) / (now.time - before.time)
        for row in range(len(now)):
            kept[row, count[0]] = before[row] + share * (now[row] - before[row])
        count[0] += 1
