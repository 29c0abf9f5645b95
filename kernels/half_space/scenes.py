"""Scenes on a half-space: a surface moves over it according to a programme.

The steps are those of a line (scene/scene_case.py). At whole samples the given surface lies over
other elements; between samples it is shifted along x by Fourier (motion/fourier.py).
"""

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ..model.friction import weighted_sums
from ..motion.fourier import FractionalShifts
from ..motion.legs import speed_at_start
from ..rheology.forms import form_of
from ..rheology.law import law_of
from ..scene.cycles import add_impulses, averaging_window, cycle_mean
from ..scene.initial_state import charge_branches, glassy_stiffness
from ..scene.records import TRACES, Trace, record_forces, record_motion
from ..scene.scene_case import SavedState, SceneCase, check_scene, scene_steps
from .body import Body, HalfSpace, advance_body, rest_on, step_tolerance
from .patches import samples_per_patch
from .sliding_body import slide_steadily
from .surface import Surface

HALF_SPACE_QUANTITIES = ("trace", "cycle_mean", "snapshots")


class SurfacePath(NamedTuple):
    """Motion of the surface, with the fields of a Track (motion/track.py)."""

    place: np.ndarray  # in dx, shape (S + 1,)
    time: np.ndarray  # in tau, shape (S + 1,)
    dt: np.ndarray  # in tau, shape (S,)


class ShiftedSurface:
    """A surface at any position along x."""

    def __init__(self, surface: Surface) -> None:
        """Prepare shifts of a surface whose samples are given at position zero."""
        self.surface = surface
        self.at = FractionalShifts(*surface[:3]).at

    def slopes_over(self, place: float, offset: int) -> np.ndarray:
        """Return the slopes at a position, over the elements under the samples at ``offset``."""
        whole = math.floor(place)
        return np.roll(self.at(place - whole)[1], whole - offset, axis=1)


def run_scene_on_half_space(
    surface: Surface,
    scene: SceneCase,
    state: SavedState | None = None,
    stiffness: np.ndarray | None = None,
) -> dict[str, np.ndarray]:
    """Run a scene on a half-space; return the requested values by name, as for a line.

    trace : as for a line (scene/run.py), with forces in E* L h and E* L h^2/dx. snapshots :
    "snapshot_pressure" (frames, rows, n), in E* h/dx, at the elements of the half-space.
    "updates" : samples times passes of the operator. stiffness : of every mode, or None for the
    |q|/2 of a half-space. Raises ValueError for an invalid scene, and for quantities that are not
    available on a half-space.
    """
    if state is not None or set(scene.requested) - set(HALF_SPACE_QUANTITIES):
        raise ValueError(
            f"requested = {sorted(scene.requested)}: "
            f"a half-space has only {HALF_SPACE_QUANTITIES}, and cannot resume from a state"
        )
    m, n = surface.steps_per_spacing, surface.z.shape[1]
    steps = scene_steps(scene, m)
    check_scene(scene, steps, False)
    form = form_of(scene.spectrum, scene.scheme)
    space = HalfSpace.under(form, surface, scene.load, stiffness)
    shifted = ShiftedSurface(surface)
    body, passes, lag = initial_body(space, scene)
    trace = Trace(*np.empty((len(TRACES), scene.recorded.size)))
    window = averaging_window(scene, steps)
    frame_count = scene.frames.size if "snapshots" in scene.requested else 0
    frames = np.empty((frame_count, *surface.z.shape))
    row_of_step = {int(number): k for k, number in enumerate(scene.recorded)}
    frame_of_step = {int(number): k for k, number in enumerate(scene.frames[:frame_count])}
    places = np.append(0.0, steps.position)
    path = SurfacePath(places / m, np.cumsum(np.append(0.0, steps.dt)), steps.dt)
    law_at = lru_cache(maxsize=16)(lambda dt: law_of(form, dt))
    for step in range(places.size):
        old = body.d
        if step:
            law = law_at(steps.dt[step - 1])
            lag, place = law.lag, float(places[step])
            whole = math.floor(place)
            heights = shifted.at(place - whole)[0]
            tolerance = step_tolerance(scene.spectrum, law)
            body, used = advance_body(space, body, law, heights, whole % n, tolerance)
            passes += used
        is_averaged = window is not None and window.after < step <= window.last
        if is_averaged or step in row_of_step:
            before = places[step - 1] if step else -math.copysign(1.0, lag)
            lag = abs(lag)
            earlier, now = (
                shifted.slopes_over(place, body.offset).ravel() for place in (before, places[step])
            )
            sums = weighted_sums(-body.p.ravel(), None, now + lag * (earlier - now), 0.0)
        if is_averaged:
            add_impulses(window, sums, path.dt[step - 1])
        if step in row_of_step:
            k = row_of_step[step]
            record_forces(trace, k, lag, sums, body.p.size, old, body.d)
            trace.samples_per_contact[k] = samples_per_patch(body.p)
            trace.normal_force[k] *= n / m  # times the side of the surface, in dx
            trace.friction_force[k] *= n / m
            if step:
                record_motion(trace, k, lag, path, step - 1)
            else:
                trace.time[k], trace.distance[k] = 0.0, 0.0
                trace.velocity[k] = speed_at_start(scene.programme)
        if step in frame_of_step:
            frames[frame_of_step[step]] = np.roll(body.p, body.offset, axis=1)
    values = dict(zip(TRACES, trace, strict=True)) if "trace" in scene.requested else {}
    if "snapshots" in scene.requested:
        values["snapshot_pressure"] = frames
    return values | cycle_mean(window) | {"updates": np.array(float(passes * surface.z.size))}


def initial_body(space: HalfSpace, scene: SceneCase) -> tuple[Body, int, float]:
    """Return (body before the first step, passes, signed lag of the step before)."""
    if scene.start == "steady":
        speed = speed_at_start(scene.programme)
        one = slide_steadily(space, scene.spectrum, speed)
        return _with_zero_offset(one.body), one.passes, math.copysign(one.step.law.lag, speed)
    if scene.start == "relaxed":
        return *rest_on(space), 0.0
    body, passes = rest_on(space, glassy_stiffness(scene.spectrum))
    charge_branches(space.form, body.memory)
    return body, passes, 0.0


def _with_zero_offset(body: Body) -> Body:
    """Return the body with elements renumbered so that the offset of the surface is zero."""
    rows, n = body.p.shape
    fields = [
        np.roll(values.reshape(-1, rows, n), -body.offset, axis=2).reshape(-1, rows * n)
        for values in (body.memory, body.depth[None])
    ]
    return body._replace(memory=fields[0], depth=fields[1][0], offset=0)
