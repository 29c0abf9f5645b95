"""Validation of a given motion v(t), and its resampling in small velocity steps."""

import math
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from .ground import UserError

MAX_PARTS = 1e5  # of a change of velocity
ROUNDING = 1e-9  # relative to a part
MIN_SPEED = 1e-300  # m/s, lower bound of a divisor


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


def divided(before: float, after: float, least: float, piece: float) -> list[tuple[float, float]]:
    """Return the steps (fraction of the duration, velocity) of a change that is linear in time.

    A step changes the velocity (m/s) by at most ``piece`` times the speed, or times ``least`` (m/s)
    at lower speeds. The last step ends at (1, after). Exported laws divide alike (law.h.j2).
    """
    first, last = math.asinh(before / least), math.asinh(after / least)
    count = abs(last - first) / piece
    parts = math.ceil(count - ROUNDING) if ROUNDING < count < MAX_PARTS else 1
    velocities = [least * math.sinh(first + k * (last - first) / parts) for k in range(1, parts)]
    return [((v - before) / (after - before), v) for v in velocities] + [(1.0, after)]


def smallest_speed(slowest: float, fastest: float) -> float:
    """Return the speed (m/s) relative to which changes at lower speeds are small.

    slowest : of the known speeds; NaN or infinite: a thousandth of the fastest one.
    """
    return slowest if 0.0 < slowest < math.inf else max(1e-3 * fastest, MIN_SPEED)


def finely(
    time: np.ndarray, velocity: np.ndarray, least: float, piece: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return times and velocities resampled in the steps of ``divided``, and the given indices.

    least : NaN for a default. Jumps are not divided.
    """
    if time.size < 2:
        return time, velocity, np.arange(time.size)
    least = smallest_speed(least, float(np.max(np.abs(velocity))))
    rows, given = [(float(time[0]), float(velocity[0]))], [0]
    intervals = zip(pairwise(time.tolist()), pairwise(velocity.tolist()), strict=True)
    for (start, end), (before, after) in intervals:
        steps = divided(before, after, least, piece) if end > start else [(1.0, after)]
        rows += [(start + fraction * (end - start), v) for fraction, v in steps]
        given.append(len(rows) - 1)
    t, v = np.array(rows).T
    t[given] = time
    return t, v, np.array(given)
