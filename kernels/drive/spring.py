"""The drive: a spring, a damper and the mass of the slider, and the force that they leave over.

The drive moves as Y(t), the slider as X(t):

    k (Y - X) + c (dY/dt - dX/dt) = F_x + M d2X/dt2,

F_x being the friction (eq. 5), which acts against the motion. Lengths are in dx, times in tau,
forces in 4 G L h^2/dx, or in E* L h^2/dx where the elastomer is a half-space.
Source: F. Heslot et al., Phys. Rev. E 49, 4973 (1994), doi:10.1103/PhysRevE.49.4973, section II.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel


class Drive(NamedTuple):
    """What the slider is pulled through; hashable, for it is part of keys."""

    stiffness: float  # k > 0
    mass: float = 0.0  # M >= 0
    damping: float = 0.0  # c >= 0


class Course(NamedTuple):
    """How the drive moves in one leg: its velocity is linear between times."""

    time: np.ndarray  # in tau, shape (knots,), increasing
    place: np.ndarray  # Y, in dx, shape (knots,)
    speed: np.ndarray  # in dx/tau, shape (knots,)


class SliderState(NamedTuple):
    """Where the slider is at the end of a step, and how it came there."""

    time: float  # in tau
    place: float  # X, in dx
    dt: float  # of the step, in tau
    speed: float  # in the step, in dx/tau
    rate: float  # acceleration, in dx/tau^2
    rated: float  # time to which that belongs, in tau
    felt: float  # time at which the friction of the step acts
    friction: float  # of the step


class Pull(NamedTuple):
    """What is known of a step beside its friction."""

    excess: float  # of the drive's force over friction and inertia, at the end of the step
    force: float  # of the drive, where the friction acts
    felt: float  # time at which that is, in tau
    place: float  # X there, in dx
    rate: float  # acceleration, in dx/tau^2
    rated: float  # time to which that belongs, in tau


@kernel
def course_at(course, t):
    """Return (Y, dY/dt) of the drive at a time of its leg."""
    i = min(max(np.searchsorted(course.time, t, side="right") - 1, 0), course.time.size - 2)
    since = t - course.time[i]
    growth = (course.speed[i + 1] - course.speed[i]) / (course.time[i + 1] - course.time[i])
    speed = course.speed[i] + growth * since
    return course.place[i] + 0.5 * (course.speed[i] + speed) * since, speed


@kernel
def pull_of(drive, course, motion, moved, dt, lag, friction):
    """Return the Pull of a step.

    motion : before it. moved : by it, in dx, in the time dt. lag : of the friction, before the end
    of the step, as a share of it (rheology/law.py).

    Forces are balanced at the end of a step, where the spring is known, so that a stiff one takes
    the slider along and nothing rings. Friction is known earlier, at its lag, and followed to the
    end as it has changed since the step before. So are speed and acceleration: speeds belong to
    the middles of steps, their difference quotient to the middle between those. With equal steps
    that is Houbolt's method, of second order, under which no oscillation grows.
    """
    share, end = 1.0 - lag, motion.time + dt
    felt, place, speed = motion.time + share * dt, motion.place + share * moved, moved / dt
    at, driven = course_at(course, end)
    ahead = lag * dt / (felt - motion.felt) * (friction - motion.friction)
    rate = (speed - motion.speed) / (0.5 * (dt + motion.dt))
    rated = motion.time + 0.25 * (dt - motion.dt)
    change = (rate - motion.rate) / (rated - motion.rated)
    faster = driven - speed - 0.5 * dt * rate
    pulled = drive.stiffness * (at - motion.place - moved) + drive.damping * faster
    inertia = drive.mass * (rate + change * (end - rated))
    excess = pulled - (friction + ahead) - inertia
    force = friction + drive.mass * (rate + change * (felt - rated)) + excess
    return Pull(excess, force, felt, place, rate, rated)
