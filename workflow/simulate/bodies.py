"""Functions of each body: draw its surfaces, and run cases and scenes on them."""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from ...kernels import Case, Outcome, Quantities, prepare, run_prepared, run_scene
from ...kernels.drive import run_pulled
from ...kernels.half_space import cases as half_space
from ...kernels.half_space.scenes import run_pulled_on_half_space, run_scene_on_half_space
from ...kernels.half_space.surface import Surface, ring_amplitudes
from ...kernels.loading import load
from .drawing import Draw, drawn_lines, drawn_maps
from .tasks import Batch


class MapCases(NamedTuple):
    """Cases for maps with the same steps per spacing."""

    cases: Sequence[Case]
    steps_per_spacing: int
    requested: Quantities


class CaseGroup(NamedTuple):
    """Cases of a batch with the same steps per spacing, and the tasks that share each case."""

    prepared: Any  # the cases, prepared by their body
    rows: list[list[int]]  # of each case, the positions of its tasks in the batch


class BodyKernels(NamedTuple):
    """Functions of a body, whose surfaces are lines of elements, or maps."""

    drawing: Callable[[Batch], tuple[int, Callable[[int], Draw]]]
    prepare: Callable[[Sequence[Case], int, Quantities], Any]
    run: Callable[[Sequence[Any], Any], list[list[Outcome]]]
    run_scene: Callable[..., dict]
    pull: Callable[..., dict]  # run a scene that a drive pulls
    load: Callable[[str, Quantities], None]


def _run_maps(surfaces: Sequence[Any], prepared: MapCases) -> list[list[Outcome]]:
    return [
        [half_space.run_case(surface, case, prepared.requested) for case in prepared.cases]
        for surface in surfaces
    ]


def _load_maps(scheme: str, requested: Quantities) -> None:
    """Compile or load the kernels of a half-space by running a small map at one speed."""
    surface = Surface.drawn(np.random.default_rng(0), ring_amplitudes(0.5, 8), 8, 4)
    case = Case(0.1, 1.0, (1.2,), (np.array([1, 2]),), scheme)
    half_space.run_case(surface, case, requested)


BODIES = {
    "foundation": BodyKernels(drawn_lines, prepare, run_prepared, run_scene, run_pulled, load),
    "half-space": BodyKernels(
        drawn_maps,
        MapCases,
        _run_maps,
        run_scene_on_half_space,
        run_pulled_on_half_space,
        _load_maps,
    ),
}


def body_of(batch: Batch) -> BodyKernels:
    """Return the functions of the body of a batch; all its tasks have one body."""
    return BODIES[batch.tasks[0].problem.surface.body]
