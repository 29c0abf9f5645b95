"""Programmes of motion: consecutive legs, and their time steps.

Lengths along the line are in units of the element spacing dx, times in units of tau. Speeds are
v tau / dx, positive towards +x. Positions of steps are in samples, m per spacing. Steps end at
whole samples wherever possible. They end at fractions of a sample (fourier.py) where a leg ends,
where the line turns, and in oscillations of a few samples.
"""

import math
from typing import NamedTuple

import numpy as np

from ..rheology.spectrum import MIN_DASHPOT_STEP
from .path import (
    Path,
    growing_steps,
    hold_step_ratio,
    min_cycle_steps,
    oscillation_path,
    piecewise_path,
    step_ends,
    steps_along,
)

FIRST_HOLD_STEP = 1e-6  # first step over the duration of a hold that follows rest


class Slide(NamedTuple):
    """Slide over a distance at one speed; a velocity jump is two such legs."""

    speed: float  # signed, not zero
    distance: float  # > 0


class Hold(NamedTuple):
    """Hold the line at rest."""

    duration: float  # >= 0, in tau


class Ramp(NamedTuple):
    """Change the speed linearly in time."""

    first: float
    last: float
    duration: float  # > 0, in tau


class Oscillation(NamedTuple):
    """Move by X(t) = speed t + amplitude sin(2 pi frequency t) for whole cycles."""

    speed: float  # mean speed, may be zero
    amplitude: float  # > 0, of the superposed motion
    frequency: float  # > 0
    cycles: int  # >= 1


class Sampled(NamedTuple):
    """Follow a speed that is linear between given times."""

    times: tuple[float, ...]  # in tau, from 0, increasing
    speeds: tuple[float, ...]  # at these times, in dx/tau


Leg = Slide | Hold | Ramp | Oscillation | Sampled
Programme = tuple[Leg, ...]


class Steps(NamedTuple):
    """The time steps of a programme; all arrays have shape (S,)."""

    position: np.ndarray  # of the line at the end of each step, in samples, not wrapped
    dt: np.ndarray  # in tau
    leg: np.ndarray  # index of the leg of each step, int64


def steps_of(
    programme: Programme,
    steps_per_spacing: int,
    position: float = 0.0,
    speed: float = 0.0,
    shortest: float = MIN_DASHPOT_STEP,
) -> Steps:
    """Return the steps of a programme.

    steps_per_spacing : m, samples (and steps at constant speed) per spacing. It also sets the
    resolution of holds, ramps and oscillations.
    position, speed : of the line before the first leg, in samples and in dx/tau. The speed before
    a hold sets its first step. shortest : minimum step in tau, set by the rounding of forces.

    Raises ValueError for an invalid leg, and for steps that are too short.
    """
    places, times, legs = [np.empty(0)], [np.empty(0)], [np.empty(0, np.int64)]
    for number, leg in enumerate(programme):
        check_leg(leg)
        place, dt = _leg_steps(leg, steps_per_spacing, position, speed, shortest)
        if place.size:
            if dt.min() < shortest:
                raise ValueError(
                    f"{leg}: steps of {dt.min():g} tau are lost in rounding; make it longer"
                )
            position, speed = float(place[-1]), last_speed(leg)
        places.append(place)
        times.append(dt)
        legs.append(np.full(place.size, number))
    return Steps(np.concatenate(places), np.concatenate(times), np.concatenate(legs))


def last_speed(leg: Leg) -> float:
    """Return the speed at the end of a leg, in dx/tau."""
    if isinstance(leg, Slide):
        return leg.speed
    if isinstance(leg, Hold):
        return 0.0
    if isinstance(leg, Ramp):
        return leg.last
    if isinstance(leg, Sampled):
        return leg.speeds[-1]
    return leg.speed + 2.0 * math.pi * leg.frequency * leg.amplitude


