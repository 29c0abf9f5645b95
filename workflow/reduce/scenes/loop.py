"""Loops of the friction in an oscillation: their work, and the response of the fundamental.

mu(t) = ... + mu' sin(2 pi f t) + mu'' cos(2 pi f t), in phase with the superposed displacement
A sin(2 pi f t) and with its velocity.
"""

import math
from typing import NamedTuple

import numpy as np

from ....kernels import Leg, Oscillation, Programme, Sampled, Slide


class Loop(NamedTuple):
    """Of the last cycle: of the mean trace, then of its replicates; each shape (replicates,)."""

    loop_work: np.ndarray  # in 4 G L h^2
    mu_in_phase: np.ndarray
    mu_quadrature: np.ndarray


def duration(leg: Leg) -> float:
    """Return how long a leg takes, in tau."""
    match leg:
        case Slide():
            return leg.distance / abs(leg.speed)
        case Oscillation():
            return leg.cycles / leg.frequency
        case Sampled():
            return leg.times[-1]
        case _:
            return leg.duration


def loop(
    programme: Programme, stamps: dict[str, np.ndarray], mu: np.ndarray, force: np.ndarray
) -> Loop:
    """Return the loop of the last cycle of the last oscillation; NaN where there is none.

    stamps : of the kept samples (kernels/scene), each of shape (samples,), time in tau. mu and
    force (4 G L h^2/dx) : shape (replicates, samples). Integrals over the cycle are by trapezoids
    over its own time stamps.
    """
    swung = [(k, leg) for k, leg in enumerate(programme) if isinstance(leg, Oscillation)]
    nothing = np.full(len(mu), np.nan)
    if not swung:
        return Loop(nothing, nothing, nothing)
    k, leg = swung[-1]
    begin = sum(duration(before) for before in programme[:k])
    end, period = begin + duration(leg), 1.0 / leg.frequency
    time = stamps["time"]
    cycle = (time > end - period * (1.0 + 1e-9)) & (time <= end * (1.0 + 1e-12))
    at = time[cycle]
    if at.size < 4:
        return Loop(nothing, nothing, nothing)
    omega = 2.0 * math.pi * leg.frequency
    phase = omega * (at - begin)
    weight = _trapezoids(at, period)
    speed = leg.speed + leg.amplitude * omega * np.cos(phase)
    share = 2.0 / period * weight
    return Loop(
        force[:, cycle] @ (weight * speed),
        mu[:, cycle] @ (share * np.sin(phase)),
        mu[:, cycle] @ (share * np.cos(phase)),
    )


def _trapezoids(time: np.ndarray, period: float) -> np.ndarray:
    """Return the weights of samples of one period of a periodic function, shape (samples,)."""
    gaps = np.diff(time, append=time[0] + period)
    return 0.5 * (gaps + np.roll(gaps, 1))
