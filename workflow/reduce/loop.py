"""Loop of friction in an oscillation.

mu' and mu'' are the amplitudes of mu(t) = ... + mu' sin(2 pi f t) + mu'' cos(2 pi f t), in phase
with the superposed displacement A sin(2 pi f t) and with its velocity.
"""

import math
from typing import NamedTuple

import numpy as np

from ...kernels import Oscillation, Programme
from ...kernels.motion.legs import leg_duration


class Loop(NamedTuple):
    """Loop of the last cycle, for the mean trace and its replicates, shape (replicates,)."""

    loop_work: np.ndarray  # in 4 G L h^2
    mu_in_phase: np.ndarray
    mu_quadrature: np.ndarray


def loop(programme: Programme, times: np.ndarray, mu: np.ndarray, force: np.ndarray) -> Loop:
    """Return the loop of the last cycle of the last oscillation, NaN without an oscillation.

    times (tau), mu, force (4 G L h^2/dx) : shape (replicates, samples), the mean trace first.
    Integrals over the cycle use the trapezoidal rule over the mean times.
    """
    oscillations = [(k, leg) for k, leg in enumerate(programme) if isinstance(leg, Oscillation)]
    nothing = np.full(len(mu), np.nan)
    if not oscillations:
        return Loop(nothing, nothing, nothing)
    k, leg = oscillations[-1]
    begin = sum(leg_duration(before) for before in programme[:k])
    end, period = begin + leg_duration(leg), 1.0 / leg.frequency
    time = times[0]
    cycle = (time > end - period * (1.0 + 1e-9)) & (time <= end * (1.0 + 1e-12))
    at = time[cycle]
    if at.size < 4:
        return Loop(nothing, nothing, nothing)
    omega = 2.0 * math.pi * leg.frequency
    phase = omega * (at - begin)
    gaps = np.diff(at, append=at[0] + period)
    weight = 0.5 * (gaps + np.roll(gaps, 1))  # of the trapezoidal rule
    speed = leg.speed + leg.amplitude * omega * np.cos(phase)
    share = 2.0 / period * weight
    return Loop(
        force[:, cycle] @ (weight * speed),
        mu[:, cycle] @ (share * np.sin(phase)),
        mu[:, cycle] @ (share * np.cos(phase)),
    )