def speed_at_start(programme: Programme) -> float:
    """Return the initial speed of a programme, in dx/tau; 0 if it begins with a hold.

    For an oscillation it is the mean speed, which is that of the steady state before it.
    """
    leg = programme[0]
    if isinstance(leg, Slide | Oscillation):
        return leg.speed
    if isinstance(leg, Ramp):
        return leg.first
    return leg.speeds[0] if isinstance(leg, Sampled) else 0.0


def leg_duration(leg: Leg) -> float:
    """Return the duration of a leg, in tau."""
    match leg:
        case Slide():
            return leg.distance / abs(leg.speed)
        case Oscillation():
            return leg.cycles / leg.frequency
        case Sampled():
            return leg.times[-1]
        case _:
            return leg.duration


def check_leg(leg: Leg) -> None:
    """Raise ValueError for an invalid leg."""
    numbers = np.concatenate([np.atleast_1d(np.asarray(value, float)) for value in leg])
    if not np.isfinite(numbers).all():
        raise ValueError(f"{leg}: every number must be finite")
    if isinstance(leg, Slide):
        sound = leg.speed != 0.0 and leg.distance > 0.0
    elif isinstance(leg, Hold):
        sound = leg.duration >= 0.0
    elif isinstance(leg, Ramp):
        sound = leg.duration > 0.0
    elif isinstance(leg, Oscillation):
        sound = leg.amplitude > 0.0 and leg.frequency > 0.0 and leg.cycles >= 1
        sound = sound and leg.cycles == int(leg.cycles)
    else:
        times = np.asarray(leg.times)
        sound = times.size > 1 and times.size == len(leg.speeds) and times[0] == 0.0
        sound = bool(sound and np.all(np.diff(times) > 0.0))
    if not sound:
        raise ValueError(f"{leg}: a leg like this has no meaning")


def _leg_steps(
    leg: Leg, m: int, position: float, speed: float, shortest: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return (positions, dt) of one leg."""
    if isinstance(leg, Slide):
        end = position + math.copysign(leg.distance * m, leg.speed)
        place = np.concatenate([[position], step_ends(position, end)])
        return place[1:], np.abs(np.diff(place)) / (m * abs(leg.speed))
    if isinstance(leg, Hold):
        first = first_hold_step(leg, m, speed, shortest)
        dt = growing_steps(leg.duration, first, hold_step_ratio(m))
        return np.full(dt.size, position), dt
    if isinstance(leg, Oscillation) and has_equal_steps(leg, m):
        return _equal_steps(leg, m, position)
    return steps_along(path_of(leg, m), m, position)


def first_hold_step(leg: Hold, m: int, speed: float, shortest: float) -> float:
    """Return the upper bound of the first step of a hold, in tau; speed : before the hold."""
    return max(0.25 / (m * abs(speed)) if speed else FIRST_HOLD_STEP * leg.duration, shortest)


def has_equal_steps(leg: Oscillation, m: int) -> bool:
    """Return whether min_cycle_steps equal steps per cycle cover at most one sample each."""
    fastest = abs(leg.speed) + 2.0 * math.pi * leg.frequency * leg.amplitude
    return fastest * m <= leg.frequency * min_cycle_steps(m)


def path_of(leg: Leg, m: int) -> Path:
    """Return the path of a ramp, an oscillation or a sampled motion."""
    if isinstance(leg, Oscillation):
        return oscillation_path(leg.speed, leg.amplitude, leg.frequency, leg.cycles, m)
    if isinstance(leg, Ramp):
        return piecewise_path((0.0, leg.duration), (leg.first, leg.last), m)
    assert isinstance(leg, Sampled)
    return piecewise_path(leg.times, leg.speeds, m)


def _equal_steps(leg: Oscillation, m: int, position: float) -> tuple[np.ndarray, np.ndarray]:
    """Return (positions, dt) of an oscillation, with min_cycle_steps equal steps per cycle."""
    count = min_cycle_steps(m)
    number = np.arange(1, count * leg.cycles + 1)
    phase = 2.0 * math.pi * (number % count) / count
    dt = 1.0 / (leg.frequency * count)
    place = position + m * (leg.speed * dt * number + leg.amplitude * np.sin(phase))
    return place, np.full(number.size, dt)
