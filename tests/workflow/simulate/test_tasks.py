"""What a worker is given and gives back: plain data that says what each number is."""

import numpy as np
import pytest

from kernels import Case, Line, Quantities, amplitudes, draw_phases, run_case
from tests.support.small import cut_batches, small_plan
from workflow.simulate.realizations import block_means, line_generator
from workflow.simulate.tasks import SCALARS
from workflow.study.effects.quantities import QUANTITIES

BATCH = next(cut_batches(small_plan("study.realizations=2"), set(), 1e9))


def test_block_means_are_named_as_the_outcome_of_the_kernels():
    """By field, not by position: each column is the number that the kernels call so."""
    task = BATCH.tasks[0]
    hurst, elements, load, speed, ratio = task.problem[:5]
    phases = draw_phases(line_generator(BATCH.seed, hurst, elements, 0), elements)
    line = Line.self_affine(amplitudes(hurst, elements), phases, elements, task.steps_per_spacing)
    case = Case(load, speed, (ratio,), (np.array([1]),), BATCH.scheme)
    outcome = run_case(line, case, Quantities())
    found = block_means(BATCH).scalars[0, 0]
    for name, value in zip(SCALARS, found, strict=True):
        expected = getattr(outcome, name)
        assert value == pytest.approx(float(np.ravel(expected)[0]), rel=1e-12), name


def test_every_estimate_of_a_scene_is_a_block_mean():
    asked = {name for quantity in QUANTITIES.values() for name in quantity.means}
    assert asked | {"samples_per_contact"} == set(SCALARS)
