"""What a line can be taken through: a material, a programme of motion, a control, a start."""

import math
from typing import NamedTuple

import numpy as np

from ..model.limits import LOAD_LIMITS, SPEED_LIMITS, check_range
from ..motion.counts import MAX_PROGRAMME_STEPS, count_steps
from ..motion.legs import Programme, Steps, speed_at_start, steps_of
from ..rheology.spectrum import Spectrum, min_step

ASKED = (
    "trace",
    "stick_slip",
    "slip_events",
    "cycle_mean",
    "energy",
    "contact_lengths",
    "snapshots",
    "state",
)
STARTS = ("steady", "relaxed", "fresh")


class SceneCase(NamedTuple):
    """What one line is taken through. Lengths along x in dx, heights in h, times in tau."""

    spectrum: Spectrum  # of the elastomer
    scheme: str  # "exponential" or "implicit-euler"
    programme: Programme
    load: float  # Fbar = F_N / (4 G L h); NaN where the indentation is prescribed
    indentation: tuple[tuple[float, ...], tuple[float, ...]] | float | None
    # None: constant force. A number: constant, in h over the mean line. (times, values): d(t),
    # linear in between, to be followed by the steps of the programme and, at rest, its own times.
    start: str  # of STARTS
    asked: tuple[str, ...]  # of ASKED
    kept: np.ndarray  # numbers of the steps at which a trace is kept; 0 is the start
    edges: np.ndarray  # of the bins of contact lengths, shape (bins + 1,), in dx
    frames: np.ndarray  # numbers of the steps at which a snapshot is taken; 0 is the start


class Origin(NamedTuple):
    """Where a programme begins: all that its steps depend on beside itself."""

    position: float = 0.0  # of the line, in samples
    speed: float = 0.0  # of the leg before, in dx/tau
    time: float = 0.0  # in tau


START = Origin()


class Saved(NamedTuple):
    """What a programme needs to go on to the bit."""

    memory: np.ndarray  # internal variables of the elements, shape (M, n)
    p: np.ndarray  # shape (n,): their forces
    d: float  # indentation, in h over the deepest point of the line
    position: float  # of the line, in samples
    time: float  # in tau
    speed: float  # of the leg before, in dx/tau

    @property
    def origin(self) -> Origin:
        """Return where a programme goes on."""
        return Origin(self.position, self.speed, self.time)


def scene_steps(scene: SceneCase, steps_per_spacing: int, origin: Origin = START) -> Steps:
    """Return all time steps of a scene that begins at ``origin``; steps_per_spacing : m.

    Raises ValueError as steps_of, where there is none, and for more than MAX_PROGRAMME_STEPS.
    """
    position, speed, time = origin
    shortest = min_step(scene.spectrum)
    most = count_steps(scene.programme, steps_per_spacing, position, speed, shortest).sum()
    if most > MAX_PROGRAMME_STEPS:
        raise ValueError(
            f"programme: takes up to {most:.3g} steps, more than {MAX_PROGRAMME_STEPS:g}"
        )
    steps = steps_of(scene.programme, steps_per_spacing, position, speed, shortest)
    if not steps.dt.size:
        raise ValueError("programme: its legs take no time")
    if isinstance(scene.indentation, tuple):
        return _with_times(steps, position, np.asarray(scene.indentation[0], float) - time)
    return steps


def _with_times(steps: Steps, position: float, times: np.ndarray) -> Steps:
    """Return the steps, those at rest cut at the times given."""
    end = np.cumsum(steps.dt)
    resting = steps.position == np.append(position, steps.position[:-1])
    times = times[(times > 0.0) & (times < end[-1])]
    times = times[resting[np.searchsorted(end, times)]]
    every = np.union1d(end, times)
    every = every[np.append(True, np.diff(every) > 1e-9 * np.diff(every).max())]
    every[-1] = end[-1]
    of = np.searchsorted(end, every)
    whole = np.isin(every, end) & np.isin(np.append(0.0, every[:-1]), np.append(0.0, end))
    dt = np.where(whole, steps.dt[of], np.diff(np.append(0.0, every)))
    return Steps(steps.position[of], dt, steps.leg[of])


def indentation_at(scene: SceneCase, times: np.ndarray, datum: float) -> np.ndarray:
    """Return the prescribed indentation over the deepest point, in h; times in tau; that shape.

    datum : height of the deepest point over the mean line, in h.
    """
    if isinstance(scene.indentation, tuple):
        return np.interp(times, *scene.indentation) - datum
    return np.full(np.shape(times), scene.indentation, float) - datum


def check_scene(scene: SceneCase, steps: Steps, resumed: bool) -> None:
    """Raise ValueError for a scene without meaning, or beyond what doubles can resolve."""
    if scene.start not in STARTS:
        raise ValueError(f"start = {scene.start!r}: use one of {STARTS}")
    if unknown := set(scene.asked) - set(ASKED):
        raise ValueError(f"asked = {sorted(unknown)}: use some of {ASKED}")
    if "energy" in scene.asked and scene.scheme != "exponential":
        raise ValueError(f'scheme = {scene.scheme!r}: energy is that of the scheme "exponential"')
    if "contact_lengths" in scene.asked and not np.all(np.diff(scene.edges) > 0.0):
        raise ValueError("edges must increase")
    for name, numbers in (("kept", scene.kept), ("frames", scene.frames)):
        inside = numbers.size == 0 or (numbers[0] >= 0 and numbers[-1] <= steps.dt.size)
        if not (inside and np.all(np.diff(numbers) > 0)):
            raise ValueError(f"{name} must hold increasing numbers of steps, 0 to {steps.dt.size}")
    _check_control(scene, resumed)


def _check_control(scene: SceneCase, resumed: bool) -> None:
    """Raise ValueError where load, indentation or first speed have no meaning."""
    if scene.indentation is None:
        check_range("load", scene.load, LOAD_LIMITS)
    elif not math.isnan(scene.load):
        raise ValueError("load and indentation are both given: one of them follows from the other")
    if scene.start == "steady" and not resumed:
        check_range("first speed", abs(speed_at_start(scene.programme)), SPEED_LIMITS)
