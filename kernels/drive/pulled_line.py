"""Scenes in which a line is pulled through a spring."""

import numpy as np

from ..body.element_line import element_line
from ..body.force_means import forces_at_start
from ..body.patch_width import samples_per_contact
from ..body.shiftable_line import shiftable_line
from ..compile.jit import kernel
from ..lines.line import Line
from ..model.force import ConstantForce
from ..quick.blocks import block_line
from ..rheology.forms import form_of
from ..rheology.law import Elements
from ..rheology.retardation import Retardation
from ..scene.initial_state import initial_state, steady_lag
from ..scene.scene_case import SceneCase
from .pulled_slider import pull_through, recorded_times
from .slider_step import follow_leg
from .spring import Drive

follow_leg_of_line = kernel(follow_leg)


def run_pulled(line: Line, scene: SceneCase, drive: Drive) -> dict[str, np.ndarray]:
    """Pull one line through a scene whose programme moves the drive; return values by name.

    The traces are those of run_scene and "trace_drive_force" (4 G L h^2/dx). They describe the
    slider, at the times of the recorded steps of the same scene without a spring.
    "updates" : number of element updates. Raises ValueError for an invalid scene.
    """
    m, n = line.steps_per_spacing, line.z.size
    times = recorded_times(scene, m)
    form = form_of(scene.spectrum, scene.scheme)
    initial = initial_state(line, scene, form)
    control, ground = ConstantForce(scene.load * n), shiftable_line(line.z, line.slope, float(m))
    line_of = block_line if isinstance(form, Retardation) else element_line
    elements = Elements(initial.memory, initial.p, initial.d)
    body, state = line_of(form, control, ground, elements)
    acting = forces_at_start(initial.p, line.slope, steady_lag(scene, form, m))
    width = samples_per_contact(initial.p)
    start = body, state, line, acting, width
    values, _, tries = pull_through(*start, drive, scene, times, follow_leg_of_line)
    values["trace_indentation"] = values["trace_indentation"] + line.datum
    return values | {"updates": np.array(2.0 * tries * n)}
