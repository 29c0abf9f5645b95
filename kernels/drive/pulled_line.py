"""A line that is pulled: its elements, how it begins, and what is kept of it."""

import math
from functools import lru_cache, partial

import numpy as np

from ..lines.line import Line
from ..model.force import ConstantForce
from ..model.friction import weighed
from ..motion.fourier import Fractions
from ..rheology.forms import form_of
from ..rheology.law import law_of
from ..rheology.retardation import Retardation
from ..scene.begin import begun
from ..scene.scene_case import SceneCase
from .rig import Pose, Rig
from .slider import Pulled, first_moment, kept_times, pull_through, steady_speed
from .spring import Drive
from .step import slide_by_samples

SPARE = 0.02  # of the indentation, to what is looked at of a line above it


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
    spare = SPARE * (begin.d - line.z.min()) if isinstance(form, Retardation) else np.inf
    rig = Rig(
        form,
        ConstantForce(scene.load * n),
        begin.memory.copy(),
        begin.p.copy(),
        np.empty(n),
        np.empty(n),
        np.empty(n, np.int64),
        np.array([begin.d, begin.d, np.inf, spare]),
    )
    way, start = (-1 if speed < 0.0 else 1), line.slope
    if speed:
        earlier = np.roll(line.slope, -way)
        start = start + law_of(form, 1.0 / (m * abs(speed))).lag * (earlier - start)
    normal, tangential, touching = weighed(-rig.p, None, start, 0.0)
    share = normal / n, tangential / n, touching / n
    first = first_moment(tangential / normal, begin.d, *share, speed)
    slide = partial(slide_by_samples, rig, np.tile(line.z, 2), np.tile(line.slope, 2), m)
    scale = scene.load * math.sqrt(float(np.mean(line.slope**2)))
    pulled = Pulled(rig, PosedLine(line).pose, slide, m, scale, first)
    found, tries = pull_through(pulled, drive, scene, times)
    found["trace_indentation"] = found["trace_indentation"] + line.datum
    return found | {"updates": np.array(2.0 * tries * n)}


class PosedLine:
    """A line at any place, as the elements of a foundation at rest see it."""

    def __init__(self, line: Line) -> None:
        """Take a line as it is at place zero."""
        self.fractions = Fractions(line.z, line.slope, line.steps_per_spacing)
        self.at = lru_cache(maxsize=4)(self._at)

    def pose(self, before: float, after: float) -> Pose:
        """Return the pose of a step from one place to another, in samples."""
        z, slope = self.at(after)
        return Pose(z, self.at(before)[1], slope)

    def _at(self, place: float) -> tuple[np.ndarray, np.ndarray]:
        """Return heights and slopes at the elements."""
        whole = math.floor(place)
        z, slope = self.fractions.at(place - whole)
        return np.roll(z, whole), np.roll(slope, whole)
