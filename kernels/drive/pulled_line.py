"""A line that is pulled: its elements, how it begins, and what is kept of it."""

import numpy as np

from ..compile.jit import kernel
from ..lines.line import Line
from ..model.force import ConstantForce
from ..model.friction import weighted_sums
from ..rheology.forms import form_of
from ..rheology.law import Elements, law_of
from ..rheology.retardation import Retardation
from ..scene.begin import begun
from ..scene.samples import samples_per_contact
from ..scene.scene_case import SceneCase
from .block_rig import block_rig
from .posed_line import posed
from .rig import plain_rig
from .slider import Start, kept_times, pull_through, steady_speed
from .spring import Drive
from .step import follow_leg

follow_line = kernel(follow_leg)


def run_pulled(line: Line, scene: SceneCase, drive: Drive) -> dict[str, np.ndarray]:
    """Pull one line through a scene, whose programme is that of the drive; return its traces.

    They are those of run_scene, of the slider, at the times at which a slider that is held by the
    drive would end the steps that are kept; and "trace_drive_force" (4 G L h^2/dx).
    "updates" : of elements. Raises ValueError for a scene without meaning.
    """
    m, n = line.steps_per_spacing, line.z.size
    times, speed = kept_times(scene, m), steady_speed(scene)
    form = form_of(scene.spectrum, scene.scheme)
    begin = begun(line, scene, form)
    control, place = ConstantForce(scene.load * n), posed(line.z, line.slope, float(m))
    elements = Elements(begin.memory, begin.p, begin.d)
    rig_of = block_rig if isinstance(form, Retardation) else plain_rig
    rig = rig_of(form, control, place, elements)
    way, slope = (-1 if speed < 0.0 else 1), line.slope
    if speed:
        earlier = np.roll(line.slope, -way)
        slope = slope + law_of(form, 1.0 / (m * abs(speed))).lag * (earlier - slope)
    normal, tangential, touching = weighted_sums(-begin.p, None, slope, 0.0)
    means = normal / n, tangential / n, touching / n
    forces = tangential / normal, begin.d, *means, samples_per_contact(begin.p)
    start = Start(rig, m, line.slope, forces)
    found, tries = pull_through(follow_line, start, drive, scene, times)
    found["trace_indentation"] = found["trace_indentation"] + line.datum
    return found | {"updates": np.array(2.0 * tries * n)}
