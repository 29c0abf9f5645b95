"""The lines of a batch: whose random numbers they are of."""

import dataclasses

import numpy as np
import pytest

from elastomer_friction.kernels import QUARTET, Line
from elastomer_friction.workflow.simulate import drawing as module
from elastomer_friction.workflow.simulate import realizations
from elastomer_friction.workflow.simulate.drawing import line_generator
from elastomer_friction.workflow.simulate.realizations import block_means
from tests.workflow.simulate.test_realizations import one_batch


def numbers(seed=1, hurst=0.3, elements=100, index=0):
    """Return the first random numbers of a line."""
    return line_generator(seed, hurst, elements, index).random(4).tolist()


@pytest.mark.parametrize("other", [{"seed": 2}, {"hurst": 0.7}, {"elements": 101}, {"index": 1}])
def test_each_line_has_random_numbers_of_its_own(other):
    assert numbers() == numbers()
    assert set(numbers()).isdisjoint(numbers(**other))


@pytest.fixture
def drawn(monkeypatch):
    """Return what quartets are drawn from: (samples per spacing, phases) in order."""
    found = []

    class Spy:
        @staticmethod
        def quartet(amplitude, phases, elements, steps_per_spacing):
            found.append((steps_per_spacing, phases.tolist()))
            return Line.quartet(amplitude, phases, elements, steps_per_spacing)

    monkeypatch.setattr(module, "Line", Spy)
    monkeypatch.setattr(realizations, "load_kernels", lambda *_: None)  # draws a line of its own
    return found


def test_every_resolution_samples_the_same_lines(drawn):
    for variant in ("4", "16"):
        block_means(one_batch(f"numerics.steps_per_spacing={variant}"))
    assert [steps for steps, _ in drawn] == [4] * 4 + [16] * 4
    assert [phases for _, phases in drawn[:4]] == [phases for _, phases in drawn[4:]]


@pytest.mark.parametrize(
    "setting",
    ["numerics.scheme=implicit-euler", "grid.normal_force=3.0", 'scene.quantities=["jump"]'],
)
def test_load_scheme_and_scene_play_no_part_in_the_lines(drawn, setting):
    block_means(one_batch())
    before = [phases for _, phases in drawn]
    drawn.clear()
    block_means(one_batch(setting))
    assert {tuple(p) for _, p in drawn} == {tuple(p) for p in before}


def test_tasks_of_one_resolution_share_the_line(drawn):
    batch = one_batch("numerics.steps_per_spacing=4")
    assert len(batch.tasks) == 4
    block_means(batch)
    assert len(drawn) * QUARTET == batch.blocks * batch.realizations_per_block


@pytest.mark.parametrize("count", [1, 2, 3])
def test_a_quartet_lies_in_one_block_and_a_single_line_is_its_first(drawn, count):
    """A block of a scene of one line is that line; of several lines whole quartets."""
    batch = one_batch("study.realizations=8", "numerics.steps_per_spacing=2")
    whole = block_means(dataclasses.replace(batch, blocks=1, realizations_per_block=4 * count))
    phases = [found for _, found in drawn]
    assert len(phases) == len({tuple(found) for found in phases}) == count
    drawn.clear()
    single = block_means(dataclasses.replace(batch, blocks=1, realizations_per_block=1))
    assert [found for _, found in drawn] == phases[:1]
    assert not np.array_equal(single.scalars, whole.scalars, equal_nan=True)
