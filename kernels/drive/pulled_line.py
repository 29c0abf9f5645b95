"""Scenes in which a line is pulled through a spring."""

import numpy as np

from ..compile.jit import kernel
from ..lines.line import Line
from ..model.force import ConstantForce
from ..model.friction import weighted_sums
from ..rheology.forms import form_of
from ..rheology.law import Elements, law_of
from ..rheology.retardation import Retardation
from ..scene.initial_state import initial_state
from ..scene.samples import samples_per_contact
from ..scene.scene_case import SceneCase
from .block_rig import block_rig
from .rig import plain_rig
from .shiftable_line import shiftable_line
from .slider import initial_speed, pull_through, recorded_times
from .slider_step import follow_leg
from .spring import Drive

follow_leg_of_line = kernel(follow_leg)


def run_pulled(line: Line, scene: SceneCase, drive: Drive) -> dict[str, np.ndarray]:
    """Pull one line through a scene whose programme moves the drive; return values by name.

    The traces are those of run_scene, for the slider, and "trace_drive_force" (4 G L h^2/dx). They
    are recorded at the times at which the recorded steps would end if the drive moved the line
    itself. "updates" : number of element updates. Raises ValueError for an invalid scene.
    """
    m, n = line.steps_per_spacing, line.z.size
    times, speed = recorded_times(scene, m), initial_speed(scene)
    form = form_of(scene.spectrum, scene.scheme)
    initial = initial_state(line, scene, form)
    control, placed = ConstantForce(scene.load * n), shiftable_line(line.z, line.slope, float(m))
    elements = Elements(initial.memory, initial.p, initial.d)
    rig_of = block_rig if isinstance(form, Retardation) else plain_rig
    rig = rig_of(form, control, placed, elements)
    sign, slope = (-1 if speed < 0.0 else 1), line.slope
    if speed:
        earlier = np.roll(line.slope, -sign)
        slope = slope + law_of(form, 1.0 / (m * abs(speed))).lag * (earlier - slope)
    normal, tangential, touching = weighted_sums(-initial.p, None, slope, 0.0)
    means = normal / n, tangential / n, touching / n
    forces = tangential / normal, initial.d, *means, samples_per_contact(initial.p)
    values, tries = pull_through(follow_leg_of_line, rig, line, forces, drive, scene, times)
    values["trace_indentation"] = values["trace_indentation"] + line.datum
    return values | {"updates": np.array(2.0 * tries * n)}
