"""Batches: every missing record exactly once, the requested length, additive prediction."""

import math
import random
from collections import Counter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastomer_friction.workflow.plan.batches import (
    MAX_SHARED_LENGTH,
    batch_target,
    cut,
    make_batches,
    missing_work,
    total_seconds,
)
from elastomer_friction.workflow.plan.variant import sharing
from tests.support.small import all_records, cut_batches, small_plan
from tests.support.sweeps import examples

GRID = ("grid.spacing=[1e-4, 2e-4]", "grid.velocity_step=[0.2, -0.2]")


PLAN = small_plan(*GRID)
BLOCKED = small_plan(*GRID, "study.realizations=48", "study.realizations_per_block=12")


def records_of(batches):
    """Return how often batches compute each record."""
    found = Counter()
    for batch in batches:
        blocks = range(batch.first_block, batch.first_block + batch.blocks)
        found.update((task.key, block) for task in batch.tasks for block in blocks)
    return found


def covered(plan, stored, target):
    """Return how often each record is computed."""
    return records_of(cut_batches(plan, stored, target))


def seconds(plan, stored=frozenset(), target=3.0):
    """Return the predicted core-seconds of what is not stored."""
    return sum(batch.seconds for batch in cut_batches(plan, set(stored), target))


@settings(max_examples=examples(30))
@given(
    st.sampled_from([PLAN, BLOCKED]),
    st.randoms(use_true_random=False),
    st.floats(0.0, 1.0),
    st.sampled_from([1e-9, 1e-4, 1e-3, 1e-2, 3.0, 1e9]),
)
def test_every_missing_record_is_computed_exactly_once(plan, rng: random.Random, share, target):
    records = all_records(plan)
    stored = {record for record in records if rng.random() < share}
    assert covered(plan, stored, target) == Counter(set(records) - stored)


def test_records_of_other_studies_in_the_store_do_not_matter():
    strangers = set(all_records(BLOCKED)) | {("0" * 32, 0)}
    assert covered(PLAN, strangers, 1.0) == Counter(all_records(PLAN))


def test_a_batch_stays_on_one_set_of_random_lines():
    for batch in cut_batches(PLAN, set(), 1e9):
        assert len({(task.problem.hurst, task.problem.elements) for task in batch.tasks}) == 1


@pytest.mark.parametrize("target", [1e-3, 1e-2, 0.1])
def test_batches_have_about_the_requested_length(target):
    for batch in cut_batches(PLAN, set(), target):
        together = batch.blocks == 1 and len({sharing(task) for task in batch.tasks}) == 1
        longest = 1.5 * target
        if together:  # with the drawing of its line
            longest = 1.5 * MAX_SHARED_LENGTH * target if len(batch.tasks) > 1 else math.inf
        assert batch.seconds <= longest


def test_loads_that_share_sweeps_stay_together_unless_they_take_too_long():
    plan = small_plan(*GRID, "grid.normal_force={geomspace=[0.01, 4.0, 6]}")

    def groups(target):
        pieces = cut(missing_work(plan, set()), target)
        return [
            {(piece.variant.label, *task.problem[:2], *sharing(task)) for task in piece.tasks}
            for piece in pieces
        ]

    together, apart = groups(1e-2), groups(1e-9)
    different = len(set().union(*together))
    assert len(together) > 2
    assert sum(map(len, together)) == different < len(plan.variants[0].tasks)
    assert len(apart) == sum(len(variant.tasks) for variant in plan.variants)


def test_long_pieces_come_first_and_the_longest_first():
    found = [batch.seconds for batch in cut_batches(PLAN, set(), 1e-9)]
    assert found == sorted(found, reverse=True) != sorted(found)


def test_predicted_time_of_realizations_adds_up():
    records = all_records(PLAN)
    late, early = ({r for r in records if (r[1] < 2) == half} for half in (True, False))
    assert seconds(PLAN, late) + seconds(PLAN, early) == pytest.approx(seconds(PLAN))
    assert seconds(BLOCKED) == pytest.approx(3 * seconds(PLAN))  # as many realizations
    assert total_seconds(missing_work(BLOCKED, set())) == pytest.approx(seconds(BLOCKED))


@pytest.mark.parametrize(("work", "target"), [(1.0, 1.0), (600.0, 3.0), (1e9, 10.0)])
def test_batches_grow_with_the_work_within_limits(work, target):
    assert batch_target(work) == pytest.approx(target)


@pytest.mark.parametrize("rate", [0.2, 1.0, 30.0])
def test_batches_last_as_long_as_requested_at_the_measured_rate(rate):
    target = 1e-2
    pieces = cut(missing_work(PLAN, set()), target)
    batches = list(make_batches(pieces, target, lambda _: rate))
    assert records_of(batches) == Counter(all_records(PLAN))
    several = [rate * b.seconds for b in batches if b.blocks > 1 or len(b.tasks) > 1]
    assert max(several, default=0.0) < 2.0 * MAX_SHARED_LENGTH * target
