"""Steps of a march whose friction is recorded, and their times."""

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
from ...kernels.drive import slider_room
from ...kernels.rheology.spectrum import min_step
from .tasks import Problem, Recording, ScaledHistory

HEALING_SAMPLES = 64  # samples of the leg after a hold, at geometrically spaced times
MAX_LISTED_STEPS = 1_000_000  # longer programmes are counted by a formula
CACHED_MARCHES = 16
LOOP_SAMPLES = 256  # samples of the last cycle of an oscillation


def record_steps(march_steps: int, samples: int, spectrum: Spectrum = KELVIN) -> np.ndarray:
    """Return the step numbers in the relaxation curve of a record.

    They increase from 1 to ``march_steps``: evenly spaced for a Kelvin element, which has one
    relaxation time, otherwise geometrically. Their number is at most ``samples`` - 1, as sample 0
    is the moment just after the jump and needs no step.
    """
    spread = np.linspace if spectrum == KELVIN else np.geomspace
    return np.unique(np.round(spread(1, march_steps, samples - 1)).astype(np.int64))


def curve_times(
    steps: np.ndarray, steps_per_tau: float, scheme: str, spectrum: Spectrum = KELVIN
) -> np.ndarray:
    """Return the times since the jump, in tau, to which the friction of some steps belongs.

    Friction is a mean over a step. It belongs to the time ``lag`` steps before the end of the step
    (rheology/law.py); the end itself would be wrong to first order. steps_per_tau : of the march.
    """
    return (steps - law_of(form_of(spectrum, scheme), 1.0 / steps_per_tau).lag) / steps_per_tau


class ProgrammeSteps(NamedTuple):
    """Steps of a programme, all arrays of shape (steps,)."""

    time: np.ndarray  # end of each step, since the start of the programme, in tau
    moved: np.ndarray  # distance in each step, in samples, not negative
    leg: np.ndarray  # number of the leg of each step


@lru_cache(maxsize=CACHED_MARCHES)
def _march(
    programme: Programme,
    history: float | ScaledHistory | None,
    spectrum: Spectrum,
    m: int,
    origin: Origin,
) -> ProgrammeSteps:
    empty = np.empty(0)
    scene = SceneCase(
        spectrum, "exponential", programme, 1.0, history, "steady", (), empty, empty, empty
    )
    steps = scene_steps(scene, m, origin)
    moved = np.abs(np.diff(steps.position, prepend=origin.position))
    return ProgrammeSteps(np.cumsum(steps.dt), moved, steps.leg)


def programme_steps(
    problem: Problem, steps_per_spacing: int, origin: Origin = ZERO_ORIGIN
) -> ProgrammeSteps:
    """Return the steps of the programme of a problem from ``origin`` on.

    Raises ValueError for steps lost in rounding, and for too many steps.
    """
    motion = problem.programme, problem.indentation, problem.spectrum
    return _march(*motion, steps_per_spacing, origin)


def max_leg_counts(
    problem: Problem, steps_per_spacing: int, origin: Origin = ZERO_ORIGIN
) -> np.ndarray:
    """Return an upper bound of the steps of each leg of a programme, shape (legs,)."""
    shortest = min_step(problem.spectrum)
    return count_steps(problem.programme, steps_per_spacing, *origin[:2], shortest)


def total_steps(problem: Problem, steps_per_spacing: int) -> float:
    """Return the number of steps of a programme.

    Beyond MAX_LISTED_STEPS return an upper bound, which needs no array of steps.
    """
    bound = float(max_leg_counts(problem, steps_per_spacing).sum())
    if bound > MAX_LISTED_STEPS:
        return bound
    return programme_steps(problem, steps_per_spacing).time.size


@lru_cache(maxsize=1000)
def trace_steps(problem: Problem, steps_per_spacing: int, recording: Recording) -> np.ndarray:
    """Return the step numbers of the samples of a trace, increasing; 0 is the start."""
    programme = problem.programme
    time, moved, leg = programme_steps(problem, steps_per_spacing, recording.origin)
    count = time.size
    chosen = [np.array([0, count])]
    if recording.every:
        chosen.append(np.arange(0, count + 1, recording.every))
    elif recording.record == "log":
        samples = max(2, recording.samples // len(programme))
        chosen += [_by_factor(*_range(leg, k), time, samples) for k in range(len(programme))]
    else:
        progress = time if recording.record == "time" else np.cumsum(moved)
        chosen.append(_evenly(progress, 0, count, recording.samples))
    for k in range(1, len(programme)):
        if "healing" in recording.dense and isinstance(programme[k - 1], Hold):
            chosen.append(_by_factor(*_range(leg, k), time, HEALING_SAMPLES))
    for k, motion in enumerate(programme):
        if "loop" in recording.dense and isinstance(motion, Oscillation):
            first, last = _range(leg, k)
            begin = time[last - 1] - 1.0 / motion.frequency
            first = 1 + int(np.searchsorted(time, begin * (1.0 - 1e-12)))
            chosen += [np.array([first]), _evenly(time, first, last, LOOP_SAMPLES)]
    return np.unique(np.concatenate(chosen))


def trace_size(problem: Problem, steps_per_spacing: int, recording: Recording) -> int:
    """Return the number of samples of a trace; of steps of a slider, the maximum."""
    if recording.one_slider and recording.every:
        steps = programme_steps(problem, steps_per_spacing, recording.origin).time.size
        return 1 + slider_room(steps, recording.every)
    return trace_steps(problem, steps_per_spacing, recording).size


def _range(leg: np.ndarray, k: int) -> tuple[int, int]:
    """Return the numbers of the last step before leg k and of the last step of leg k."""
    first, last = np.searchsorted(leg, [k, k + 1])
    return int(first), int(last)


def _evenly(progress: np.ndarray, first: int, last: int, count: int) -> np.ndarray:
    """Return steps from ``first`` + 1 to ``last``, evenly spaced in ``progress``."""
    if last <= first:
        return np.empty(0, np.int64)
    begin = progress[first - 1] if first else 0.0
    targets = np.linspace(begin, progress[last - 1], count)[1:]
    steps = first + 1 + np.searchsorted(progress[first : last - 1], targets * (1.0 - 1e-12))
    return np.minimum(steps, last)


def _by_factor(first: int, last: int, time: np.ndarray, count: int) -> np.ndarray:
    """Return steps from ``first`` to ``last``, geometrically spaced in time since ``first``."""
    if last <= first:
        return np.empty(0, np.int64)
    begin = time[first - 1] if first else 0.0
    since = time[first:last] - begin
    targets = np.geomspace(since[0], since[-1], count)
    steps = np.searchsorted(since, targets * (1.0 - 1e-12))
    return np.append(first, first + 1 + np.minimum(steps, since.size - 1))
