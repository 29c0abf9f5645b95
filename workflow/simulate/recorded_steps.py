"""Which steps of a march are kept, and the times that they belong to."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ...kernels import (
    KELVIN,
    ZERO_ORIGIN,
    Hold,
    Origin,
    Oscillation,
    Programme,
    SceneCase,
    Spectrum,
    count_steps,
    form_of,
    law_of,
    scene_steps,
)
from ...kernels.rheology.spectrum import min_step
from .tasks import Problem, Recording, ScaledHistory

RESTART = 64  # samples of the leg after a hold, at times that grow by a factor
MAX_LISTED_STEPS = 1_000_000  # steps that are counted one by one
FEW = 16  # marches whose steps are remembered
LOOP = 256  # samples of the last cycle of an oscillation


def curve_steps(march_steps: int, samples: int, spectrum: Spectrum = KELVIN) -> np.ndarray:
    """Return the numbers of the steps that the relaxation curve of a record keeps.

    They increase from 1 to ``march_steps``, and are ``samples`` - 1 at most; evenly for a Kelvin
    element, which has one time, and by a factor where there are many. Sample 0 of a curve is the
    moment just after the jump and needs no step.
    """
    spread = np.linspace if spectrum == KELVIN else np.geomspace
    return np.unique(np.round(spread(1, march_steps, samples - 1)).astype(np.int64))


def curve_times(
    kept: np.ndarray, steps_per_tau: float, scheme: str, spectrum: Spectrum = KELVIN
) -> np.ndarray:
    """Return the times since the jump, in tau, to which the friction of kept steps belongs.

    It is a mean over the step and acts ``lag`` of a step before its end (rheology/law.py). At
    the end it would be an error of first order. steps_per_tau : of the march.
    """
    return (kept - law_of(form_of(spectrum, scheme), 1.0 / steps_per_tau).lag) / steps_per_tau


class ProgrammeSteps(NamedTuple):
    """The steps of a programme, all arrays of shape (S,)."""

    time: np.ndarray  # at the end of each step since the start of the programme, in tau
    moved: np.ndarray  # by each step, in samples, not negative
    leg: np.ndarray  # number of the leg of each


@lru_cache(maxsize=FEW)
def _march(
    programme: Programme,
    history: float | ScaledHistory | None,
    spectrum: Spectrum,
    m: int,
    origin: Origin,
) -> ProgrammeSteps:
    nothing = np.empty(0)
    scene = SceneCase(
        spectrum, "exponential", programme, 1.0, history, "steady", (), nothing, nothing, nothing
    )
    steps = scene_steps(scene, m, origin)
    moved = np.abs(np.diff(steps.position, prepend=origin.position))
    return ProgrammeSteps(np.cumsum(steps.dt), moved, steps.leg)


def programme_steps(
    problem: Problem, steps_per_spacing: int, origin: Origin = ZERO_ORIGIN
) -> ProgrammeSteps:
    """Return the steps of the programme of a problem that begins at ``origin``.

    Raises ValueError for steps that are lost in rounding, and for more than can be marched.
    """
    what = problem.programme, problem.indentation, problem.spectrum
    return _march(*what, steps_per_spacing, origin)


def max_leg_counts(
    problem: Problem, steps_per_spacing: int, origin: Origin = ZERO_ORIGIN
) -> np.ndarray:
    """Return how many steps each leg of a programme takes at most, by formula, shape (legs,)."""
    shortest = min_step(problem.spectrum)
    return count_steps(problem.programme, steps_per_spacing, *origin[:2], shortest)


def leg_counts(
    problem: Problem, steps_per_spacing: int, origin: Origin = ZERO_ORIGIN
) -> np.ndarray:
    """Return how many steps each leg of a programme takes, shape (legs,).

    Beyond MAX_LISTED_STEPS steps in all they are those of a formula, which makes no array of steps.
    """
    counts, legs = max_leg_counts(problem, steps_per_spacing, origin), len(problem.programme)
    if counts.sum() > MAX_LISTED_STEPS:
        return counts
    return np.bincount(programme_steps(problem, steps_per_spacing, origin).leg, minlength=legs)


@lru_cache(maxsize=1000)
def trace_steps(problem: Problem, steps_per_spacing: int, recording: Recording) -> np.ndarray:
    """Return the increasing numbers of the steps at which a trace is kept; 0 is the start."""
    programme = problem.programme
    time, moved, leg = programme_steps(problem, steps_per_spacing, recording.origin)
    count = time.size
    chosen = [np.array([0, count])]
    if recording.every:
        chosen.append(np.arange(0, count + 1, recording.every))
    elif recording.record == "log":
        each = max(2, recording.samples // len(programme))
        chosen += [_by_factor(*_range(leg, k), time, each) for k in range(len(programme))]
    else:
        passed = time if recording.record == "time" else np.cumsum(moved)
        chosen.append(_evenly(passed, 0, count, recording.samples))
    for k in range(1, len(programme)):
        if "healing" in recording.dense and isinstance(programme[k - 1], Hold):
            chosen.append(_by_factor(*_range(leg, k), time, RESTART))
    for k, motion in enumerate(programme):
        if "loop" in recording.dense and isinstance(motion, Oscillation):
            first, last = _range(leg, k)
            begin = time[last - 1] - 1.0 / motion.frequency
            first = 1 + int(np.searchsorted(time, begin * (1.0 - 1e-12)))
            chosen += [np.array([first]), _evenly(time, first, last, LOOP)]
    return np.unique(np.concatenate(chosen))


def _range(leg: np.ndarray, k: int) -> tuple[int, int]:
    """Return the number of the last step before leg k, and of the last step in it."""
    first, last = np.searchsorted(leg, [k, k + 1])
    return int(first), int(last)


def _evenly(passed: np.ndarray, first: int, last: int, count: int) -> np.ndarray:
    """Return steps after ``first`` to ``last`` that lie evenly over what has passed by each."""
    if last <= first:
        return np.empty(0, np.int64)
    begin = passed[first - 1] if first else 0.0
    wanted = np.linspace(begin, passed[last - 1], count)[1:]
    found = first + 1 + np.searchsorted(passed[first : last - 1], wanted * (1.0 - 1e-12))
    return np.minimum(found, last)


def _by_factor(first: int, last: int, time: np.ndarray, count: int) -> np.ndarray:
    """Return steps after ``first`` to ``last`` whose times since ``first`` grow by a factor."""
    if last <= first:
        return np.empty(0, np.int64)
    begin = time[first - 1] if first else 0.0
    since = time[first:last] - begin
    wanted = np.geomspace(since[0], since[-1], count)
    found = np.searchsorted(since, wanted * (1.0 - 1e-12))
    return np.append(first, first + 1 + np.minimum(found, since.size - 1))
