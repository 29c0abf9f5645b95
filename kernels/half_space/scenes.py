"""Scenes on a half-space, moved by a programme or pulled through a spring."""

import math
from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from ..body.step import Forces, patch_width
from ..drive.pulled_slider import pull_through, recorded_times
from ..drive.spring import Drive
from ..interface.shear import check_fastest
from ..motion.legs import Steps, speed_at_start
from ..rheology.forms import form_of
from ..scene.carried import CarriedBranches, carried_branches
from ..scene.march_body import march_track
from ..scene.recorders import Recorders
from ..scene.records import record_snapshot
from ..scene.scene_case import SavedState, SceneCase, check_scene, scene_steps
from .body import STEP_TOLERANCE, HalfSpace, step_tolerance
from .heated_map import HeatedMap, heated_map
from .heating import Heating
from .moved_map import PressureFrames, moved_map
from .surface import Surface

SLIP_STEP_SHARE = 0.1  # shortest resolved step of a heated slider, over the drive's
HALF_SPACE_QUANTITIES = ("trace", "cycle_mean", "snapshots")


class SurfacePath(NamedTuple):
    """Motion of the surface, with the fields of a Track (motion/track.py)."""

    place: np.ndarray  # in dx, shape (S + 1,)
    time: np.ndarray  # in tau, shape (S + 1,)
    dt: np.ndarray  # in tau, shape (S,)


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
    steps = scene_steps(scene, surface.steps_per_spacing)
    check_scene(scene, steps, False)
    space = HalfSpace.under(
        form_of(scene.spectrum, scene.scheme), surface, scene.load, stiffness, scene.effects.layer
    )
    positions = np.append(0.0, steps.position)
    tolerance = partial(step_tolerance, scene.spectrum)
    elements = surface.z.shape[1] / surface.steps_per_spacing
    carried = carried_branches(scene.start, scene.spectrum, scene.programme, elements)
    body, moved, acting = _at_start(
        space, scene, positions.__getitem__, tolerance, steps, scene.recorded, carried
    )
    times = np.cumsum(np.append(0.0, steps.dt))
    path = SurfacePath(positions / surface.steps_per_spacing, times, steps.dt)
    frames = PressureFrames(np.empty((scene.frames.size, *surface.z.shape)))
    recorders = Recorders(scene, surface.steps_per_spacing, steps, frames)
    recorders.record_start(path, acting, moved.d, patch_width(body, moved))
    if recorders.snapshots is not None and scene.frames.size and scene.frames[0] == 0:
        record_snapshot(frames, 0, body, moved, 0)
    moved = march_track(body, moved, path, 0, *recorders.arguments())
    values = recorders.values() | {"updates": np.array(float(moved.passes * surface.z.size))}
    values |= _temperatures(body, values)
    if "snapshots" in scene.requested:
        values["snapshot_pressure"] = frames.pressure
    return values


def run_pulled_on_half_space(
    surface: Surface, scene: SceneCase, drive: Drive, stiffness: np.ndarray | None = None
) -> dict[str, np.ndarray]:
    """Pull one map through a scene, like run_pulled; forces in E* L h and E* L h^2/dx.

    stiffness : of every mode, or None for a half-space.
    """
    times = recorded_times(scene, surface.steps_per_spacing)
    space = HalfSpace.under(
        form_of(scene.spectrum, scene.scheme), surface, scene.load, stiffness, scene.effects.layer
    )
    steps = scene_steps(scene, surface.steps_per_spacing)
    body, state, acting = _at_start(space, scene, float, lambda law: STEP_TOLERANCE, steps, None)
    width = patch_width(body, state)
    values, state, _ = pull_through(body, state, surface, acting, width, drive, scene, times)
    if scene.effects.shear is not None:
        check_fastest(scene.effects.shear, float(np.nanmax(np.abs(values["trace_velocity"]))))
    values |= {"updates": np.array(float(state.passes * surface.z.size))}
    return values | _temperatures(body, values)


def _at_start(
    space: HalfSpace,
    scene: SceneCase,
    position: Callable,
    tolerance: Callable,
    steps: Steps,
    recorded: np.ndarray | None,
    carried: CarriedBranches | None = None,
) -> tuple[Any, Any, Forces]:
    """Return (body, state, Forces) before the first step, heated if the scene requests it.

    steps : of the programme. recorded : numbers of the recorded steps, or None for all.
    carried : as for ``moved_map``.
    """
    # A slider may slip faster than its drive moves.
    min_step = float(steps.dt.min()) * (1.0 if recorded is not None else SLIP_STEP_SHARE)
    heating = Heating.of(space, scene.effects, min_step)
    moved, state, acting, warmth = moved_map(space, scene, position, tolerance, carried, heating)
    if heating is None or warmth is None:
        return moved, state, acting
    kept = None if recorded is None else frozenset(recorded.tolist())
    direction = math.copysign(1.0, speed_at_start(scene.programme))
    direction = direction if scene.start == "steady" else 0.0
    return *heated_map(moved, state, heating, warmth, direction, kept), acting


def _temperatures(body: Any, values: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Return the traces of the temperatures of a heated map, by name, if there is a trace."""
    heated = isinstance(body, HeatedMap) and "trace_time" in values
    return body.traces(values["trace_time"]) if heated else {}
