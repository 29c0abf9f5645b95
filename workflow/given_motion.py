"""Validation of a given motion v(t), and its resampling in small velocity steps."""

import numpy as np
from numpy.typing import ArrayLike

from .ground import UserError


class LawError(UserError, ValueError):
    """Invalid values passed to a law."""


def finite_numbers(name: str, values: ArrayLike) -> np.ndarray:
    """Return values as floats. Raises UserError if any is not finite, not real, or masked."""
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
    """Return times and velocities, shape (n,). Raises UserError for decreasing times."""
    t, v = finite_numbers("time", time), finite_numbers("velocity", velocity)
    if t.shape != v.shape or t.ndim != 1 or not (np.diff(t) >= 0.0).all():
        raise LawError("time must increase, and velocity hold one value per time")
    return t, v


def distances_between_turns(time: np.ndarray, velocity: np.ndarray) -> np.ndarray:
    """Return the distances (m) that a motion slides from each turn to the next, shape (turns - 1,).

    time, velocity : s and m/s, linear between the samples; a jump has two samples at one time.
    """
    before, after = velocity[:-1], velocity[1:]
    size, duration = np.abs(before) + np.abs(after), np.diff(time)
    # The mean speed of a piece that turns is (v0^2 + v1^2) / (2 (|v0| + |v1|)).
    share = np.abs(before) / np.where(size > 0.0, size, 1.0)
    turning = before * after < 0.0
    to_turn = 0.5 * np.abs(before) * share * duration
    since_turn = 0.5 * np.abs(after) * (1.0 - share) * duration
    moved = np.where(turning, to_turn + since_turn, 0.5 * size * duration)
    path = np.append(0.0, np.cumsum(moved))
    moving = np.flatnonzero(velocity)
    turns = moving[:-1][np.diff(np.sign(velocity[moving])) != 0.0]  # the last rows before turns
    return np.diff(np.where(turning[turns], path[turns] + to_turn[turns], path[turns + 1]))


def finely(
    time: np.ndarray, velocity: np.ndarray, least: float, piece: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return times and velocities resampled in small steps, and the indices of the given samples.

    A step changes the velocity by at most ``piece`` times the speed, or times ``least`` (m/s) at
    lower speeds, where friction is linear in velocity (NaN: a default). Jumps are not divided.
    """
    if time.size < 2:
        return time, velocity, np.arange(time.size)
    change, duration = np.diff(velocity), np.diff(time)
    least = least if 0.0 < least < np.inf else max(1e-3 * float(np.max(np.abs(velocity))), 1e-300)
    stretched = np.arcsinh(velocity / least)
    parts = np.where(duration > 0.0, np.ceil(np.abs(np.diff(stretched)) / piece), 1.0)
    parts = np.maximum(parts, 1.0).astype(int)
    given = np.concatenate([[0], np.cumsum(parts)])
    index = np.interp(np.arange(given[-1] + 1), given, np.arange(given.size))
    k = np.minimum(index.astype(int), change.size - 1)
    v = least * np.sinh(np.interp(index, np.arange(given.size), stretched))
    v[given] = velocity
    divisor = np.where(change[k] != 0.0, change[k], 1.0)
    fraction = np.where(change[k] != 0.0, (v - velocity[k]) / divisor, index - k)
    t = time[k] + np.clip(fraction, 0.0, 1.0) * duration[k]
    t[given] = time
    return t, v, given
