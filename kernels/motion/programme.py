"""A programme of motion: legs one after the other, and the time steps that march through them.

Lengths along the line are in units of the element spacing dx, times in units of tau, speeds are
v tau / dx and positive towards +x. Positions of steps count samples, m to a spacing.
"""

from typing import NamedTuple

import numpy as np


class Slide(NamedTuple):
    """Slide a distance at one speed. A velocity jump is two of them."""

    speed: float  # signed, not zero
    distance: float  # > 0


class Hold(NamedTuple):
    """Stand still."""

    duration: float  # >= 0


class Ramp(NamedTuple):
    """Change the speed linearly in time."""

    first: float
    last: float
    duration: float  # > 0


class Oscillation(NamedTuple):
    """Move by X(t) = speed t + amplitude sin(2 pi frequency t) for whole cycles."""

    speed: float  # mean speed, may be zero
    amplitude: float  # > 0, of the superposed motion
    frequency: float  # > 0
    cycles: int  # >= 1


class Sampled(NamedTuple):
    """Follow a speed that is linear between samples in time."""

    times: tuple[float, ...]  # from 0, increasing
    speeds: tuple[float, ...]


Leg = Slide | Hold | Ramp | Oscillation | Sampled
Programme = tuple[Leg, ...]


class Steps(NamedTuple):
    """The time steps of a programme, all arrays of shape (S,)."""

    position: np.ndarray  # of the line at the end of each step, in samples, not wrapped
    dt: np.ndarray  # in tau
    leg: np.ndarray  # number of the leg that each belongs to, int64


def steps_of(
    programme: Programme, steps_per_spacing: int, position: float = 0.0, speed: float = 0.0
) -> Steps:
    """Return the steps of a programme.

    steps_per_spacing : m, samples (and steps of constant sliding) to a spacing.
    position, speed : of the line before the first leg, in samples and in dx/tau; the speed before
    a hold sets its first steps. Raises ValueError for a leg without meaning.
    """
    raise NotImplementedError
