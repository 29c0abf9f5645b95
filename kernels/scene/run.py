"""One realization of a scene: the march of a line through it, and the requested values."""

import numpy as np

from ..control.indentation import PrescribedIndentation
from ..lines.line import Line
from ..model.force import ConstantForce
from ..motion.legs import Steps, last_speed, speed_at_start
from ..motion.track import Track, tracks
from ..rheology.forms import Form, form_of
from ..rheology.law import Elements, displacement, law_of
from ..rheology.retardation import Retardation
from .cycles import averaging_window, cycle_mean
from .energy import ENERGIES, EnergyRecord, stored_energy
from .initial_state import initial_state
from .march_blocks import elements_of, in_blocks, march_blocks
from .march_elements import march_elements
from .records import (
    TRACES,
    ContactLengths,
    Snapshots,
    Trace,
    count_lengths,
    record_snapshot,
    record_trace,
)
from .scene_case import ZERO_ORIGIN, SavedState, SceneCase, check_scene, indentation_at, scene_steps


class Recorders:
    """Recorders of a scene; those that are not requested are None."""

    def __init__(self, scene: SceneCase, line: Line, steps: Steps) -> None:
        """Allocate the arrays of all requested values."""
        requested, count, n = scene.requested, scene.recorded.size, line.z.size
        self.recorded, self.frames = scene.recorded, scene.frames
        self.trace = Trace(*np.empty((len(TRACES), count))) if "trace" in requested else None
        self.energies = None
        if "energy" in requested:
            self.energies = EnergyRecord(np.zeros((4, count)), np.zeros(3))
        self.lengths = None
        if "contact_lengths" in requested:
            bins = max(scene.edges.size - 1, 0)
            self.lengths = ContactLengths(scene.edges * line.steps_per_spacing, np.zeros(bins))
        self.snapshots = None
        if "snapshots" in requested:
            self.snapshots = Snapshots(*np.empty((2, scene.frames.size, n)))
        self.window = averaging_window(scene, steps)

    def record_start(
        self, form: Form, line: Line, track: Track, elements: Elements, lag: float, speed: float
    ) -> None:
        """Record the start if step 0 is requested.

        lag : of the steady step before the start, signed. speed : initial speed of the programme.
        """
        z, slope = (values[track.line[0], track.begin[0] :][: line.z.size] for values in track[:2])
        memory, p, d = elements
        if self.recorded.size and self.recorded[0] == 0:
            if self.trace is not None:
                before = np.roll(slope, -1 if lag > 0.0 else 1)
                trace = self.trace
                record_trace(trace, 0, abs(lag), before, slope, d, d, p)
                trace.time[0], trace.distance[0] = track.time[0], track.place[0]
                trace.velocity[0] = speed
            if self.energies is not None:
                self.energies.energies[0, 0] = stored_energy(form, memory, p)
            if self.lengths is not None:
                count_lengths(self.lengths, p)
        if self.snapshots is not None and self.frames.size and self.frames[0] == 0:
            record_snapshot(self.snapshots, 0, z, d, displacement(form, memory, p))

    def arguments(self) -> tuple:
        """Return the last arguments of march_elements and march_blocks."""
        recorders = (self.trace, self.energies, self.lengths, self.snapshots, self.window)
        return self.recorded, self.frames, *recorders

    def values(self, datum: float) -> dict[str, np.ndarray]:
        """Return the recorded values by name; datum : of the Line."""
        values: dict[str, np.ndarray] = {}
        if self.trace is not None:
            values |= zip(TRACES, self.trace, strict=True)
            values["trace_indentation"] = self.trace.indentation + datum
        if self.energies is not None:
            values |= zip(ENERGIES, self.energies.energies, strict=True)
        if self.lengths is not None:
            values["contact_length"] = self.lengths.counts / max(self.recorded.size, 1)
        if self.snapshots is not None:
            values["snapshot_height"], values["snapshot_displacement"] = self.snapshots
        return values | cycle_mean(self.window)


def run_scene(
    line: Line, scene: SceneCase, state: SavedState | None = None
) -> dict[str, np.ndarray]:
    """March one line through a scene; return the requested values by name.

    The argument ``state`` replaces the start of the scene; step numbers then count from there.

    trace : "trace_mu" (h/dx), "trace_indentation" (h over the mean line), "trace_normal_force"
    (4 G L h), "trace_friction_force" (4 G L h^2/dx), "trace_contact_fraction", and the motion of
    this line: "trace_time" (tau), "trace_distance" (dx), "trace_velocity" (dx/tau), each
    (recorded,). mu is NaN if nothing touches; step 0 has the initial velocity of the programme.
    energy : "stored_energy", "dissipated_energy", "work", "closing_work" (4 G L h^2), (recorded,);
    all but the first are sums since the start.
    cycle_mean : "mu_cycle_mean", mean friction over mean normal force (h/dx) in the second half of
    the cycles of the last oscillation.
    contact_lengths : "contact_length" (bins,), mean number of contacts over the recorded steps.
    snapshots : "snapshot_height" (line over the undeformed foundation) and
    "snapshot_displacement" (of the elements), (frames, n), in h.
    state : the fields of SavedState as "state_memory", "state_p", ….
    "updates" : number of element updates, as if all elements were stepped.
    Raises ValueError for an invalid scene.
    """
    m, z, slope = line.steps_per_spacing, line.z, line.slope
    steps = scene_steps(scene, m, state.origin if state else ZERO_ORIGIN)
    check_scene(scene, steps, state is not None)
    form = form_of(scene.spectrum, scene.scheme)
    initial = state or initial_state(line, scene, form)
    control: ConstantForce | PrescribedIndentation = ConstantForce(scene.load * z.size)
    if scene.indentation is not None:
        times = np.cumsum(np.append(initial.time, steps.dt))[1:]
        control = PrescribedIndentation(indentation_at(scene, times, line.datum))
    elements = Elements(initial.memory, initial.p, initial.d)
    recorders = Recorders(scene, line, steps)
    lag, speed = 0.0, speed_at_start(scene.programme)
    if state is None and scene.start == "steady":
        lag = np.copysign(law_of(form, 1.0 / (m * abs(speed))).lag, speed)
    done, updates, time = 0, 0, initial.time
    ends = np.flatnonzero(np.diff(steps.leg, append=-1)) + 1  # steps at which legs end
    blocks = in_blocks(elements, 0) if isinstance(form, Retardation) else None
    for track in tracks(z, slope, m, steps, initial.position, initial.time):
        if done == 0:
            recorders.record_start(form, line, track, elements, lag, speed)
        arguments = recorders.arguments()
        if blocks is None:
            elements, passes = march_elements(form, control, track, elements, done, *arguments)
        else:
            blocks, passes = march_blocks(form, control, track, blocks, done, ends, *arguments)
        updates += (passes + track.dt.size) * z.size
        done += track.dt.size
        time = float(track.time[-1])
    values = recorders.values(line.datum) | {"updates": np.array(float(updates))}
    if "state" in scene.requested:
        position = float(steps.position[-1])
        speed = last_speed(scene.programme[-1])
        last: Elements = elements if blocks is None else elements_of(blocks, z.size)
        saved = SavedState(*last, position, time, speed)
        values |= {f"state_{name}": np.asarray(value) for name, value in saved._asdict().items()}
    return values
