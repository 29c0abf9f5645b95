"""Checks of a given motion v(t), and its division into small changes of the velocity."""

import numpy as np
from numpy.typing import ArrayLike

from .ground import UserError


class LawError(UserError, ValueError):
    """Invalid values passed to a law."""


def finite_numbers(name: str, values: ArrayLike) -> np.ndarray:
    """Return an array. Raises UserError for values that are not finite, not real, or masked."""
    try:
        if np.iscomplexobj(values) or np.ma.is_masked(values):
            raise ValueError("they are complex or masked")
        array = np.asarray(values, dtype=float)
    except (TypeError, ValueError) as error:
        raise LawError(f"{name} must hold real numbers: {error}") from error
    if not np.isfinite(array).all():
        raise LawError(f"{name} must be finite")
    return array


def given_motion(time: ArrayLike, velocity: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Return times and velocities of shape (n,). Raises UserError for times that decrease."""
    t, v = finite_numbers("time", time), finite_numbers("velocity", velocity)
    if t.shape != v.shape or t.ndim != 1 or not (np.diff(t) >= 0.0).all():
        raise LawError("time must increase, and velocity hold one value per time")
    return t, v


def finely(
    time: np.ndarray, velocity: np.ndarray, least: float, piece: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return times and velocities in small changes, and the indices of the given samples in them.

    A change is at most the share ``piece`` of the speed, or of ``least`` (m/s, NaN: unknown), below
    which friction is linear in the velocity. A jump is not divided.
    """
    if time.size < 2:
        return time, velocity, np.arange(time.size)
    change, duration = np.diff(velocity), np.diff(time)
    least = least if 0.0 < least < np.inf else max(1e-3 * float(np.max(np.abs(velocity))), 1e-300)
    place = np.arcsinh(velocity / least)
    parts = np.where(duration > 0.0, np.ceil(np.abs(np.diff(place)) / piece), 1.0)
    parts = np.maximum(parts, 1.0).astype(int)
    last = np.concatenate([[0], np.cumsum(parts)])
    at = np.interp(np.arange(last[-1] + 1), last, np.arange(last.size))
    of = np.minimum(at.astype(int), change.size - 1)
    v = least * np.sinh(np.interp(at, np.arange(last.size), place))
    v[last] = velocity
    moved = np.where(change[of] != 0.0, change[of], 1.0)
    along = np.where(change[of] != 0.0, (v - velocity[of]) / moved, at - of)
    t = time[of] + np.clip(along, 0.0, 1.0) * duration[of]
    t[last] = time
    return t, v, last
