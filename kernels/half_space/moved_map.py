"""The body of a map on a half-space, which a programme or a drive moves (body/step.py).

At whole samples the surface is rolled over the elements; between samples it is shifted along x by
Fourier (motion/fourier.py).
"""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from ..body.step import Forces, accept, attempt, end_leg, forces, patch_width
from ..drive.sticking import static_force
from ..interface.shear import ShearLaw
from ..model.friction import mean_slope
from ..motion.fourier import FractionalShifts
from ..motion.legs import speed_at_start
from ..rheology.forms import form_of
from ..rheology.spectrum import Spectrum
from ..scene.carried import CarriedBranches, carried_memory
from ..scene.initial_state import charge_branches, glassy_stiffness
from ..scene.records import record_snapshot
from ..scene.scene_case import SceneCase
from .body import Body, HalfSpace, body_after, rest_on, try_step
from .contact import ElasticContact
from .heating import Heating, Warmth
from .hot_sliding import slide_with_heat
from .patches import real_contact, samples_per_patch
from .shear_force import static_shear, with_shear, with_shear_share
from .sliding_body import jump_weight, slide_steadily


class MovedMap(NamedTuple):
    """A half-space under a map that moves along x."""

    space: HalfSpace
    shifts: Callable  # fraction of a sample -> heights and slopes
    position: Callable  # place of a step -> position of the surface, in samples
    tolerance: Callable  # law of a step -> tolerance of its contact
    spectrum: Spectrum  # of the material
    shear: ShearLaw | None  # added to the friction of every step; None: by the reduction

    @classmethod
    def of(
        cls, space: HalfSpace, scene: SceneCase, position: Callable, tolerance: Callable
    ) -> "MovedMap":
        """Return a map whose samples are given at position zero."""
        shifts = FractionalShifts(*space.surface[:3]).at
        return cls(space, shifts, position, tolerance, scene.spectrum, scene.effects.shear)

    @property
    def form(self) -> Any:
        """Return the form of the material."""
        return self.space.form

    @property
    def side(self) -> float:
        """Return the side of the map, in dx."""
        return self.space.surface.z.shape[1] / self.space.surface.steps_per_spacing

    def slopes_over(self, place: Any, offset: int) -> np.ndarray:
        """Return the slopes at a place, at the elements under the samples at ``offset``."""
        position = self.position(place)
        whole = math.floor(position)
        slopes = self.shifts(position - whole)[1]
        behind = (whole - offset) % slopes.shape[1]
        return np.roll(slopes, behind, axis=1) if behind else slopes


class AttemptedContact(NamedTuple):
    """Contact of a step that is not accepted yet."""

    w: np.ndarray  # displacements of the body without pressure
    contact: ElasticContact
    offset: int  # position of the surface after the step, in samples


class MapState(NamedTuple):
    """State of a MovedMap."""

    old_d: float  # approach before the last accepted step, in h
    d: float  # approach after it, in h
    passes: int  # of the operator, in total
    body: Body  # after the last accepted step
    attempted: AttemptedContact | None


def moved_map(
    space: HalfSpace,
    scene: SceneCase,
    position: Callable,
    tolerance: Callable,
    carried: CarriedBranches | None = None,
    heating: Heating | None = None,
) -> tuple[MovedMap, MapState, Forces, Warmth | None]:
    """Return (map, state, Forces, warmth if heated) at the start of a scene.

    carried : branches carried along by the motion from a start at rest, if any.
    """
    warmth = heating.cold() if heating else None
    shear = speed = sudden = 0.0
    if scene.start == "steady":
        speed = speed_at_start(scene.programme)
        hot = slide_with_heat(space, scene.spectrum, heating, speed)
        one, warmth, shear = hot.sliding, hot.warmth, hot.shear
        body, passes, lag = _with_zero_offset(one.body), one.passes, one.step.law.lag
        sudden = one.viscous
        earlier = np.roll(space.surface.slope, -1 if speed > 0.0 else 1, axis=1)
    elif carried is not None:
        (body, passes), lag = _carried_body(space, scene, carried), 0.0
        earlier = space.surface.slope
    elif scene.start == "relaxed":
        (body, passes), lag, earlier = rest_on(space), 0.0, space.surface.slope
    else:
        body, passes = rest_on(space, glassy_stiffness(scene.spectrum))
        charge_branches(space.form, body.memory)
        lag, earlier = 0.0, space.surface.slope
    weight = space.surface.slope + lag * (earlier - space.surface.slope)
    moved = MovedMap.of(space, scene, position, tolerance)
    if heating is not None:  # shear then depends on the temperature (heated_map.py)
        moved = moved._replace(shear=None)
    state = MapState(body.d, body.d, passes, body, None)
    acting = _forces_of(moved, body.p, weight, sudden, speed)
    return moved, state, with_shear_share(acting, shear), warmth


