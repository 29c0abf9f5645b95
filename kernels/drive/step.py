"""The time of a step: a slider goes to the next sample, and when it arrives balances the forces.

Where that would last much longer than the step before, it sticks (slider.py). A slider that comes
free quicker than anything in the elastomer answers goes on in the shortest time that doubles tell.
"""

import math
from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel
from .rig import Pose, accept, attempt
from .search import SLOPE, narrow_enough, new_search, next_guess
from .spring import SliderState, course_at, pull_of

TOLERANCE = 1e-5  # of the force that is left over, relative to load times rms slope
LEAST_LOG = 1e-13  # of the logarithm of a time: smaller is rounding
FIRST = 0.5  # of the first step of a search, in that logarithm
SLOWER = 1.5  # a step lasts so many times the one before at most, or the slider sticks
REST = 1e-3  # of a step: what is left of a leg is left to the next one


class Limits(NamedTuple):
    """Between what the time of a step is looked for, and how closely."""

    shortest: float  # in tau
    longest: float  # in tau
    left: float  # of the force, at most


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


@kernel
def time_of(rig, pose, drive, course, motion, moved, limits, guess, slope):
    """Return (dt, Pull, friction, slope, tries) of a step by ``moved``, in dx.

    dt : NaN where it would last longer than the limit. guess : of it. slope : of the force left
    over, with the logarithm of the time, or 0. The rig keeps the step that was tried last.
    """
    way = 1.0 if moved > 0.0 else -1.0
    notes = new_search(slope, FIRST)
    shortest, longest = math.log(limits.shortest), math.log(limits.longest)
    x = min(max(math.log(guess), shortest), longest)
    tries = 0
    while True:
        dt = math.exp(x)
        friction, lag = attempt(rig, pose, dt)
        pull = pull_of(drive, course, motion, moved, dt, lag, friction)
        excess = way * pull.excess
        tries += 1
        ahead = next_guess(notes, x, excess)
        if x >= longest and excess < 0.0:
            dt = np.nan
        elif (
            abs(excess) > limits.left
            and (x > shortest or excess < 0.0)
            and not narrow_enough(notes, LEAST_LOG)
        ):
            x = min(max(ahead, shortest), longest)
            continue
        return dt, pull, friction, notes[SLOPE], tries


@kernel
def taken(rig, motion, moved, dt, pull, friction):
    """Take the step that was tried last; return (SliderState, Moment)."""
    normal, d, touching = accept(rig, dt)
    speed = moved / dt
    mu = friction / normal if normal > 0.0 else np.nan
    moment = Moment(mu, d, normal, friction, touching, pull.felt, pull.place, speed, pull.force)
    end, place = motion.time + dt, motion.place + moved
    known = pull.rate, pull.rated, pull.felt
    return SliderState(end, place, dt, speed, *known, friction), moment


class SliderRecord(NamedTuple):
    """What is kept of a slider's way."""

    times: np.ndarray  # at which its moments are kept, in tau, increasing
    kept: np.ndarray  # shape (9, times): those moments, field by field
    tally: np.ndarray  # shape (8,): of sticking and slipping, see ``count_slips``


SINCE, LEAST, MOST, FASTEST, SLIPS, BEGAN, LATEST, STICKS = range(8)  # of the tally


@kernel
def count_slips(tally, now, driven):
    """Add a moment to the tally, from a time on.

    tally : that time; the least and the greatest force of the drive; the highest speed; the
    number of slips, when the first and the last of them began, and whether the slider sticks. A
    slip begins where it becomes twice as fast as the drive, after it was half as fast at most.
    """
    if now.time < tally[SINCE] or driven == 0.0:
        return
    tally[LEAST], tally[MOST] = min(tally[LEAST], now.force), max(tally[MOST], now.force)
    tally[FASTEST] = max(tally[FASTEST], abs(now.speed))
    share = now.speed / driven
    if share < 0.5:
        tally[STICKS] = 1.0
    elif share > 2.0 and tally[STICKS] > 0.0:
        tally[STICKS] = 0.0
        tally[BEGAN] = now.time if tally[SLIPS] == 0.0 else tally[BEGAN]
        tally[SLIPS], tally[LATEST] = tally[SLIPS] + 1.0, now.time


@kernel
def keep(record, k, before, now, driven):
    """Keep what lies between two moments at the times asked for; return the number kept.

    k : the number kept before. driven : speed of the drive. Linear in between.
    """
    times, kept = record.times, record.kept
    count_slips(record.tally, now, driven)
    while k < times.size and times[k] <= now.time:
        share = 1.0
        if now.time > before.time:
            share = (times[k] - before.time) / (now.time - before.time)
        for row in range(len(now)):
            kept[row, k] = before[row] + share * (now[row] - before[row])
        k += 1
    return k


@kernel
def slide_by_samples(
    rig, z, slope, m, sample, drive, course, motion, moment, limits, pace, rise, record, k
):
    """Take whole samples towards where the slider goes, until it sticks or the leg ends.

    z, slope : two periods of the line, shape (2 n,), in h and h/dx, as place zero has them; m
    samples to a spacing. sample : at which the slider is. limits : its longest time is the end of
    the leg. pace : of the first step, in the place of the time of the one before. rise : as the
    slope of time_of. record, k : of keep.
    Returns (SliderState, Moment, rise, k, tries).
    """
    n = rig.p.size
    way = 1 if motion.speed > 0.0 else -1
    moved = way / m
    all_tries = 0
    guess = pace
    while True:
        begin, end = -sample % n, -(sample + way) % n
        pose = Pose(z[end : end + n], slope[begin : begin + n], slope[end : end + n])
        left = limits.longest - motion.time
        longest = min(SLOWER * pace, left)
        if longest <= limits.shortest or left <= REST * motion.dt:
            return motion, moment, rise, k, all_tries
        within = Limits(limits.shortest, longest, limits.left)
        dt, pull, friction, rise, tries = time_of(
            rig, pose, drive, course, motion, moved, within, guess, rise
        )
        all_tries += tries
        if np.isnan(dt):
            return motion, moment, rise, k, all_tries
        guess = dt * min(max(dt / pace, 0.7), 1.4)
        pace = dt
        motion, now = taken(rig, motion, moved, dt, pull, friction)
        k = keep(record, k, moment, now, course_at(course, now.time)[1])
        moment = now
        sample += way
