"""Recorders that a scene requests, and the values that they hold in the end."""

from typing import Any

import numpy as np

from ..body.step import Forces
from ..motion.legs import Steps, speed_at_start
from ..rheology.forms import Form
from ..rheology.law import Elements
from .cycles import averaging_window, cycle_mean
from .energy import ENERGIES, EnergyRecord, stored_energy
from .records import TRACES, ContactLengths, Trace, count_lengths, record_trace
from .scene_case import SceneCase


class Recorders:
    """Recorders of a scene; those that are not requested are None."""

    def __init__(self, scene: SceneCase, m: int, steps: Steps, frames: Any) -> None:
        """Allocate the arrays of all requested values; frames : recorder of snapshots."""
        requested, count = scene.requested, scene.recorded.size
        self.recorded, self.frames = scene.recorded, scene.frames
        self.starts = bool(count and scene.recorded[0] == 0)  # whether step 0 is recorded
        self.ends = np.flatnonzero(np.diff(steps.leg, append=-1)) + 1  # steps at which legs end
        self.speed = speed_at_start(scene.programme)
        self.trace = Trace(*np.empty((len(TRACES), count))) if "trace" in requested else None
        self.energies = None
        if "energy" in requested:
            self.energies = EnergyRecord(np.zeros((4, count)), np.zeros(3))
        self.lengths = None
        if "contact_lengths" in requested:
            bins = max(scene.edges.size - 1, 0)
            self.lengths = ContactLengths(scene.edges * m, np.zeros(bins))
        self.snapshots = frames if "snapshots" in requested else None
        self.window = averaging_window(scene, steps)
        self.sheared = scene.effects.shear is not None

    def record_start(self, track: Any, acting: Forces, d: float, width: float) -> None:
        """Record the trace of the start, if step 0 is requested.

        acting, d, width : Forces, indentation and patch width of the step before.
        """
        if self.trace is not None and self.starts:
            record_trace(self.trace, 0, 0.0, acting, d, d, width)
            self.trace.time[0], self.trace.distance[0] = track.time[0], track.place[0]
            self.trace.velocity[0] = self.speed

    def record_elements(self, form: Form, elements: Elements) -> None:
        """Record energy and contact lengths of the start, if step 0 is requested."""
        if self.energies is not None and self.starts:
            self.energies.energies[0, 0] = stored_energy(form, elements.memory, elements.p)
        if self.lengths is not None and self.starts:
            count_lengths(self.lengths, elements.p)

    def arguments(self) -> tuple:
        """Return the last arguments of march_track."""
        recorders = (self.trace, self.energies, self.lengths, self.snapshots, self.window)
        return self.ends, self.recorded, self.frames, *recorders

    def values(self) -> dict[str, np.ndarray]:
        """Return the recorded values by name, apart from snapshots."""
        values: dict[str, np.ndarray] = {}
        if self.trace is not None:
            values |= zip(TRACES, self.trace, strict=True)
        if self.energies is not None:
            values |= zip(ENERGIES, self.energies.energies, strict=True)
        if self.lengths is not None:
            values["contact_length"] = self.lengths.counts / max(self.recorded.size, 1)
        return values | cycle_mean(self.window, self.sheared)
