"""Description of a scene: material, programme of motion, control and start."""

import math
from typing import NamedTuple

import numpy as np

from ..interface.effects import NO_EFFECTS, Effects
from ..model.limits import LOAD_LIMITS, SPEED_LIMITS, check_range
from ..motion.counts import MAX_PROGRAMME_STEPS, count_steps
from ..motion.legs import Programme, Steps, speed_at_start, steps_of
from ..rheology.spectrum import Spectrum, min_step

SCENE_QUANTITIES = (
    "trace",
    "stick_slip",
    "slip_events",
    "cycle_mean",
    "energy",
    "contact_lengths",
    "snapshots",
    "state",
)
SCENE_STARTS = ("steady", "relaxed", "fresh")


class SceneCase(NamedTuple):
    """Scene of one line. Lengths along x are in dx, heights in h, times in tau."""

    spectrum: Spectrum  # of the elastomer
    scheme: str  # "exponential" or "implicit-euler"
    programme: Programme
    load: float  # Fbar = F_N / (4 G L h); NaN if the indentation is prescribed
    indentation: tuple[tuple[float, ...], tuple[float, ...]] | float | None
    # None: constant force. A number: constant, in h over the mean line. (times, values): piecewise
    # linear d(t), evaluated at the steps of the programme and, at rest, at these times too.
    start: str  # one of SCENE_STARTS
    requested: tuple[str, ...]  # some of SCENE_QUANTITIES
    recorded: np.ndarray  # numbers of the recorded steps, increasing; 0 is the start
    edges: np.ndarray  # of the bins of contact lengths, shape (bins + 1,), in dx
    frames: np.ndarray  # numbers of the steps with a snapshot, increasing; 0 is the start
    effects: Effects = NO_EFFECTS  # of a half-space
    slider_steps: int = 0  # every n-th step of a pulled slider is recorded; 0: as ``recorded``


class Origin(NamedTuple):
    """Origin of a programme; it determines the time steps together with the programme."""

    position: float = 0.0  # of the line, in samples
    speed: float = 0.0  # at the end of the leg before, in dx/tau
    time: float = 0.0  # in tau


ZERO_ORIGIN = Origin()


class SavedState(NamedTuple):
    """State from which a programme resumes bit for bit."""

    memory: np.ndarray  # internal variables of the elements, shape (M, n)
    p: np.ndarray  # forces of the elements, shape (n,), in 4 G dx h
    d: float  # indentation, in h over the deepest point of the line
    position: float  # of the line, in samples
    time: float  # in tau
    speed: float  # at the end of the leg before, in dx/tau

    @property
    def origin(self) -> Origin:
        """Return the origin of the programme that resumes here."""
        return Origin(self.position, self.speed, self.time)


def scene_steps(scene: SceneCase, steps_per_spacing: int, origin: Origin = ZERO_ORIGIN) -> Steps:
    """Return all time steps of a scene that begins at ``origin``; steps_per_spacing : m.

    Raises ValueError in the cases of steps_of, for a programme without steps, and for one with more
    than MAX_PROGRAMME_STEPS steps.
    """
    position, speed, time = origin
    shortest = min_step(scene.spectrum)
    count = count_steps(scene.programme, steps_per_spacing, position, speed, shortest).sum()
    if count > MAX_PROGRAMME_STEPS:
        raise ValueError(
            f"programme: takes up to {count:.3g} steps, more than {MAX_PROGRAMME_STEPS:g}"
        )
    steps = steps_of(scene.programme, steps_per_spacing, position, speed, shortest)
    if not steps.dt.size:
        raise ValueError("programme: its legs take no time")
    if isinstance(scene.indentation, tuple):
        return _split_at_rest(steps, position, np.asarray(scene.indentation[0], float) - time)
    return steps


def _split_at_rest(steps: Steps, position: float, times: np.ndarray) -> Steps:
    """Return the steps after splitting those at rest at the given times."""
    end = np.cumsum(steps.dt)
    resting = steps.position == np.append(position, steps.position[:-1])
    times = times[(times > 0.0) & (times < end[-1])]
    times = times[resting[np.searchsorted(end, times)]]
    every = np.union1d(end, times)
    every = every[np.append(True, np.diff(every) > 1e-9 * np.diff(every).max())]
    every[-1] = end[-1]
    step = np.searchsorted(end, every)
    whole = np.isin(every, end) & np.isin(np.append(0.0, every[:-1]), np.append(0.0, end))
    dt = np.where(whole, steps.dt[step], np.diff(np.append(0.0, every)))
    return Steps(steps.position[step], dt, steps.leg[step])


def indentation_at(scene: SceneCase, times: np.ndarray, datum: float) -> np.ndarray:
    """Return the prescribed indentation over the deepest point, in h, at times in tau.

    datum : height of the deepest point over the mean line, in h.
    """
    if isinstance(scene.indentation, tuple):
        return np.interp(times, *scene.indentation) - datum
    return np.full(np.shape(times), scene.indentation, float) - datum


def check_scene(scene: SceneCase, steps: Steps, resumed: bool) -> None:
    """Raise ValueError for an invalid scene, or one beyond the resolution of doubles."""
    if scene.start not in SCENE_STARTS:
        raise ValueError(f"start = {scene.start!r}: use one of {SCENE_STARTS}")
    if unknown := set(scene.requested) - set(SCENE_QUANTITIES):
        raise ValueError(f"requested = {sorted(unknown)}: use some of {SCENE_QUANTITIES}")
    if "energy" in scene.requested and scene.scheme != "exponential":
        raise ValueError(f'scheme = {scene.scheme!r}: energy needs the scheme "exponential"')
    if "contact_lengths" in scene.requested and not np.all(np.diff(scene.edges) > 0.0):
        raise ValueError("edges must increase")
    for name, numbers in (("recorded", scene.recorded), ("frames", scene.frames)):
        inside = numbers.size == 0 or (numbers[0] >= 0 and numbers[-1] <= steps.dt.size)
        if not (inside and np.all(np.diff(numbers) > 0)):
            raise ValueError(f"{name} must hold increasing numbers of steps, 0 to {steps.dt.size}")
    _check_control(scene, resumed)


def _check_control(scene: SceneCase, resumed: bool) -> None:
    """Raise ValueError for an invalid load or first speed, or for both load and indentation."""
    if scene.indentation is None:
        check_range("load", scene.load, LOAD_LIMITS)
    elif not math.isnan(scene.load):
        raise ValueError("load and indentation are both given: one of them follows from the other")
    if scene.start == "steady" and not resumed:
        check_range("first speed", abs(speed_at_start(scene.programme)), SPEED_LIMITS)
