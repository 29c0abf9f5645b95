"""Time steps along a path X(t) that end at whole samples of the line.

A step also ends where the path turns or ends, which is generally at a fraction of a sample. If the
line takes too long from one sample to the next, that step is divided into equal times.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

SNAP_TOLERANCE = 1e-9  # in samples: a smaller distance from a whole sample is rounding
MIN_PARTIAL_STEP = 0.25  # in samples: minimum step next to a turn or an end of the path
TIME_BISECTIONS = 60  # resolve a time to the last bit, unless it is far shorter than the piece


class Path(NamedTuple):
    """Position of the line over time."""

    where: Callable[[np.ndarray], np.ndarray]  # displacement in samples at times in tau
    breaks: np.ndarray  # times from 0 to the end; X is monotone or constant between two of them


def min_cycle_steps(m: int) -> int:
    """Return the minimum number of time steps per cycle, at m samples per spacing."""
    return max(64, 16 * m)


def hold_step_ratio(m: int) -> float:
    """Return the ratio of consecutive time steps while the line rests; m : samples per spacing."""
    return 1.0 + 1.0 / (2.0 * m)


def growing_count(duration: float, ratio: float) -> int:
    """Return the number of steps that grow by ``ratio``; duration : total, over the first step.

    The sum of the steps, over the first one, is (ratio^count - 1) / (ratio - 1).
    """
    return math.ceil(math.log1p(duration * (ratio - 1.0)) / math.log(ratio))


def growing_steps(duration: float, first: float, ratio: float) -> np.ndarray:
    """Return time steps that grow by ``ratio``, from at most ``first``, and fill the duration."""
    if duration <= 0.0:
        return np.empty(0)
    count = growing_count(duration / first, ratio)
    times = np.expm1(math.log(ratio) * np.arange(count + 1))
    return np.diff(times * (duration / times[-1]))


def step_ends(begin: float, end: float) -> np.ndarray:
    """Return the ends of steps from one position to another: whole samples, then ``end``."""
    end = snap_to_sample(end)
    low, high = min(begin, end), max(begin, end)
    inner = np.arange(math.ceil(low + MIN_PARTIAL_STEP), math.floor(high - MIN_PARTIAL_STEP) + 1.0)
    return np.append(inner if end > begin else inner[::-1], end)


def snap_to_sample(position: float) -> float:
    """Return the position, or the nearest whole sample if only rounding separates them."""
    nearest = float(round(position))
    near = abs(position - nearest) <= SNAP_TOLERANCE * max(1.0, abs(nearest))
    return nearest if near else position


def steps_along(path: Path, m: int, start: float) -> tuple[np.ndarray, np.ndarray]:
    """Return (positions, dt) of the steps along a path, from position ``start`` in samples."""
    places, times = [np.empty(0)], [np.zeros(1)]
    position, dt = start, math.inf
    for begin, end in zip(path.breaks[:-1], path.breaks[1:], strict=True):
        goal = start + float(path.where(np.array([end]))[0])
        if abs(goal - position) <= SNAP_TOLERANCE * max(1.0, abs(position)):
            first = min(dt, 2.0 * (end - begin) / min_cycle_steps(m))
            time = begin + np.cumsum(growing_steps(end - begin, first, hold_step_ratio(m)))
            time[-1] = end
            place = np.full(time.size, position)
        else:
            place = step_ends(position, goal)
            time = np.append(_times(path, place[:-1] - start, begin, end), end)
            place, time = _divide_steps(path, place, time, begin, start, min_cycle_steps(m) // 2)
        dt = float(time[-1] - (time[-2] if time.size > 1 else begin))
        position = float(place[-1])
        places.append(place)
        times.append(time)
    return np.concatenate(places), np.diff(np.concatenate(times))


def _times(path: Path, moved: np.ndarray, begin: float, end: float) -> np.ndarray:
    """Return the times of given displacements, by bisection on a monotone piece of the path."""
    low, high = np.full(moved.size, begin), np.full(moved.size, end)
    rising = path.where(np.array([end]))[0] > path.where(np.array([begin]))[0]
    for _ in range(TIME_BISECTIONS):
        middle = 0.5 * (low + high)
        before = (path.where(middle) < moved) == rising
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    return high


def _divide_steps(
    path: Path, place: np.ndarray, time: np.ndarray, begin: float, start: float, min_steps: int
) -> tuple[np.ndarray, np.ndarray]:
    """Divide steps longer than 1/min_steps of a piece into equal times; return (places, times)."""
    longest = (time[-1] - begin) / min_steps
    before = np.concatenate([[begin], time[:-1]])
    parts = np.maximum(np.ceil((time - before) / longest * (1.0 - 1e-12)), 1.0).astype(np.int64)
    step = np.repeat(np.arange(time.size), parts)
    part = np.arange(step.size) - np.repeat(np.cumsum(parts) - parts, parts) + 1
    split = before[step] + (time - before)[step] * (part / parts[step])
    at = start + path.where(split)
    last = part == parts[step]
    split[last], at[last] = time, place
    return at, split


def oscillation_path(speed: float, amplitude: float, frequency: float, cycles: int, m: int) -> Path:
    """Return the path of an Oscillation (legs.py); every cycle ends at a break."""
    omega = 2.0 * math.pi * frequency
    turns = np.zeros(0)
    if abs(speed) < omega * amplitude:
        quarter = math.acos(-speed / (omega * amplitude)) / omega
        turns = np.array([quarter, 1.0 / frequency - quarter])
    one = np.append(turns, 1.0 / frequency)
    breaks = (np.arange(cycles)[:, None] / frequency + one).ravel()

    def where(t: np.ndarray) -> np.ndarray:
        cycle = t * frequency
        return m * (speed * t + amplitude * np.sin(2.0 * math.pi * (cycle - np.floor(cycle))))

    return Path(where, np.append(0.0, breaks))


def piecewise_path(times: tuple[float, ...], speeds: tuple[float, ...], m: int) -> Path:
    """Return the path of a speed that is linear between given times."""
    t, v = np.asarray(times, float), np.asarray(speeds, float)
    duration = np.diff(t)
    reached = np.append(0.0, np.cumsum(0.5 * duration * (v[:-1] + v[1:])))
    rate = np.diff(v) / duration
    turning = np.flatnonzero(v[:-1] * v[1:] < 0.0)
    turns = t[turning] - v[turning] / rate[turning]
    resting = (v[:-1] == 0.0) & (v[1:] == 0.0)
    inside_rest = np.append(resting, False) & np.append(False, resting)
    stops = t[(v == 0.0) & ~inside_rest]

    def where(at: np.ndarray) -> np.ndarray:
        i = np.clip(np.searchsorted(t, at, side="right") - 1, 0, t.size - 2)
        since = at - t[i]
        return m * (reached[i] + since * (v[i] + 0.5 * rate[i] * since))

    return Path(where, np.unique(np.concatenate([turns, stops, t[:1], t[-1:]])))
