"""Extent and speeds of a programme of motion, without its time steps."""

import math

import numpy as np

from .legs import Hold, Leg, Oscillation, Programme, Ramp, Slide, leg_duration, path_of


def programme_extent(programme: Programme) -> tuple[float, float]:
    """Return the distance between the extreme positions of a programme, dx, and its top speed."""
    places, fastest = [np.zeros(1)], 0.0
    for leg in programme:
        moved, speed = _motion(leg)
        places.append(places[-1][-1] + moved)
        fastest = max(fastest, speed)
    return float(np.ptp(np.concatenate(places))), fastest


def leg_mean_speed(leg: Leg) -> float:
    """Return the mean speed of a leg, signed, in dx/tau."""
    if isinstance(leg, Slide | Oscillation):
        return leg.speed
    return 0.0 if isinstance(leg, Hold) else float(_motion(leg)[0][-1]) / leg_duration(leg)


def _motion(leg: Leg) -> tuple[np.ndarray, float]:
    """Return the displacements at the turns and the end of a leg, in dx, and its highest speed."""
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