def _carried_body(space: HalfSpace, scene: SceneCase, carried: CarriedBranches) -> tuple[Body, int]:
    """Return (body at rest whose slow branches are carried along, passes)."""
    form = form_of(carried.spectrum, scene.scheme)
    one = slide_steadily(space._replace(form=form), *carried)
    body = _with_zero_offset(one.body)
    memory = carried_memory(space.form, carried, form, body.memory, body.depth)
    return body._replace(memory=memory), one.passes


def _with_zero_offset(body: Body) -> Body:
    """Return the body with its elements renumbered from the present position of the surface."""
    rows, n = body.p.shape
    fields = [
        np.roll(values.reshape(-1, rows, n), -body.offset, axis=2).reshape(-1, rows * n)
        for values in (body.memory, body.depth[None])
    ]
    return body._replace(memory=fields[0], depth=fields[1][0], offset=0)


def _forces_of(
    body: MovedMap, p: np.ndarray, weight: np.ndarray, sudden: float, speed: float
) -> Forces:
    """Return the Forces of pressures at slopes; the load is divided by the side of the map.

    sudden : as for ``real_contact``. speed : signed, in dx/tau.
    """
    side, mu = body.side, mean_slope(p, weight)
    normal, friction = float(p.mean()) * side, body.space.pressure * side * mu
    acting = Forces(mu, normal, friction, real_contact(p, sudden))
    return acting if body.shear is None else with_shear(acting, body.shear, side, speed)


@attempt.register(MovedMap)
def _attempt(body, state, law, step):
    position = body.position(step.after)
    whole = math.floor(position)
    z = body.shifts(position - whole)[0]
    offset = whole % z.shape[1]
    w, contact = try_step(body.space, state.body, law, z, offset, body.tolerance(law))
    passes = state.passes + contact.passes
    return state._replace(passes=passes, attempted=AttemptedContact(w, contact, offset))


@forces.register(MovedMap)
def _forces(body, state, law, step):
    _, contact, offset = state.attempted
    before, after = (body.slopes_over(place, offset) for place in (step.before, step.after))
    weight = after + law.lag * (before - after)  # at the instant when the force acts
    moved = body.position(step.after) - body.position(step.before)
    # Pressures jump only at samples passed in this step.
    sudden = jump_weight(body.spectrum, moved / step.dt) * min(abs(moved), 1.0)
    speed = moved / (body.space.surface.steps_per_spacing * step.dt)
    return _forces_of(body, contact.p, weight, sudden, speed)


@static_force.register(MovedMap)
def _static_force(body, state, acting):
    return 0.0 if body.shear is None else static_shear(acting, body.shear, body.side)


@accept.register(MovedMap)
def _accept(body, state, law):
    after = body_after(state.body, law, *state.attempted)
    return MapState(state.d, after.d, state.passes, after, None)


@end_leg.register(MovedMap)
def _end_leg(body, state):
    return state


@patch_width.register(MovedMap)
def _patch_width(body, state):
    return samples_per_patch(state.body.p)


class PressureFrames(NamedTuple):
    """Recorder of snapshots of pressures at the elements of the half-space."""

    pressure: np.ndarray  # in E* h/dx, shape (frames, rows, n)


@record_snapshot.register(PressureFrames)
def _record_snapshot(snapshots, k, body, state, place):
    snapshots.pressure[k] = np.roll(state.body.p, state.body.offset, axis=1)
