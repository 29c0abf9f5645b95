"""Batches on a half-space: equal records for any cut, and their maps."""

import dataclasses

import numpy as np
import pytest

from elastomer_friction.kernels import Case, Quantities
from elastomer_friction.kernels.half_space.cases import run_case
from elastomer_friction.kernels.half_space.surface import Surface, map_amplitudes, ring_amplitudes
from elastomer_friction.workflow.simulate.drawing import drawn_maps, line_generator
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.simulate.tasks import SCALARS
from tests.support.records import by_record
from tests.support.small import cut_batches, small_plan

SMALL = (
    "scene.body=half-space",
    "grid.spacing=1e-3",  # 10 elements and 40 samples a side
    "grid.hurst=0.7",
    "numerics.steps_per_spacing=4",
    "study.realizations=2",
)
PLAN = small_plan(*SMALL)
GENERATOR = np.random.default_rng(1)


def test_numbers_do_not_depend_on_the_cut():
    whole = by_record(cut_batches(PLAN, set(), 1e9))
    assert len(whole) == PLAN.records
    assert by_record(cut_batches(PLAN, set(), 1e-9)) == whole


def test_a_record_is_the_case_of_the_kernels_on_the_map_of_its_seed():
    batch = next(cut_batches(PLAN, set(), 1e9))
    scalars = block_means(batch).scalars
    task = batch.tasks[0]
    problem = task.problem
    generator = line_generator(batch.seed, problem.hurst, problem.elements, 1)
    amplitude = ring_amplitudes(problem.hurst, problem.elements)
    surface = Surface.drawn(generator, amplitude, problem.elements, task.steps_per_spacing)
    case = Case(problem.load, problem.speed, (problem.ratio,), (), batch.scheme)
    outcome = run_case(surface, case, Quantities(relaxation=False))
    assert scalars[0, 1, SCALARS.index("mu_1")] == outcome.mu_1


@pytest.mark.parametrize("samples", [9, 10])
def test_amplitudes_of_a_map_are_those_of_its_drawing(samples):
    """This holds for modes longer than two samples, whose mode shares its amplitude."""
    cutoff = (samples - 1) // 2
    amplitude = ring_amplitudes(0.5, samples, cutoff=cutoff)
    surface = Surface.drawn(np.random.default_rng(1), amplitude, samples, 1)
    amplitudes = map_amplitudes(surface.z)
    np.testing.assert_allclose(amplitudes[:, 1:], amplitude[:, 1:], atol=1e-14)


def test_random_maps_with_a_given_spectrum_have_it():
    """The Hurst exponent of the study plays no part."""
    modes = map_amplitudes(Surface.drawn(GENERATOR, ring_amplitudes(0.1, 9, cutoff=3), 9, 1).z)
    batch = next(cut_batches(small_plan(*SMALL, "surface.length=9e-3"), set(), 1e9))
    batch = dataclasses.replace(batch, modes=modes)
    _, draw = drawn_maps(batch)
    (surface,) = draw(0)(1)
    np.testing.assert_allclose(map_amplitudes(surface.z)[:, 1:], modes[:, 1:], atol=1e-14)
