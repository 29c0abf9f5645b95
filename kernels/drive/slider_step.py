"""Steps of a slider: either the distance is given and the time unknown, or the reverse.

A sliding step ends at a sample. Its duration is the unknown, found from the balance of forces at
its end. If this duration would far exceed the previous one, the slider sticks. The steps then have
given durations that grow by a constant factor, as in a hold, and the unknown is the distance by
which the slider creeps. A slider that accelerates faster than the elastomer responds takes steps of
the duration ``min_step_time``, which keeps forces far above rounding.

These functions are compiled into one kernel for a line, and run as plain Python for a map.
"""

import math
from typing import Any, NamedTuple

import numpy as np

from ..body.step import Forces, Move, accept, attempt, forces, law_in_step, patch_width
from ..compile.jit import dispatch_on_type, jitable, kernel
from ..motion.path import MIN_PARTIAL_STEP, SNAP_TOLERANCE
from ..root_search import new_secant_search, next_secant_guess
from .slider_record import Moment, SliderRecord, count_step, next_time_is_due, record_between
from .spring import (
    Drive,
    DriveLeg,
    ForceBalance,
    SliderState,
    drive_at,
    energies_after,
    force_balance,
)

FORCE_TOLERANCE = 1e-5  # of the residual force, over load times rms slope
LOG_TIME_ROUNDING = 1e-13  # smaller differences of the logarithm of a time are rounding
PLACE_ROUNDING = 1e-12  # in samples
FIRST_LOG_TIME_STEP = 0.5  # first step of a search, in the logarithm of a time
FIRST_CREEP_STEP = 0.1  # first step of a search, in samples
MAX_STEP_GROWTH = 1.5  # the slider sticks if a step would be longer than this times the last one
MAX_STEPS_TO_SAMPLE = 2.0  # maximum distance of a sliding step, over speed times ``pace``
MAX_SPEED_RATIO = 1.4  # largest factor between expected and last speed, up or down
MIN_STEP_SHARE = 1e-3  # over the last step: a shorter rest of a leg is left to the next leg

# Slopes with which the next search starts, and a counter: one record, changed in place.
SEARCH_MEMORY = np.dtype(
    [
        ("time_slope", np.float64),  # d(excess force)/d(log of the step time), or 0
        ("creep_slope", np.float64),  # -d(excess force)/d(distance in samples), or 0
        ("tries", np.int64),  # total number of attempted steps
    ]
)


class PulledSlider(NamedTuple):
    """A body, its drive and the constants of its steps."""

    body: Any  # elements under the slider (body/step.py)
    steps_per_spacing: int
    drive: Drive
    min_step_time: float  # minimum duration of a step, in tau
    force_tolerance: float  # of the residual force
    hold_growth: float  # ratio of successive step times while the slider sticks
    record: SliderRecord
    memory: np.ndarray  # SEARCH_MEMORY, shape (1,)


class SliderProgress(NamedTuple):
    """State of a slider between two steps."""

    state: Any  # of the body
    motion: SliderState
    moment: Moment
    pace: float  # reference duration for the next step, in tau


class Trip(NamedTuple):
    """Motion of the slider in a step."""

    before: float  # position, in samples
    after: float
    moved: float  # distance, in dx


class BalancedStep(NamedTuple):
    """Result of an attempted step: state, duration and forces."""

    state: Any  # of the body, after the attempted step
    law: Any  # of the elastomer in the step
    dt: float  # in tau; NaN for a step that would be too long
    balance: ForceBalance
    acting: Forces


@jitable
def follow_leg(pulled: PulledSlider, leg: DriveLeg, progress: SliderProgress) -> SliderProgress:
    """Follow the drive through a leg; the last step ends with the leg."""
    end, m = leg.time[-1], pulled.steps_per_spacing
    while end - progress.motion.time > MIN_STEP_SHARE * progress.motion.dt:
        motion, pace, left = progress.motion, progress.pace, end - progress.motion.time
        place = m * motion.place
        if abs(place - np.floor(place + 0.5)) <= SNAP_TOLERANCE * max(1.0, abs(place)):
            place = np.floor(place + 0.5)
        edges = np.ceil(place - MIN_PARTIAL_STEP) - 1.0, np.floor(place + MIN_PARTIAL_STEP) + 1.0
        sample = edges[1] if motion.speed > 0.0 else edges[0]
        moved = (sample - place) / m
        if abs(moved) <= MAX_STEPS_TO_SAMPLE * abs(motion.speed) * pace:
            guess = moved / expected_speed(motion, motion.dt)
            longest = min(MAX_STEP_GROWTH * pace, left)
            trip, state = Trip(place, sample, moved), progress.state
            step = slide_step(pulled, state, leg, motion, trip, longest, guess)
            if not math.isnan(step.dt):
                progress = accept_step(pulled, leg, progress, moved, step)
                continue
            progress = SliderProgress(step.state, motion, progress.moment, pace)
        dt = min(pulled.hold_growth * pace, left)
        progress = advance_slowly(pulled, leg, progress, place, edges, dt)
    return progress


@kernel
def expected_speed(motion, dt):
    """Return the speed of the next step, extrapolated from the last ones.

    MAX_SPEED_RATIO limits the change of speed, as forces may balance at several places ahead.
    """
    expected, speed = motion.speed + 0.5 * motion.acceleration * (dt + motion.dt), abs(motion.speed)
    sign = 1.0 if motion.speed > 0.0 else -1.0
    return sign * min(max(sign * expected, speed / MAX_SPEED_RATIO), speed * MAX_SPEED_RATIO)


