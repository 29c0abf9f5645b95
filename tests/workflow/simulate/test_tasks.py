"""What a worker is given and gives back: plain data that says what each number is."""

import numpy as np
import pytest

from elastomer_friction.kernels import Case, Line, Quantities, amplitudes, draw_phases, run_case
from elastomer_friction.workflow.simulate.drawing import line_generator
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.simulate.tasks import SCALARS
from elastomer_friction.workflow.study.effects.quantities import QUANTITIES
from tests.support.small import cut_batches, small_plan

BATCH = next(cut_batches(small_plan("study.realizations=2"), set(), 1e9))


def test_block_means_are_named_as_the_outcome_of_the_kernels():
    """By field, not by position: each column is the mean of what the kernels call so."""
    task = BATCH.tasks[0]
    hurst, elements, load, speed, ratio = task.problem[:5]
    phases = draw_phases(line_generator(BATCH.seed, hurst, elements, 0), elements)
    lines = Line.quartet(amplitudes(hurst, elements), phases, elements, task.steps_per_spacing)
    case = Case(load, speed, (ratio,), (np.array([1]),), BATCH.scheme)
    outcomes = [run_case(line, case, Quantities()) for line in lines]
    found = block_means(BATCH).scalars[0, 0]
    for name, value in zip(SCALARS, found, strict=True):
        expected = np.mean([np.ravel(getattr(outcome, name)) for outcome in outcomes])
        assert value == pytest.approx(expected, rel=1e-12), name


def test_every_estimate_of_a_scene_is_a_block_mean():
    asked = {name for quantity in QUANTITIES.values() for name in quantity.means}
    assert asked | {"samples_per_contact"} == set(SCALARS)
