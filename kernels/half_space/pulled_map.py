"""A half-space whose surface is pulled through a spring (drive/)."""

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ..drive.rig import accept, attempt, patch_width
from ..drive.slider import initial_speed, pull_through, recorded_times
from ..drive.slider_step import follow_leg
from ..drive.spring import Drive
from ..model.friction import mean_slope
from ..rheology.forms import form_of
from ..rheology.law import law_of
from ..scene.scene_case import SceneCase
from .body import STEP_TOLERANCE, Body, HalfSpace, body_after, try_step
from .contact import ElasticContact
from .patches import samples_per_patch
from .scenes import ShiftedSurface, initial_body
from .surface import Surface


class TriedStep(NamedTuple):
    """A step that was tried but not accepted yet."""

    law: Any  # law of the elastomer in the step
    w: np.ndarray  # displacements of the body without pressure
    contact: ElasticContact
    offset: int  # position of the surface after the step, in samples


@dataclass
class MapRig:
    """Rig of a surface on a half-space."""

    space: HalfSpace
    shifted: ShiftedSurface
    body: Body  # after the last accepted step
    passes: int  # of the operator, in total
    tried: TriedStep | None = None


@attempt.register(MapRig)
def _attempt(rig, places, dt):
    law = law_of(rig.space.form, dt)
    whole = math.floor(places.after)
    z, slope = rig.shifted.at(places.after - whole)
    offset = whole % z.shape[1]
    w, contact = try_step(rig.space, rig.body, law, z, offset, STEP_TOLERANCE)
    rig.passes += contact.passes
    rig.tried = TriedStep(law, w, contact, offset)
    before = rig.shifted.slopes_over(places.before, offset)
    weight = slope + law.lag * (before - slope)
    normal = rig.space.pressure * side_length(rig.space)
    return normal * mean_slope(contact.p, weight), law.lag


@accept.register(MapRig)
def _accept(rig, dt):
    old, (law, *step) = rig.body.d, rig.tried
    rig.body = body_after(rig.body, law, *step)
    d = rig.body.d + law.lag * (old - rig.body.d)
    p = rig.body.p
    return float(p.mean()) * side_length(rig.space), d, np.count_nonzero(p > 0.0) / p.size


@patch_width.register(MapRig)
def _patch_width(rig):
    return samples_per_patch(rig.body.p)


def side_length(space: HalfSpace) -> float:
    """Return the side length of the surface along x, in dx."""
    return space.surface.z.shape[1] / space.surface.steps_per_spacing


def run_pulled_on_half_space(
    surface: Surface, scene: SceneCase, drive: Drive, stiffness: np.ndarray | None = None
) -> dict[str, np.ndarray]:
    """Pull one map through a scene, like run_pulled; forces in E* L h and E* L h^2/dx.

    stiffness : of every mode, or None for a half-space.
    """
    times, speed = recorded_times(scene, surface.steps_per_spacing), initial_speed(scene)
    form = form_of(scene.spectrum, scene.scheme)
    space = HalfSpace.under(form, surface, scene.load, stiffness)
    shifted = ShiftedSurface(surface)
    body, passes, lag = initial_body(space, scene)
    before = shifted.slopes_over(-math.copysign(1.0, speed), body.offset)
    slope = surface.slope + abs(lag) * (before - surface.slope)
    normal = space.pressure * side_length(space)
    mu = mean_slope(body.p, slope)
    touching = np.count_nonzero(body.p > 0.0) / body.p.size
    rig = MapRig(space, shifted, body, passes)
    forces = mu, body.d, normal, mu * normal, touching, samples_per_patch(body.p)
    values, _ = pull_through(follow_leg, rig, surface, forces, drive, scene, times)
    return values | {"updates": np.array(float(rig.passes * surface.z.size))}
