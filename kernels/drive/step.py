"""The steps of a slider: to the next sample, or less far.

A step of sliding ends at a sample, and its time is the unknown: when the slider arrives the forces
are balanced. Where that would last much longer than the step before, it sticks: its steps are those
of a hold, by a factor longer each time, and how far it creeps in one is what balances the forces. A
slider that comes free quicker than anything in the elastomer answers goes on in the shortest time
that doubles tell.

All of it is one kernel for a line, and plain Python for a map.
"""

import math
from typing import Any, NamedTuple

import numpy as np

from ..compile.jit import jitable, kernel
from ..motion.path import MIN_PARTIAL_STEP, SNAP_TOLERANCE
from .posed_line import Places
from .rig import accept, attempt, patch_width
from .search import SLOPE, narrow_enough, new_search, next_guess
from .slider_record import Moment, SliderRecord, keep
from .spring import Course, Drive, Pull, SliderState, course_at, pull_of

TOLERANCE = 1e-5  # of the force that is left over, relative to load times rms slope
LEAST_LOG = 1e-13  # of the logarithm of a time: smaller is rounding
LEAST_PLACE = 1e-12  # in samples: less is rounding
FIRST = 0.5  # of the first step of a search, in the logarithm of a time
FIRST_CREEP = 0.1  # the same in samples
SLOWER = 1.5  # a step lasts so many times the one before at most, or the slider sticks
SOON = 2.0  # times the step before a sample may be off, at the speed of that, to be tried
CHANGE = 1.4  # of the speed from one step to the next, that is expected at most
REST = 1e-3  # of a step: what is left of a leg is left to the next one


class Pulled(NamedTuple):
    """What is pulled, and by what."""

    rig: Any  # that attempt and accept know (rig.py)
    steps_per_spacing: int
    drive: Drive
    shortest: float  # time of a step, in tau
    left: float  # of the force, at most
    growth: float  # of the time of a step while the slider sticks
    record: SliderRecord
    slopes: np.ndarray  # shape (2,): of the force left over with the logarithm of a time, and with
    # the place in samples, as last known, or 0
    tries: np.ndarray  # shape (1,): of steps


RISE, FALL = range(2)  # of the slopes


class Going(NamedTuple):
    """A slider on its way."""

    motion: SliderState
    moment: Moment
    pace: float  # of its steps, in tau


class BalancedStep(NamedTuple):
    """A step at whose end the forces are balanced, as it was tried last."""

    dt: float  # NaN where there is none
    pull: Pull
    friction: float


@jitable
def follow_leg(pulled: Pulled, course: Course, going: Going) -> Going:
    """Follow the drive through a leg; the last step ends with it."""
    end, m = course.time[-1], pulled.steps_per_spacing
    while end - going.motion.time > REST * going.motion.dt:
        motion, pace, left = going.motion, going.pace, end - going.motion.time
        place = m * motion.place
        if abs(place - np.floor(place + 0.5)) <= SNAP_TOLERANCE * max(1.0, abs(place)):
            place = np.floor(place + 0.5)
        edges = np.ceil(place - MIN_PARTIAL_STEP) - 1.0, np.floor(place + MIN_PARTIAL_STEP) + 1.0
        ahead = edges[1] if motion.speed > 0.0 else edges[0]
        moved = (ahead - place) / m
        if abs(moved) <= SOON * abs(motion.speed) * pace:
            guess = moved / expected_speed(motion, motion.dt)
            longest = min(SLOWER * pace, left)
            found = time_of(pulled, Places(place, ahead), course, motion, longest, guess)
            if not math.isnan(found.dt):
                going = go(pulled, course, going, moved, found)
                continue
        going = creep(pulled, course, going, place, edges, min(pulled.growth * pace, left))
    return going


@kernel
def expected_speed(motion, dt):
    """Return the speed of a step that comes, if it goes on changing as it has.

    Not far from what it was: behind the place where forces are balanced next there may be others.
    """
    expected, speed = motion.speed + 0.5 * motion.rate * (dt + motion.dt), abs(motion.speed)
    way = 1.0 if motion.speed > 0.0 else -1.0
    return way * min(max(way * expected, speed / CHANGE), speed * CHANGE)


@jitable
def time_of(pulled, places, course, motion, longest, guess):
    """Find the time of a step between two places, from a guess.

    It is NaN where that would be longer than ``longest``. The rig keeps the step that was tried
    last.
    """
    moved = (places.after - places.before) / pulled.steps_per_spacing
    way = 1.0 if moved > 0.0 else -1.0
    notes = new_search(pulled.slopes[RISE], FIRST)
    low, high = math.log(pulled.shortest), math.log(max(longest, pulled.shortest))
    x = min(max(math.log(guess), low), high)
    while True:
        dt = math.exp(x)
        friction, lag = attempt(pulled.rig, places, dt)
        pull = pull_of(pulled.drive, course, motion, moved, dt, lag, friction)
        excess = way * pull.excess
        pulled.tries[0] += 1
        ahead = next_guess(notes, x, excess)
        late = x >= high and (excess < 0.0 or high <= low)
        near = abs(excess) <= pulled.left or narrow_enough(notes, LEAST_LOG)
        if late or near or (x <= low and excess > 0.0):
            pulled.slopes[RISE] = notes[SLOPE]
            return BalancedStep(np.nan if late else dt, pull, friction)
        x = min(max(ahead, low), high)


@jitable
def creep(pulled, course, going, place, edges, dt):
    """Go as far as the slider goes in a time dt, between two samples; or when it is there."""
    motion, m = going.motion, pulled.steps_per_spacing
    low, high = edges[0] - place, edges[1] - place
    notes = new_search(pulled.slopes[FALL], FIRST_CREEP)
    x = min(max(m * expected_speed(motion, dt) * dt, low), high)
    while True:
        places = Places(place, place + x)
        friction, lag = attempt(pulled.rig, places, dt)
        pull = pull_of(pulled.drive, course, motion, x / m, dt, lag, friction)
        found = BalancedStep(dt, pull, friction)
        pulled.tries[0] += 1
        ahead = next_guess(notes, x, -pull.excess)
        if (x >= high and pull.excess > 0.0) or (x <= low and pull.excess < 0.0):
            if dt > pulled.shortest:
                sooner = time_of(pulled, places, course, motion, dt, 0.9 * dt)
                found = found if math.isnan(sooner.dt) else sooner
            break
        if abs(pull.excess) <= pulled.left or narrow_enough(notes, LEAST_PLACE):
            pulled.slopes[FALL] = notes[SLOPE]
            break
        x = min(max(ahead, low), high)
    return go(pulled, course, going, x / m, found)


@jitable
def go(pulled, course, going, moved, found):
    """Take the step that was tried last."""
    motion, pull, dt = going.motion, found.pull, found.dt
    normal, d, touching = accept(pulled.rig, dt)
    mu = found.friction / normal if normal > 0.0 else np.nan
    record, samples = pulled.record, going.moment.samples
    due = record.many[0] < record.times.size and record.times[record.many[0]] <= pull.felt
    if due or motion.time + dt > course.time[-1] - REST * dt:
        samples = patch_width(pulled.rig)
    forces = mu, d, normal, found.friction, touching, samples
    moment = Moment(*forces, pull.felt, pull.place, moved / dt, pull.force)
    keep(pulled.record, going.moment, moment, course_at(course, moment.time)[1])
    end, place = motion.time + dt, motion.place + moved
    known = pull.rate, pull.rated, pull.felt
    motion = SliderState(end, place, dt, moved / dt, *known, found.friction)
    return Going(motion, moment, dt)
