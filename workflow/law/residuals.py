"""Residuals of laws on motions, and the distance and duration of motions."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from .reduced_law import Law, friction_along, mean_speed
from .transients import Transient


class Extent(NamedTuple):
    """Totals of several motions."""

    distance: float  # m
    time: float  # s
    segments: int


def friction(motions: Sequence[Transient]) -> np.ndarray:
    """Return the known friction of the model over all motions."""
    return np.concatenate([motion.mu[motion.known] for motion in motions])


def row_residuals(law: Law, motion: Transient) -> np.ndarray:
    """Return mu of the law minus mu of the model at every row of a motion."""
    return friction_along(law, motion.time, motion.velocity) - motion.mu


def residuals(law: Law, motions: Sequence[Transient]) -> np.ndarray:
    """Return the residuals in the rows with known friction, over all motions."""
    return np.concatenate([row_residuals(law, motion)[motion.known] for motion in motions])


def root_mean_square(values: np.ndarray) -> float:
    """Return the root mean square of values, or NaN without values."""
    return float(np.sqrt(np.mean(values**2))) if values.size else math.nan


def distances(motion: Transient) -> np.ndarray:
    """Return the sliding distances between neighbouring rows of a motion, m."""
    return np.diff(motion.time) * list(map(mean_speed, motion.velocity[:-1], motion.velocity[1:]))


def extent_of(motions: Sequence[Transient]) -> Extent:
    """Return the total distance, duration and number of segments of motions."""
    distance = sum(float(distances(m).sum()) for m in motions)
    time = sum(float(m.time[-1] - m.time[0]) for m in motions)
    return Extent(distance, time, sum(len(list(m.parts())) for m in motions))
