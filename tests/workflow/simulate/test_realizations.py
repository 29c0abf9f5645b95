"""Batches: numbers do not depend on the cut, nor lines on the requested results."""

import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastomer_friction.kernels import (
    QUARTET,
    Case,
    Line,
    Quantities,
    amplitudes,
    draw_phases,
    run_case,
    run_prepared,
)
from elastomer_friction.workflow.simulate import drawing, realizations
from elastomer_friction.workflow.simulate.bodies import BODIES
from elastomer_friction.workflow.simulate.drawing import line_generator
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.simulate.tasks import PHASES, SCALARS
from elastomer_friction.workflow.study.effects.quantities import QUANTITIES
from tests.support.records import by_record
from tests.support.small import cut_batches, small_plan

PLAN = small_plan("grid.velocity_step=[0.2, -0.2]")


def one_batch(*settings):
    """Return the first batch of the small study: all tasks of one H, all blocks."""
    return next(cut_batches(small_plan(*settings), set(), 1e9))


@pytest.mark.parametrize("target", [1e-9, 2e-3, 6e-3])
def test_numbers_do_not_depend_on_the_cut(target):
    whole = by_record(cut_batches(PLAN, set(), 1e9))
    assert len(whole) == PLAN.records
    assert by_record(cut_batches(PLAN, set(), target)) == whole


WHOLE = one_batch("grid.velocity_step=[0.2, -0.2]", "grid.velocity=[0.03, 0.05, 0.1]")


@settings(max_examples=15)
@given(st.permutations(range(len(WHOLE.tasks))), st.integers(1, 6))
def test_numbers_do_not_depend_on_other_tasks_or_their_order(order, count):
    part = sorted(order[:count], key=lambda i: WHOLE.tasks[i].steps_per_spacing)
    tasks = tuple(WHOLE.tasks[i] for i in part)
    alone = by_record([dataclasses.replace(WHOLE, tasks=tasks, first_block=1, blocks=1)])
    together = by_record([WHOLE])
    assert alone == {record: together[record] for record in alone}


def test_a_block_is_the_mean_of_its_realizations():
    pairs = block_means(one_batch("study.realizations_per_block=8"))
    single = block_means(one_batch())
    for pair, one in zip(pairs[:2], single[:2], strict=True):
        expected = (one[:, ::2] + one[:, 1::2]) / 2
        np.testing.assert_allclose(pair, expected, rtol=1e-14)


def test_a_block_of_measured_lines_is_the_mean_over_them():
    """Each line enters once, by itself and not in a quartet."""
    batch = one_batch()
    batch = dataclasses.replace(batch, tasks=batch.tasks[:2], blocks=1, realizations_per_block=2)
    turn = 2.0 * np.pi * np.arange(batch.tasks[0].problem.elements) / 64
    heights = np.stack([np.cos(turn), np.cos(turn) + 0.3 * np.sin(3.0 * turn)])
    both = block_means(dataclasses.replace(batch, heights=heights))
    single = [
        block_means(dataclasses.replace(batch, heights=heights[[k]], realizations_per_block=1))
        for k in (0, 1)
    ]
    expected = (single[0].scalars + single[1].scalars) / 2
    assert (single[0].scalars[:, 0, 0] != single[1].scalars[:, 0, 0]).all()
    np.testing.assert_allclose(both.scalars, expected, rtol=1e-14)


def test_blocks_are_different_realizations():
    scalars, curves, *_ = block_means(one_batch())
    assert len(np.unique(scalars[0, :, 0])) == 4
    assert len(np.unique(curves[0, :, 0])) == 4


def test_results_that_are_not_requested_are_nan():
    scalars, curves, *_ = block_means(one_batch('scene.quantities=["steady"]'))
    missing = np.isnan(scalars).all(axis=(0, 1))
    assert [name for name, is_missing in zip(SCALARS, missing, strict=True) if is_missing] == [
        "jump"
    ]
    assert np.isnan(curves).all()


def test_curves_end_where_the_march_ends():
    batch = one_batch("numerics.samples=64", "numerics.horizon=1.0")
    curves = block_means(batch).curves
    for task, curve in zip(batch.tasks, curves, strict=True):
        assert np.isfinite(curve).sum(axis=1).tolist() == [min(task.march_steps, 63)] * batch.blocks


def test_short_lines_are_run_together_and_long_ones_one_by_one(monkeypatch):
    """The numbers are equal either way."""
    counts = []

    def spy(lines, prepared):
        counts.append(len(lines))
        return run_prepared(lines, prepared)

    monkeypatch.setitem(BODIES, "foundation", BODIES["foundation"]._replace(run=spy))
    batch = one_batch("study.realizations_per_block=4")
    together = by_record([batch])
    monkeypatch.setattr(realizations, "MAX_SHORT_SAMPLES", 1)
    assert by_record([batch]) == together
    lines = batch.blocks * batch.realizations_per_block
    assert lines > QUARTET
    assert sorted(set(counts)) == [1, lines]


