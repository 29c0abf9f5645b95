"""Adaptive sampling of a motion given as a Python function v(t)."""

from collections.abc import Callable
from typing import Any

import numpy as np

from ...ground import UserError
from ..settings import number
from .histories import MAX_SAMPLES

FIRST_INTERVALS = 1009  # a prime, against aliasing of periodic motions
VELOCITY_TOLERANCE = 1e-4  # misfit of a line between two samples, over the largest speed
MIN_INTERVAL = 1e-7  # over the duration: shorter intervals are not divided
THIRDS = np.array([[1.0], [2.0]]) / 3.0  # unlike the middle, these points detect an inflection


def sampled_motion(velocity: Callable[[float], Any], duration: float) -> dict[str, list[float]]:
    """Return times (s) and velocities (m/s), between which a function is nearly linear.

    velocity : function of the time (s) that returns m/s. Intervals are divided in three until the
    line meets both inner points. Raises UserError for a value that is not a finite number, and for
    a function that needs more than MAX_SAMPLES samples.
    """

    def at(times: np.ndarray) -> np.ndarray:
        values = [(t, np.asarray(velocity(t)).tolist()) for t in times.tolist()]
        return np.array([number(f"programme({t:g})", value) for t, value in values])

    times = np.linspace(0.0, duration, FIRST_INTERVALS + 1)
    values = at(times)
    left = np.arange(FIRST_INTERVALS)  # first samples of the intervals that may bend
    while left.size:
        (begin, end), (first, last) = ((a[left], a[left + 1]) for a in (times, values))
        inner = begin + THIRDS * (end - begin)
        inside = at(inner.ravel()).reshape(inner.shape)
        misfit = np.abs(inside - first - THIRDS * (last - first)).max(axis=0)
        bent = misfit > VELOCITY_TOLERANCE * max(np.abs(values).max(), np.abs(inside).max())
        bent &= end - begin > MIN_INTERVAL * duration
        if times.size + 2 * bent.sum() > MAX_SAMPLES:
            raise UserError(
                f"programme: a function that needs more than {MAX_SAMPLES} samples in duration = "
                f"{duration:g} s; give a shorter duration, or repeat a period"
            )
        place = np.repeat(left[bent] + 1, 2)
        times = np.insert(times, place, inner[:, bent].T.ravel())
        values = np.insert(values, place, inside[:, bent].T.ravel())
        left = ((left[bent] + 2 * np.arange(bent.sum()))[:, None] + np.arange(3)).ravel()
    return {"time": times.tolist(), "velocity": values.tolist()}
