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


class StepEnd(NamedTuple):
    """Positions, speeds and forces at the end of a step, where forces are balanced."""

    drive_place: float  # Y, in dx
    stretch: float  # of the spring, in dx
    pull: float  # force of spring and damper
    friction: float  # extrapolated to the end of the step
    inertia: float  # M d2X/dt2
    relative_speed: float  # of the drive over the slider, in dx/tau
    speed: float  # of the slider, in dx/tau


class DriveEnergies(NamedTuple):
    """Energies of a drive at the end of a step; work and losses are sums since the start."""

    drive_work: float
    friction_work: float
    spring_energy: float
    kinetic_energy: float
    damper_work: float  # dissipated by the damper
    step_work: float  # of inertia beyond the kinetic energy: an error of second order in the step


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
    end: StepEnd
    energies: DriveEnergies


class ForceBalance(NamedTuple):
    """Forces and motion in a step with known friction."""

    excess: float  # force of the drive minus friction and inertia, at the end of the step
    force: float  # of the drive, at friction_time
    friction_time: float  # time at which the friction acts, in tau
    place: float  # X at friction_time, in dx
    acceleration: float  # in dx/tau^2
    acceleration_time: float  # time to which the acceleration belongs, in tau
    end: StepEnd


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
    end_friction = friction + friction_change * (friction - motion.friction)
    acceleration = (speed - motion.speed) / (0.5 * (dt + motion.dt))
    acceleration_time = motion.time + 0.25 * (dt - motion.dt)
    change = acceleration - motion.acceleration
    change = change / (acceleration_time - motion.acceleration_time)
    end_speed = speed + 0.5 * dt * acceleration
    stretch, relative_speed = drive_place - motion.place - moved, drive_speed - end_speed
    pull = drive.stiffness * stretch + drive.damping * relative_speed
    inertia = drive.mass * (acceleration + change * (end - acceleration_time))
    at_end = StepEnd(drive_place, stretch, pull, end_friction, inertia, relative_speed, end_speed)
    excess = pull - end_friction - inertia
    acceleration_then = acceleration + change * (friction_time - acceleration_time)
    force = friction + drive.mass * acceleration_then + excess
    known = acceleration, acceleration_time, at_end
    return ForceBalance(excess, force, friction_time, place, *known)


@kernel
def energies_after(drive, before, start, end):
    """Return the DriveEnergies at the end of a step, by the trapezoidal rule.

    before : DriveEnergies at its start. start, end : StepEnd of its two ends. The work of the drive
    is that of friction, spring, damper and inertia, to the tolerance of the force balance.
    """
    driven, stretched = end.drive_place - start.drive_place, end.stretch - start.stretch
    moved = driven - stretched
    pull, friction = 0.5 * (start.pull + end.pull), 0.5 * (start.friction + end.friction)
    damping = 0.5 * drive.damping * (start.relative_speed + end.relative_speed)
    inertia, kinetic_energy = 0.5 * (start.inertia + end.inertia), 0.5 * drive.mass * end.speed**2
    change = kinetic_energy - 0.5 * drive.mass * start.speed**2
    return DriveEnergies(
        before.drive_work + pull * driven,
        before.friction_work + friction * moved,
        0.5 * drive.stiffness * end.stretch**2,
        kinetic_energy,
        before.damper_work + damping * stretched,
        before.step_work + inertia * moved - change,
    )