def test_given_steps_are_not_refined():
    light = ("grid.normal_force=4e-5", "grid.velocity=100.0")
    (chosen, given) = (one_batch(*light, *more) for more in ([], ["numerics.steps_per_spacing=4"]))
    assert (chosen.refine, given.refine) == (True, False)
    assert not {task.key for task in chosen.tasks} & {task.key for task in given.tasks}
    as_sampled = dataclasses.replace(chosen, refine=False)
    rows = [block_means(batch).scalars[..., 0] for batch in (chosen, as_sampled)]
    assert not np.isclose(*rows, rtol=1e-3).any()


def test_time_is_added_to_the_requested_phases():
    done = block_means(one_batch('scene.quantities=["steady"]'))
    assert done.spent.shape == (len(WHOLE.tasks) // 3, len(PHASES))
    seconds = dict(zip(PHASES, done.spent.sum(axis=0), strict=True))
    assert seconds["jump"] == seconds["marching"] == 0.0
    assert min(seconds["surfaces"], seconds["steady"]) > 0.0
    assert sum(seconds.values()) <= done.seconds


BATCH = next(cut_batches(small_plan("study.realizations=2"), set(), 1e9))


def test_block_means_have_the_names_of_the_outcome_of_the_kernels():
    """Each column is the mean of the field of its name, not of its position."""
    task = BATCH.tasks[0]
    hurst, elements, load, speed, ratio = task.problem[:5]
    phases = draw_phases(line_generator(BATCH.seed, hurst, elements, 0), elements)
    lines = Line.quartet(amplitudes(hurst, elements), phases, elements, task.steps_per_spacing)
    case = Case(load, speed, (ratio,), (np.array([1]),), BATCH.scheme)
    outcomes = [run_case(line, case, Quantities()) for line in lines]
    means = block_means(BATCH).scalars[0, 0]
    for name, value in zip(SCALARS, means, strict=True):
        expected = np.mean([np.ravel(getattr(outcome, name)) for outcome in outcomes])
        assert value == pytest.approx(expected, rel=1e-12), name


def test_every_estimate_of_a_scene_is_a_block_mean():
    estimates = {name for quantity in QUANTITIES.values() for name in quantity.means}
    assert estimates | {"samples_per_contact"} == set(SCALARS)


def numbers(seed=1, hurst=0.3, elements=100, index=0):
    """Return the first random numbers of a line."""
    return line_generator(seed, hurst, elements, index).random(4).tolist()


@pytest.mark.parametrize("other", [{"seed": 2}, {"hurst": 0.7}, {"elements": 101}, {"index": 1}])
def test_each_line_has_different_random_numbers(other):
    assert numbers() == numbers()
    assert set(numbers()).isdisjoint(numbers(**other))


@pytest.fixture
def drawn(monkeypatch):
    """Return (samples per spacing, phases) of the drawn quartets, in order."""
    quartets = []

    class Spy:
        @staticmethod
        def quartet(amplitude, phases, elements, steps_per_spacing):
            quartets.append((steps_per_spacing, phases.tolist()))
            return Line.quartet(amplitude, phases, elements, steps_per_spacing)

    monkeypatch.setattr(drawing, "Line", Spy)
    monkeypatch.setattr(realizations, "load_kernels", lambda *_: None)  # which draws a line
    return quartets


def test_every_resolution_samples_the_same_lines(drawn):
    for variant in ("4", "16"):
        block_means(one_batch(f"numerics.steps_per_spacing={variant}"))
    assert [steps for steps, _ in drawn] == [4] * 4 + [16] * 4
    assert [phases for _, phases in drawn[:4]] == [phases for _, phases in drawn[4:]]


@pytest.mark.parametrize(
    "setting",
    ["numerics.scheme=implicit-euler", "grid.normal_force=3.0", 'scene.quantities=["jump"]'],
)
def test_lines_do_not_depend_on_load_scheme_and_scene(drawn, setting):
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
    """A block of a scene has one line; other blocks have whole quartets."""
    batch = one_batch("study.realizations=8", "numerics.steps_per_spacing=2")
    whole = block_means(dataclasses.replace(batch, blocks=1, realizations_per_block=4 * count))
    phases = [phase for _, phase in drawn]
    assert len(phases) == len({tuple(phase) for phase in phases}) == count
    drawn.clear()
    single = block_means(dataclasses.replace(batch, blocks=1, realizations_per_block=1))
    assert [phase for _, phase in drawn] == phases[:1]
    assert not np.array_equal(single.scalars, whole.scalars, equal_nan=True)
