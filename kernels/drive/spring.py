"""The drive of a slider: spring, damper and mass, and the balance of their forces.

The position of the drive is Y(t), that of the slider X(t):

    k (Y - X) + c (dY/dt - dX/dt) = F_x + M d2X/dt2,

where F_x is the friction (eq. 5), which acts against the motion. Lengths are in dx, times in tau,
forces in 4 G L h^2/dx, or in E* L h^2/dx if the elastomer is a half-space.
Source: F. Heslot et al., Phys. Rev. E 49, 4973 (1994), doi:10.1103/PhysRevE.49.4973, section II.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel


class Drive(NamedTuple):
    """Spring, damper and mass of a slider; hashable, because it is part of keys."""

    stiffness: float  # k > 0
    mass: float = 0.0  # M >= 0
    damping: float = 0.0  # c >= 0


class DriveLeg(NamedTuple):
    """Motion of the drive in one leg, with a piecewise linear velocity."""

    time: np.ndarray  # in tau, shape (knots,), increasing
    place: np.ndarray  # Y, in dx, shape (knots,)
    speed: np.ndarray  # in dx/tau, shape (knots,)


class SliderState(NamedTuple):
    """Motion of the slider at the end of a step."""

    time: float  # in tau
    place: float  # X, in dx
    dt: float  # duration of the step, in tau
    speed: float  # mean of the step, in dx/tau
    acceleration: float  # in dx/tau^2
    acceleration_time: float  # time to which the acceleration belongs, in tau
    friction_time: float  # time at which the friction of the step acts, in tau
    friction: float  # friction of the step


class ForceBalance(NamedTuple):
    """Forces and motion in a step with known friction."""

    excess: float  # force of the drive minus friction and inertia, at the end of the step
    force: float  # of the drive, at friction_time
    friction_time: float  # time at which the friction acts, in tau
    place: float  # X at friction_time, in dx
    acceleration: float  # in dx/tau^2
    acceleration_time: float  # time to which the acceleration belongs, in tau


@kernel
def drive_at(leg, t):
    """Return (Y, dY/dt) of the drive at a time of its leg."""
    i = min(max(np.searchsorted(leg.time, t, side="right") - 1, 0), leg.time.size - 2)
    since = t - leg.time[i]
    growth = (leg.speed[i + 1] - leg.speed[i]) / (leg.time[i + 1] - leg.time[i])
    speed = leg.speed[i] + growth * since
    return leg.place[i] + 0.5 * (leg.speed[i] + speed) * since, speed


@kernel
def force_balance(drive, leg, motion, moved, dt, lag, friction):
    """Return the ForceBalance of a step.

    motion : SliderState before the step. moved : distance of the step, in dx. dt : its duration.
    lag : time from the instant at which the friction acts to the end of the step, over dt.

    Forces are balanced at the end of the step, where the extension of the spring is known: a stiff
    spring then pulls the slider along without ringing. Friction acts earlier, by its lag; it is
    extrapolated linearly to the end of the step, from the step before and this one. Speed and
    acceleration are extrapolated in the same way. The speed of a step belongs to its middle, and
    the acceleration between two steps to the instant halfway between their middles. With equal
    steps this is Houbolt's method: it is of second order, and no oscillation grows.
    """
    share, end = 1.0 - lag, motion.time + dt
    friction_time, place = motion.time + share * dt, motion.place + share * moved
    speed = moved / dt
    drive_place, drive_speed = drive_at(leg, end)
    friction_change = lag * dt / (friction_time - motion.friction_time)
    friction_change = friction_change * (friction - motion.friction)
    acceleration = (speed - motion.speed) / (0.5 * (dt + motion.dt))
    acceleration_time = motion.time + 0.25 * (dt - motion.dt)
    change = acceleration - motion.acceleration
    change = change / (acceleration_time - motion.acceleration_time)
    relative_speed = drive_speed - speed - 0.5 * dt * acceleration
    pulled = drive.stiffness * (drive_place - motion.place - moved) + drive.damping * relative_speed
    inertia = drive.mass * (acceleration + change * (end - acceleration_time))
    excess = pulled - (friction + friction_change) - inertia
    acceleration_then = acceleration + change * (friction_time - acceleration_time)
    force = friction + drive.mass * acceleration_then + excess
    return ForceBalance(excess, force, friction_time, place, acceleration, acceleration_time)
