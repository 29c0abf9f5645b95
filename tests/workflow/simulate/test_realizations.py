"""A batch: its numbers do not depend on how the work is cut, and its lines on what is asked."""

import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastomer_friction.kernels import QUARTET, run_prepared
from elastomer_friction.workflow.simulate import realizations as module
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.simulate.tasks import PHASES, SCALARS
from tests.support.small import cut_batches, small_plan

PLAN = small_plan("grid.velocity_step=[0.2, -0.2]")


def one_batch(*settings):
    """Return the first batch of the small study: all tasks of one H, all blocks."""
    return next(cut_batches(small_plan(*settings), set(), 1e9))


def by_record(work):
    """Return the numbers of every record, as bytes."""
    found = {}
    for batch in work:
        scalars, curves, *_ = block_means(batch)
        for i, task in enumerate(batch.tasks):
            for j in range(batch.blocks):
                record = (task.key, batch.first_block + j)
                found[record] = (scalars[i, j].tobytes(), curves[i, j].tobytes())
    return found


@pytest.mark.parametrize("target", [1e-9, 2e-3, 6e-3])
def test_numbers_do_not_depend_on_the_cut(target):
    whole = by_record(cut_batches(PLAN, set(), 1e9))
    assert len(whole) == PLAN.records
    assert by_record(cut_batches(PLAN, set(), target)) == whole


WHOLE = one_batch("grid.velocity_step=[0.2, -0.2]", "grid.velocity=[0.03, 0.05, 0.1]")


@settings(max_examples=15)
@given(st.permutations(range(len(WHOLE.tasks))), st.integers(1, 6))
def test_numbers_do_not_depend_on_the_company_or_order_of_tasks(order, count):
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
    """Each of them once, one by one and not in quartets."""
    batch = one_batch()
    batch = dataclasses.replace(batch, tasks=batch.tasks[:2], blocks=1, realizations_per_block=2)
    turn = 2.0 * np.pi * np.arange(batch.tasks[0].problem.elements) / 64
    heights = np.stack([np.cos(turn), np.cos(turn) + 0.3 * np.sin(3.0 * turn)])
    both = block_means(dataclasses.replace(batch, heights=heights))
    each = [
        block_means(dataclasses.replace(batch, heights=heights[[k]], realizations_per_block=1))
        for k in (0, 1)
    ]
    expected = (each[0].scalars + each[1].scalars) / 2
    assert (each[0].scalars[:, 0, 0] != each[1].scalars[:, 0, 0]).all()
    np.testing.assert_allclose(both.scalars, expected, rtol=1e-14)


def test_blocks_are_different_realizations():
    scalars, curves, *_ = block_means(one_batch())
    assert len(np.unique(scalars[0, :, 0])) == 4
    assert len(np.unique(curves[0, :, 0])) == 4


def test_what_is_not_asked_for_is_no_number():
    scalars, curves, *_ = block_means(one_batch('scene.quantities=["steady"]'))
    missing = np.isnan(scalars).all(axis=(0, 1))
    assert [name for name, gone in zip(SCALARS, missing, strict=True) if gone] == ["jump"]
    assert np.isnan(curves).all()


def test_curves_end_where_the_march_ends():
    batch = one_batch("numerics.samples=64", "numerics.horizon=1.0")
    curves = block_means(batch).curves
    for task, curve in zip(batch.tasks, curves, strict=True):
        assert np.isfinite(curve).sum(axis=1).tolist() == [min(task.march_steps, 63)] * batch.blocks


def test_short_lines_are_run_together_and_long_ones_one_by_one(monkeypatch):
    """Which plays no part in what they give."""
    taken = []

    def spy(lines, prepared):
        taken.append(len(lines))
        return run_prepared(lines, prepared)

    monkeypatch.setattr(module, "run_prepared", spy)
    batch = one_batch("study.realizations_per_block=4")
    together = by_record([batch])
    monkeypatch.setattr(module, "SHORT", 1)
    assert by_record([batch]) == together
    lines = batch.blocks * batch.realizations_per_block
    assert lines > QUARTET
    assert sorted(set(taken)) == [1, lines]


def test_steps_that_are_given_are_not_refined():
    light = ("grid.normal_force=4e-5", "grid.velocity=100.0")
    (chosen, given) = (one_batch(*light, *more) for more in ([], ["numerics.steps_per_spacing=4"]))
    assert (chosen.refine, given.refine) == (True, False)
    assert not {task.key for task in chosen.tasks} & {task.key for task in given.tasks}
    as_sampled = dataclasses.replace(chosen, refine=False)
    rows = [block_means(batch).scalars[..., 0] for batch in (chosen, as_sampled)]
    assert not np.isclose(*rows, rtol=1e-3).any()


def test_time_is_booked_to_the_phases_that_were_asked_for():
    done = block_means(one_batch('scene.quantities=["steady"]'))
    assert done.spent.shape == (len(WHOLE.tasks) // 3, len(PHASES))
    booked = dict(zip(PHASES, done.spent.sum(axis=0), strict=True))
    assert booked["jump"] == booked["marching"] == 0.0
    assert min(booked["surfaces"], booked["steady"]) > 0.0
    assert sum(booked.values()) <= done.seconds


def test_every_task_pays_its_part():
    done = block_means(WHOLE)
    assert (done.spent > 0.0).all()
    assert done.spent.sum() <= done.seconds
    assert len(np.unique(done.spent[:, 0])) == 1  # of the lines all share
