"""One realization of a scene: a line is taken through it, and what is asked for is kept."""

import numpy as np

from ..control.indentation import PrescribedIndentation
from ..lines.line import Line
from ..model.force import ConstantForce
from ..motion.legs import Steps, last_speed, speed_at_start
from ..motion.track import Track, tracks
from ..rheology.forms import Form, form_of
from ..rheology.law import Elements, displacement, law_of
from ..rheology.retardation import Retardation
from .begin import begun
from .cycles import mean_of, spell_of
from .energy import ENERGIES, Ledger, stored_energy
from .follow import follow
from .march_blocks import elements_of, follow_blocks, in_blocks
from .records import TRACES, Film, Lengths, Trace, count_lengths, keep_frame, keep_trace
from .scene_case import (
    START,
    Saved,
    SceneCase,
    check_scene,
    indentation_at,
    scene_steps,
)


class Recorders:
    """The recorders of a scene; those that are not asked for are None."""

    def __init__(self, scene: SceneCase, line: Line, steps: Steps) -> None:
        """Make room for all that is asked for."""
        asked, kept, n = scene.asked, scene.kept.size, line.z.size
        self.kept, self.frames = scene.kept, scene.frames
        self.trace = Trace(*np.empty((len(TRACES), kept))) if "trace" in asked else None
        self.ledger = Ledger(np.zeros((4, kept)), np.zeros(3)) if "energy" in asked else None
        self.lengths = None
        if "contact_lengths" in asked:
            bins = max(scene.edges.size - 1, 0)
            self.lengths = Lengths(scene.edges * line.steps_per_spacing, np.zeros(bins))
        self.film = None
        if "snapshots" in asked:
            self.film = Film(*np.empty((2, scene.frames.size, n)))
        self.spell = spell_of(scene, steps)

    def start(
        self, form: Form, line: Line, track: Track, elements: Elements, lag: float, speed: float
    ) -> None:
        """Keep the start itself, where step 0 is asked for.

        lag : of the steady step before it. speed : that with which the programme begins.
        """
        z, slope = (values[track.line[0], track.begin[0] :][: line.z.size] for values in track[:2])
        memory, p, d = elements
        if self.kept.size and self.kept[0] == 0:
            if self.trace is not None:
                before = np.roll(slope, -1 if lag > 0.0 else 1)
                trace = self.trace
                keep_trace(trace, 0, abs(lag), before, slope, d, d, p)
                trace.time[0], trace.distance[0] = track.time[0], track.place[0]
                trace.velocity[0] = speed
            if self.ledger is not None:
                self.ledger.kept[0, 0] = stored_energy(form, memory, p)
            if self.lengths is not None:
                count_lengths(self.lengths, p)
        if self.film is not None and self.frames.size and self.frames[0] == 0:
            keep_frame(self.film, 0, z, d, displacement(form, memory, p))

    def all(self) -> tuple:
        """Return the last arguments of follow."""
        recorders = (self.trace, self.ledger, self.lengths, self.film, self.spell)
        return self.kept, self.frames, *recorders

    def values(self, datum: float) -> dict[str, np.ndarray]:
        """Return what was kept, by name; datum : as of a Line."""
        values: dict[str, np.ndarray] = {}
        if self.trace is not None:
            values |= zip(TRACES, self.trace, strict=True)
            values["trace_indentation"] = self.trace.indentation + datum
        if self.ledger is not None:
            values |= zip(ENERGIES, self.ledger.kept, strict=True)
        if self.lengths is not None:
            values["contact_length"] = self.lengths.counts / max(self.kept.size, 1)
        if self.film is not None:
            values["snapshot_height"], values["snapshot_displacement"] = self.film
        return values | mean_of(self.spell)


def run_scene(line: Line, scene: SceneCase, state: Saved | None = None) -> dict[str, np.ndarray]:
    """Take one line through a scene; return the values asked for, by name.

    state : to go on from, instead of the start of the scene; numbers of steps count from there.

    trace : "trace_mu" (h/dx), "trace_indentation" (h over the mean line), "trace_normal_force"
    (4 G L h), "trace_friction_force" (4 G L h^2/dx), "trace_contact_fraction", and when and where
    that was on this line: "trace_time" (tau), "trace_distance" (dx), "trace_velocity" (dx/tau),
    each (kept,). mu is NaN where nothing touches; the start has the velocity that follows.
    energy : "stored_energy", "dissipated_energy", "work", "closing_work" (4 G L h^2), (kept,);
    all but the first are sums from the start.
    cycle_mean : "mu_cycle_mean", mean friction over mean normal force (h/dx) in the later half of
    the cycles of the last oscillation.
    contact_lengths : "contact_length" (bins,), mean number of contacts over the kept steps.
    snapshots : "snapshot_height" (line over the undeformed foundation) and
    "snapshot_displacement" (of the elements), (frames, n), in h.
    state : the fields of Saved as "state_memory", "state_p", ….
    "updates" : of elements, were all of them moved. Raises ValueError for a scene without meaning.
    """
    m, z, slope = line.steps_per_spacing, line.z, line.slope
    steps = scene_steps(scene, m, state.origin if state else START)
    check_scene(scene, steps, state is not None)
    form = form_of(scene.spectrum, scene.scheme)
    begin = state or begun(line, scene, form)
    control: ConstantForce | PrescribedIndentation = ConstantForce(scene.load * z.size)
    if scene.indentation is not None:
        times = np.cumsum(np.append(begin.time, steps.dt))[1:]
        control = PrescribedIndentation(indentation_at(scene, times, line.datum))
    elements = Elements(begin.memory, begin.p, begin.d)
    recorders = Recorders(scene, line, steps)
    lag, speed = 0.0, speed_at_start(scene.programme)
    if state is None and scene.start == "steady":
        lag = np.copysign(law_of(form, 1.0 / (m * abs(speed))).lag, speed)
    done, updates, time = 0, 0, begin.time
    ends = np.flatnonzero(np.diff(steps.leg, append=-1)) + 1  # steps at which legs end
    blocks = in_blocks(elements, 0) if isinstance(form, Retardation) else None
    for track in tracks(z, slope, m, steps, begin.position, begin.time):
        if done == 0:
            recorders.start(form, line, track, elements, lag, speed)
        kept = recorders.all()
        if blocks is None:
            elements, passes = follow(form, control, track, elements, done, *kept)
        else:
            blocks, passes = follow_blocks(form, control, track, blocks, done, ends, *kept)
        updates += (passes + track.dt.size) * z.size
        done += track.dt.size
        time = float(track.time[-1])
    values = recorders.values(line.datum) | {"updates": np.array(float(updates))}
    if "state" in scene.asked:
        position = float(steps.position[-1])
        speed = last_speed(scene.programme[-1])
        last: Elements = elements if blocks is None else elements_of(blocks, z.size)
        saved = Saved(*last, position, time, speed)
        values |= {f"state_{name}": np.asarray(value) for name, value in saved._asdict().items()}
    return values
