"""Memory of the first contact that a trace meets again after one period of the line or map.

A programme that starts "relaxed" or "fresh" imprints its first contact on every branch. A branch
that outlives the time of one period still holds the imprint when the motion has covered a period,
and friction repeats it. Steady sliding leaves no such imprint, nor does a motion about one place.
"""

import math

import numpy as np

from ...kernels import Hold, Leg, Oscillation, Programme, Ramp, Slide
from ...kernels.motion.legs import path_of
from ..simulate import Problem

MAX_REMEMBERED = 0.01  # share of the first contact that a trace may meet again


def remembered_share(problem: Problem) -> float:
    """Return the share of the first contact that its slowest branch holds after one period.

    It is exp(-L/(v t)) at the highest speed v of the programme; 0 if the motion covers no period,
    if it starts with steady sliding, or for elements that only have a dashpot.
    """
    if not problem.spectrum.times or problem.start == "steady":
        return 0.0
    covered, fastest = range_of(problem.programme)
    if covered <= problem.elements:
        return 0.0
    return math.exp(-problem.elements / (fastest * max(problem.spectrum.times)))


def range_of(programme: Programme) -> tuple[float, float]:
    """Return the distance between the extreme positions of a programme, dx, and its top speed."""
    places, fastest = [np.zeros(1)], 0.0
    for leg in programme:
        moved, speed = _motion(leg)
        places.append(places[-1][-1] + moved)
        fastest = max(fastest, speed)
    return float(np.ptp(np.concatenate(places))), fastest


def _motion(leg: Leg) -> tuple[np.ndarray, float]:
    """Return the displacements at the turns and the end of a leg, in dx, and its highest speed.

    The motion of a drive stands for that of the line that it pulls.
    """
    match leg:
        case Slide():
            return np.array([math.copysign(leg.distance, leg.speed)]), abs(leg.speed)
        case Hold():
            return np.zeros(1), 0.0
        case Oscillation():
            moved = leg.speed * leg.cycles / leg.frequency
            fastest = abs(leg.speed) + 2.0 * math.pi * leg.frequency * leg.amplitude
            return np.array([-leg.amplitude, moved + leg.amplitude, moved]), fastest
        case _:
            path = path_of(leg, 1)
            speeds = (leg.first, leg.last) if isinstance(leg, Ramp) else leg.speeds
            return path.where(path.breaks), float(np.abs(speeds).max())
