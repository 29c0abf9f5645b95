"""A line that is pulled: its elements, how it begins, and what is kept of it."""

import math
from functools import lru_cache, partial

import numpy as np

from ..compile.jit import kernel
from ..lines.line import Line
from ..model.force import ConstantForce
from ..model.friction import weighed
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
    """A line at any place, as the elements of a foundation at rest see it.

    Between samples it is the polynomial of fifth degree that has the height, slope and curvature of
    both: of a wave of eight samples, the shortest at m = 4, to 1e-5 of its height.
    """

    def __init__(self, line: Line) -> None:
        """Take a line as it is at place zero."""
        m, z = line.steps_per_spacing, line.z
        q = 2.0j * np.pi * m / z.size * np.arange(z.size // 2 + 1)
        curvature = np.fft.irfft(q * np.fft.rfft(line.slope), z.size)
        self.nodes = np.tile(np.stack([z, line.slope / m, curvature / m**2]), 2)
        self.steps_per_spacing = m
        self.at = lru_cache(maxsize=4)(self._at)

    def pose(self, before: float, after: float) -> Pose:
        """Return the pose of a step from one place to another, in samples."""
        z, slope = self.at(after)
        return Pose(z, self.at(before)[1], slope)

    def _at(self, place: float) -> tuple[np.ndarray, np.ndarray]:
        """Return heights and slopes at the elements."""
        whole = math.floor(place)
        n, fraction = self.nodes.shape[1] // 2, place - whole
        left, right = -(whole + 1) % n, -whole % n
        found = np.empty((2, n))
        between(self.nodes[:, left : left + n], self.nodes[:, right : right + n], fraction, found)
        found[1] *= self.steps_per_spacing
        return found[0], found[1]


@kernel
def between(left, right, fraction, found):
    """Fill found, shape (2, n), with heights and their derivatives, a fraction left of a node.

    left, right : height and its two derivatives at the nodes of each interval, shape (3, n), where
    an interval has the length 1.
    """
    t, f = 1.0 - fraction, fraction
    a0, b0 = f**3 * (1.0 + 3.0 * t + 6.0 * t * t), t**3 * (1.0 + 3.0 * f + 6.0 * f * f)
    a1, b1 = t * f**3 * (1.0 + 3.0 * t), -f * t**3 * (1.0 + 3.0 * f)
    a2, b2 = 0.5 * t * t * f**3, 0.5 * f * f * t**3
    c0 = 30.0 * t * t * f * f
    c1, d1 = f * f * (1.0 + 5.0 * t) * (1.0 - 3.0 * t), t * t * (1.0 + 5.0 * f) * (1.0 - 3.0 * f)
    c2, d2 = 0.5 * t * f * f * (2.0 - 5.0 * t), -0.5 * f * t * t * (2.0 - 5.0 * f)
    for i in range(found.shape[1]):
        z, s, c = left[0, i], left[1, i], left[2, i]
        y, r, b = right[0, i], right[1, i], right[2, i]
        found[0, i] = a0 * z + b0 * y + (a1 * s + b1 * r) + (a2 * c + b2 * b)
        found[1, i] = c0 * (y - z) + (c1 * s + d1 * r) + (c2 * c + d2 * b)
