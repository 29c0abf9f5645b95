"""A programme of motion on a half-space: the surface moves over it, and what is asked for is kept.

The steps are those of a line (scene/scene_case.py). At whole samples the surface is the one that is
given, over other elements; at fractions it is shifted along x by Fourier (motion/fourier.py).
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
from ..scene.begin import charge_branches, glassy_stiffness
from ..scene.cycles import add_impulses, mean_of, spell_of
from ..scene.records import TRACES, Trace, keep_forces, keep_motion
from ..scene.scene_case import Saved, SceneCase, check_scene, scene_steps
from .body import Body, HalfSpace, move_on, rest_on, step_tolerance
from .patches import samples_per_patch
from .sliding_body import slide_steadily
from .surface import Surface

KEPT = ("trace", "cycle_mean", "snapshots")  # what of a scene is there for a half-space


class Way(NamedTuple):
    """How the surface moves, as of a Track (motion/track.py)."""

    place: np.ndarray  # in dx, shape (S + 1,)
    time: np.ndarray  # in tau, shape (S + 1,)
    dt: np.ndarray  # in tau, shape (S,)


class Moving:
    """A surface at any place along x."""

    def __init__(self, surface: Surface) -> None:
        """Take the surface as it is at place zero."""
        self.surface = surface
        self.at = FractionalShifts(*surface[:3]).at

    def slope_over(self, place: float, offset: int) -> np.ndarray:
        """Return the slopes at a place, at the samples over which those of ``offset`` lie."""
        whole = math.floor(place)
        return np.roll(self.at(place - whole)[1], whole - offset, axis=1)


def run_scene_on_half_space(
    surface: Surface,
    scene: SceneCase,
    state: Saved | None = None,
    stiffness: np.ndarray | None = None,
) -> dict[str, np.ndarray]:
    """Take a half-space through a scene; return the values asked for, by name, as of a line.

    trace : as of a line (scene/run.py), forces in E* L h and E* L h^2/dx. snapshots :
    "snapshot_pressure" (frames, rows, n), in E* h/dx, at the samples of the half-space. "updates" :
    samples times passes of the operator. stiffness : over the modes, where it is not the |q|/2 of a
    half-space. Raises ValueError for a scene without meaning, and for what a half-space does not
    keep.
    """
    if state is not None or set(scene.asked) - set(KEPT):
        raise ValueError(f"asked = {sorted(scene.asked)}: a half-space keeps {KEPT}")
    m, n = surface.steps_per_spacing, surface.z.shape[1]
    steps = scene_steps(scene, m)
    check_scene(scene, steps, False)
    form = form_of(scene.spectrum, scene.scheme)
    space, moving = HalfSpace.under(form, surface, scene.load, stiffness), Moving(surface)
    body, passes, lag = begun_on(space, scene)
    trace = Trace(*np.empty((len(TRACES), scene.kept.size)))
    spell = spell_of(scene, steps)
    frames = np.empty((scene.frames.size if "snapshots" in scene.asked else 0, *surface.z.shape))
    kept = {int(number): k for k, number in enumerate(scene.kept)}
    shown = {int(number): k for k, number in enumerate(scene.frames[: len(frames)])}
    places = np.append(0.0, steps.position)
    way = Way(places / m, np.cumsum(np.append(0.0, steps.dt)), steps.dt)
    law = lru_cache(maxsize=16)(lambda dt: law_of(form, dt))
    for step in range(places.size):
        old = body.d
        if step:
            own = law(steps.dt[step - 1])
            lag, place = own.lag, float(places[step])
            whole = math.floor(place)
            heights = moving.at(place - whole)[0]
            tolerance = step_tolerance(scene.spectrum, own)
            body, used = move_on(space, body, own, heights, whole % n, tolerance)
            passes += used
        averaged = spell is not None and spell.after < step <= spell.last
        if averaged or step in kept:
            before = places[step - 1] if step else -math.copysign(1.0, lag)
            lag = abs(lag)
            earlier, now = (
                moving.slope_over(place, body.offset).ravel() for place in (before, places[step])
            )
            sums = weighted_sums(-body.p.ravel(), None, now + lag * (earlier - now), 0.0)
        if averaged:
            add_impulses(spell, sums, way.dt[step - 1])
        if step in kept:
            k = kept[step]
            keep_forces(trace, k, lag, sums, body.p.size, old, body.d)
            trace.samples_per_contact[k] = samples_per_patch(body.p)
            trace.normal_force[k] *= n / m  # the side of the surface, in dx
            trace.friction_force[k] *= n / m
            if step:
                keep_motion(trace, k, lag, way, step - 1)
            else:
                trace.time[k], trace.distance[k] = 0.0, 0.0
                trace.velocity[k] = speed_at_start(scene.programme)
        if step in shown:
            frames[shown[step]] = np.roll(body.p, body.offset, axis=1)
    found = dict(zip(TRACES, trace, strict=True)) if "trace" in scene.asked else {}
    if "snapshots" in scene.asked:
        found["snapshot_pressure"] = frames
    return found | mean_of(spell) | {"updates": np.array(float(passes * surface.z.size))}


def begun_on(space: HalfSpace, scene: SceneCase) -> tuple[Body, int, float]:
    """Return the body before the first step, passes, and the signed lag of the step before."""
    if scene.start == "steady":
        speed = speed_at_start(scene.programme)
        one = slide_steadily(space, scene.spectrum, speed)
        return _turned_back(one.body), one.passes, math.copysign(one.step.law.lag, speed)
    if scene.start == "relaxed":
        return *rest_on(space), 0.0
    body, passes = rest_on(space, glassy_stiffness(scene.spectrum))
    charge_branches(space.form, body.memory)
    return body, passes, 0.0


def _turned_back(body: Body) -> Body:
    """Return a body whose elements are counted from where the surface is now."""
    rows, n = body.p.shape
    fields = [
        np.roll(values.reshape(-1, rows, n), -body.offset, axis=2).reshape(-1, rows * n)
        for values in (body.memory, body.depth[None])
    ]
    return body._replace(memory=fields[0], depth=fields[1][0], offset=0)