@jitable
def attempt_step(pulled, state, leg, motion, trip, dt):
    """Attempt a Trip in a time dt; return the BalancedStep."""
    law, step = law_in_step(pulled.body, state, dt), Move(trip.before, trip.after, 0, False, dt)
    state = attempt(pulled.body, state, law, step)
    acting = forces(pulled.body, state, law, step)
    pulled.memory[0]["tries"] += 1
    balance = force_balance(pulled.drive, leg, motion, trip.moved, dt, law.lag, acting.friction)
    return BalancedStep(state, law, dt, balance, acting)


@jitable
def slide_step(pulled, state, leg, motion, trip, longest, guess):
    """Find the duration of a Trip, from a guess; return the BalancedStep.

    Its dt is NaN if it would exceed ``longest``.
    """
    sign, memory = 1.0 if trip.moved > 0.0 else -1.0, pulled.memory[0]
    low, high = math.log(pulled.min_step_time), math.log(max(longest, pulled.min_step_time))
    x = min(max(math.log(guess), low), high)
    secants = new_secant_search(x, FIRST_LOG_TIME_STEP, memory["time_slope"])
    while True:
        step = attempt_step(pulled, state, leg, motion, trip, math.exp(x))
        excess = sign * step.balance.excess
        secants = next_secant_guess(secants, x, excess, pulled.force_tolerance, LOG_TIME_ROUNDING)
        late = x >= high and (excess < 0.0 or high <= low)
        if late or secants.search.ended or (x <= low and excess > 0.0):
            memory["time_slope"] = secants.slope
            dt = np.nan if late else step.dt
            return BalancedStep(step.state, step.law, dt, step.balance, step.acting)
        state, x = step.state, min(max(secants.search.x, low), high)


@dispatch_on_type
def advance_slowly(pulled, leg, progress, place, edges, dt):
    """Return the SliderProgress after a time dt, or at the next sample in a shorter time."""


@advance_slowly.register(PulledSlider)
def _advance_slowly(pulled, leg, progress, place, edges, dt):
    return creep(pulled, leg, progress, place, edges, dt)


@jitable
def creep(pulled, leg, progress, place, edges, dt):
    """Advance to the balance of forces after a time dt, or to the next sample in a shorter time."""
    state, motion, m = progress.state, progress.motion, pulled.steps_per_spacing
    low, high, memory = edges[0] - place, edges[1] - place, pulled.memory[0]
    x = min(max(m * expected_speed(motion, dt) * dt, low), high)
    secants = new_secant_search(x, FIRST_CREEP_STEP, memory["creep_slope"])
    while True:
        trip = Trip(place, place + x, x / m)
        step = attempt_step(pulled, state, leg, motion, trip, dt)
        excess = step.balance.excess
        secants = next_secant_guess(secants, x, -excess, pulled.force_tolerance, PLACE_ROUNDING)
        if (x >= high and excess > 0.0) or (x <= low and excess < 0.0):
            if dt > pulled.min_step_time:
                sooner = slide_step(pulled, step.state, leg, motion, trip, dt, 0.9 * dt)
                if not math.isnan(sooner.dt):
                    step = sooner
            break
        if secants.search.ended:
            memory["creep_slope"] = secants.slope
            break
        state, x = step.state, min(max(secants.search.x, low), high)
    return accept_step(pulled, leg, progress, trip.moved, step)


@jitable
def accept_step(pulled, leg, progress, moved, step):
    """Accept and record a step; return the SliderProgress after it."""
    motion, balance, dt, acting = progress.motion, step.balance, step.dt, step.acting
    state = accept(pulled.body, step.state, step.law)
    d = state.d + step.law.lag * (state.old_d - state.d)
    samples = progress.moment.samples
    count_step(pulled.record, balance.friction_time)
    ends_leg = motion.time + dt > leg.time[-1] - MIN_STEP_SHARE * dt
    if next_time_is_due(pulled.record, balance.friction_time) or ends_leg:
        samples = patch_width(pulled.body, state)
    energies = energies_after(pulled.drive, motion.energies, motion.end, balance.end)
    driven, rubbed, spring, kinetic, damped, error = energies
    moment = Moment(
        acting.mu,
        d,
        acting.normal,
        acting.friction,
        acting.contact_fraction,
        samples,
        balance.friction_time,
        balance.place,
        moved / dt,
        balance.force,
        driven,
        rubbed,
        spring,
        kinetic,
        damped,
        error,
    )
    record_between(pulled.record, progress.moment, moment, drive_at(leg, moment.time)[1])
    end, place = motion.time + dt, motion.place + moved
    known = balance.acceleration, balance.acceleration_time, balance.friction_time
    ends = balance.end, energies
    motion = SliderState(end, place, dt, moved / dt, *known, acting.friction, *ends)
    # The duration of a step that ends at a sample does not become the pace, which would amplify
    # rounding from sample to sample.
    pace = max(dt, pulled.hold_growth * progress.pace)
    samples_moved = pulled.steps_per_spacing * abs(moved)
    if dt < pace * samples_moved:
        pace = dt / samples_moved
    return SliderProgress(state, motion, moment, pace)
