"""One realization of a scene: a line, a material, a programme of motion, and what is asked of it."""

from typing import NamedTuple

import numpy as np

from kernels.motion.programme import Programme
from kernels.surfaces.line import Line


class Scene(NamedTuple):
    """What one line is taken through. Lengths along x in dx, heights in h, times in tau."""

    spectrum: object  # of the elastomer (rheology/spectrum.py)
    scheme: str  # "exponential" or "implicit-euler"
    programme: Programme
    load: float  # Fbar = F_N / (4 G L h); NaN where the indentation is prescribed
    indentation: tuple[tuple[float, ...], tuple[float, ...]] | float | None
    # None: constant force. A number: constant, in h over the mean line. (times, values): d(t).
    start: str  # "steady" | "relaxed" | "fresh"
    asked: tuple[str, ...]  # of ASKED
    kept: np.ndarray  # numbers of the steps at which a trace is kept; 0 is the start
    edges: np.ndarray  # of the bins of contact lengths, shape (bins + 1,), in dx
    frames: np.ndarray  # numbers of the steps at which a snapshot is taken; 0 is the start


ASKED = ("trace", "energy", "contact_lengths", "snapshots", "state")


class Saved(NamedTuple):
    """What a programme needs to go on to the bit."""

    memory: np.ndarray  # internal variables of the elements
    p: np.ndarray  # shape (n,): their pressures, in 4 G h of a sample
    d: float  # indentation, in h over the deepest point of the line
    position: float  # of the line, in samples
    time: float  # in tau
    speed: float  # of the leg before, in dx/tau


def trace_stamps(scene: Scene, steps_per_spacing: int) -> dict[str, np.ndarray]:
    """Return when and where a trace is kept: the same for every line, each of shape (kept,).

    "time" (in tau), "distance" (of the line, in dx), "speed" (in dx/tau) and "leg" (int; that of
    the first step at the start). Forces of a step act law.lag of it before its end.
    """
    raise NotImplementedError


def run_scene(line: Line, scene: Scene, state: Saved | None = None) -> dict[str, np.ndarray]:
    """Take one line through a scene; return the values asked for, by name.

    trace : "trace_mu" (h/dx), "trace_indentation" (h over the mean line), "trace_normal_force"
    (4 G L h), "trace_friction_force" (4 G L h^2/dx), "trace_contact_fraction", each (kept,).
    energy : "stored_energy", "dissipated_energy", "work", "closing_work" (4 G L h^2), (kept,);
    all but the first are sums from the start.
    contact_lengths : "contact_length" (bins,), mean number of contacts over the kept steps.
    snapshots : "snapshot_height" (line over the undeformed foundation) and
    "snapshot_displacement" (of the elements), (frames, n), in h.
    state : "state_memory", "state_pressure" and "state_scalars" (d, position, time, speed).
    Raises ValueError for a scene without meaning.
    """
    raise NotImplementedError
