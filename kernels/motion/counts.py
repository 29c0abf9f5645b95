"""Number of steps in each leg of a programme, by formulas, without computing the steps.

The number is exact for slides, holds and small oscillations. For other legs, whose step times are
solved for (path.py), it is an upper bound.
"""

import math

import numpy as np

from ..rheology.spectrum import MIN_DASHPOT_STEP
from .legs import (
    Hold,
    Leg,
    Oscillation,
    Programme,
    Slide,
    check_leg,
    first_hold_step,
    has_equal_steps,
    last_speed,
    path_of,
)
from .path import (
    MIN_PARTIAL_STEP,
    SNAP_TOLERANCE,
    Path,
    growing_count,
    hold_step_ratio,
    min_cycle_steps,
    snap_to_sample,
)

MAX_PROGRAMME_STEPS = 10_000_000  # steps of a programme, at most
MAX_HOLD_STEP_RATIO = 1e12  # duration of a rest over its first step, at most


def count_steps(
    programme: Programme,
    steps_per_spacing: int,
    position: float = 0.0,
    speed: float = 0.0,
    shortest: float = MIN_DASHPOT_STEP,
) -> np.ndarray:
    """Return the number of steps of each leg, or an upper bound; arguments as in ``steps_of``.

    The shape is (legs,). The numbers are floats because they may be infinite. Raises ValueError for
    an invalid leg.
    """
    counts: list[float] = []
    m = steps_per_spacing
    for leg in programme:
        check_leg(leg)
        if not math.isfinite(position):  # the line has left the range of doubles
            break
        if isinstance(leg, Slide):
            end = position + math.copysign(leg.distance * m, leg.speed)
            end = snap_to_sample(end) if math.isfinite(end) else end
            counts.append(_count_slide_steps(position, end))
            position = end
        elif isinstance(leg, Hold):
            counts.append(_count_hold_steps(leg, m, speed, shortest))
        else:
            count, moved = _bound_leg(leg, m)
            counts.append(count)
            moved += position
            position = snap_to_sample(moved) if math.isfinite(moved) else moved
        if counts[-1]:
            speed = last_speed(leg)
    return np.array(counts + [0.0] * (len(programme) - len(counts)), float)


def _count_slide_steps(begin: float, end: float) -> float:
    """Return the number of steps that ``step_ends`` gives between two positions."""
    low, high = min(begin, end), max(begin, end)
    if not math.isfinite(high - low):
        return math.inf
    inner = math.floor(high - MIN_PARTIAL_STEP) - math.ceil(low + MIN_PARTIAL_STEP) + 1.0
    return max(inner, 0.0) + 1.0


def _count_hold_steps(leg: Hold, m: int, speed: float, shortest: float) -> float:
    if leg.duration <= 0.0:
        return 0.0
    first = first_hold_step(leg, m, speed, shortest)
    return float(growing_count(leg.duration / first, hold_step_ratio(m)))


def _bound_leg(leg: Leg, m: int) -> tuple[float, float]:
    """Return an upper bound of the steps of a leg, and its displacement in samples."""
    if not isinstance(leg, Oscillation):
        return _bound_path(path_of(leg, m), m)
    if has_equal_steps(leg, m):
        moved = m * leg.speed * leg.cycles / leg.frequency
        return float(min_cycle_steps(m) * leg.cycles), moved
    count, moved = _bound_path(path_of(leg._replace(cycles=1), m), m)  # all cycles are alike
    return leg.cycles * count, leg.cycles * moved


def _bound_path(path: Path, m: int) -> tuple[float, float]:
    """Return an upper bound of the steps along one path, and its displacement in samples."""
    with np.errstate(over="ignore", invalid="ignore"):
        places = path.where(path.breaks)
    pieces = np.abs(np.diff(places))
    resting = growing_count(MAX_HOLD_STEP_RATIO, hold_step_ratio(m))
    counts = np.ceil(pieces) + 2.0 + np.where(pieces > SNAP_TOLERANCE, min_cycle_steps(m), resting)
    count = float(counts.sum())
    return (count, float(places[-1])) if math.isfinite(count) else (math.inf, math.inf)
