"""One realization of a scene: the march of a line through it, and the requested values."""

import numpy as np

from ..body.element_line import element_line
from ..body.force_means import forces_at_start
from ..body.patch_width import samples_per_contact
from ..body.step import elements_of, on_ground
from ..compile.jit import kernel
from ..control.indentation import PrescribedIndentation
from ..lines.line import Line
from ..model.force import ConstantForce
from ..motion.legs import Steps, last_speed
from ..motion.track import Track, tracks
from ..quick.blocks import block_line
from ..rheology.forms import Form, form_of
from ..rheology.law import Elements, displacement
from ..rheology.retardation import Retardation
from .carried import carried_branches
from .initial_state import initial_state, steady_lag
from .march_body import march_line
from .recorders import Recorders
from .records import Snapshots
from .scene_case import ZERO_ORIGIN, SavedState, SceneCase, check_scene, indentation_at, scene_steps

Control = ConstantForce | PrescribedIndentation


@kernel
def elements_of_line(body, state):
    """Return the Elements of a line, for Python."""
    return elements_of(body, state)


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
    m, z = line.steps_per_spacing, line.z
    steps = scene_steps(scene, m, state.origin if state else ZERO_ORIGIN)
    check_scene(scene, steps, state is not None)
    form = form_of(scene.spectrum, scene.scheme)
    moving = scene.start, scene.spectrum, scene.programme
    initial = state or initial_state(line, scene, form, carried_branches(*moving, z.size / m))
    frames = Snapshots(*np.empty((2, scene.frames.size, z.size)))
    recorders = Recorders(scene, m, steps, frames)
    stages = tracks(z, line.slope, m, steps, initial.position, initial.time)
    track = next(stages)
    lag = 0.0 if state else steady_lag(scene, form, m)
    record_start(recorders, frames, form, initial, track, lag)
    elements = Elements(initial.memory, initial.p, initial.d)
    line_of = block_line if isinstance(form, Retardation) else element_line
    body, moved = line_of(form, control_of(scene, line, steps, initial.time), track, elements)
    moved = march_line(body, moved, track, 0, *recorders.arguments())
    done = track.dt.size
    for track in stages:
        body, moved = on_ground(body, moved, track)
        moved = march_line(body, moved, track, done, *recorders.arguments())
        done += track.dt.size
    values = recorders.values() | {"updates": np.array(float((moved.passes + done) * z.size))}
    if "trace" in scene.requested:
        values["trace_indentation"] += line.datum
    if "snapshots" in scene.requested:
        values["snapshot_height"], values["snapshot_displacement"] = frames
    if "state" in scene.requested:
        position, time = float(steps.position[-1]), float(track.time[-1])
        memory, p, d = elements_of_line(body, moved)
        saved = SavedState(memory, p, d, position, time, last_speed(scene.programme[-1]))
        values |= {f"state_{name}": np.asarray(value) for name, value in saved._asdict().items()}
    return values


def control_of(scene: SceneCase, line: Line, steps: Steps, start: float) -> Control:
    """Return the control of a scene; start : time before its first step, in tau."""
    if scene.indentation is None:
        return ConstantForce(scene.load * line.z.size)
    times = np.cumsum(np.append(start, steps.dt))[1:]
    return PrescribedIndentation(indentation_at(scene, times, line.datum))


def record_start(
    recorders: Recorders,
    frames: Snapshots,
    form: Form,
    initial: SavedState,
    track: Track,
    lag: float,
) -> None:
    """Record the state of a line before its first step; lag : of the steady step before it."""
    n = initial.p.size
    z, slope = (values[track.line[0], track.begin[0] :][:n] for values in track[:2])
    acting = forces_at_start(initial.p, slope, lag)
    recorders.record_start(track, acting, initial.d, samples_per_contact(initial.p))
    recorders.record_elements(form, Elements(initial.memory, initial.p, initial.d))
    if recorders.frames.size and recorders.frames[0] == 0:
        frames.height[0] = z - initial.d
        frames.displacement[0] = displacement(form, initial.memory, initial.p)
