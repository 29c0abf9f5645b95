"""What a body makes of a batch: how its surfaces are drawn, and how cases and scenes are run."""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from ...kernels import Case, Outcome, Quantities, prepare, run_prepared, run_scene
from ...kernels.drive import run_pulled
from ...kernels.half_space import cases as half_space
from ...kernels.half_space.pulled_map import run_pulled_on_half_space
from ...kernels.half_space.scenes import run_scene_on_half_space
from ...kernels.half_space.surface import Surface, ring_amplitudes
from ...kernels.loading import load
from .drawing import Draw, drawn_lines, drawn_maps
from .tasks import Batch


class PreparedCases(NamedTuple):
    """Cases for surfaces of so many steps per spacing."""

    steps_per_spacing: int
    asked: Quantities
    cases: tuple[Case, ...]


class BodyKernels(NamedTuple):
    """How surfaces of a body are drawn and run; a surface is a line of elements, or a map."""

    drawing: Callable[[Batch], tuple[int, Callable[[int], Draw]]]
    prepare: Callable[[Sequence[Case], int, Quantities], Any]
    run: Callable[[Sequence[Any], Any], list[list[Outcome]]]
    run_scene: Callable[..., dict]
    pull: Callable[..., dict]  # through a scene, by a drive
    load: Callable[[str, Quantities], None]


def _prepare_maps(cases: Sequence[Case], steps: int, asked: Quantities) -> PreparedCases:
    return PreparedCases(steps, asked, tuple(cases))


def _run_maps(surfaces: Sequence[Any], prepared: PreparedCases) -> list[list[Outcome]]:
    return [
        [half_space.run_case(surface, case, prepared.asked) for case in prepared.cases]
        for surface in surfaces
    ]


def _load_maps(scheme: str, asked: Quantities) -> None:
    """Compile the kernels of a half-space, or load them: a small map at one speed."""
    surface = Surface.drawn(np.random.default_rng(0), ring_amplitudes(0.5, 8), 8, 4)
    case = Case(0.1, 1.0, (1.2,), (np.array([1, 2]),), scheme)
    half_space.run_case(surface, case, asked)


BODIES = {
    "foundation": BodyKernels(drawn_lines, prepare, run_prepared, run_scene, run_pulled, load),
    "half-space": BodyKernels(
        drawn_maps,
        _prepare_maps,
        _run_maps,
        run_scene_on_half_space,
        run_pulled_on_half_space,
        _load_maps,
    ),
}


def body_of(batch: Batch) -> BodyKernels:
    """Return the body of a batch, which all of its tasks have."""
    return BODIES[batch.tasks[0].problem.surface.body]
