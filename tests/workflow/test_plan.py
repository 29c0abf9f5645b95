"""The plan: every missing record exactly once, stable keys, additive prediction."""

import random
from collections import Counter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.workflow.small import all_records, cut_batches, keys, small_plan
from workflow.plan import plan as planning
from workflow.plan.batches import batch_target

GRID = ("grid.spacing=[1e-4, 2e-4]", "grid.velocity_step=[0.2, -0.2]")
PLAN = small_plan(*GRID)
BLOCKED = small_plan(*GRID, "study.realizations=12", "study.realizations_per_block=3")


def covered(plan, stored, target):
    """Return how often each record is computed."""
    found = Counter()
    for batch in cut_batches(plan, stored, target):
        blocks = range(batch.first_block, batch.first_block + batch.blocks)
        found.update((task.key, block) for task in batch.tasks for block in blocks)
    return found


def seconds(plan, stored=frozenset(), target=3.0):
    """Return the predicted core-seconds of what is not stored."""
    return sum(batch.seconds for batch in cut_batches(plan, set(stored), target))


@settings(max_examples=60, deadline=None)
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


def test_records_are_counted_and_have_keys_of_their_own():
    records = all_records(PLAN)
    assert len(set(records)) == len(records) == PLAN.records == 32 * 2 * 4


def test_a_batch_stays_on_one_set_of_random_lines():
    for batch in cut_batches(PLAN, set(), 1e9):
        assert len({(task.problem.hurst, task.problem.elements) for task in batch.tasks}) == 1


@pytest.mark.parametrize("target", [1e-3, 1e-2, 0.1])
def test_batches_last_about_as_long_as_asked(target):
    for batch in cut_batches(PLAN, set(), target):
        assert batch.seconds <= 1.5 * target or (batch.blocks == 1 and len(batch.tasks) == 1)


def test_what_cannot_be_cut_to_size_comes_first_and_longest_first():
    found = [batch.seconds for batch in cut_batches(PLAN, set(), 1e-9)]
    assert found[0] > found[-1]
    assert found == sorted(found, reverse=True)


def test_a_longer_target_gives_fewer_batches():
    counts = [len(list(cut_batches(PLAN, set(), target))) for target in (1e-5, 1e-3, 1e3)]
    assert counts == sorted(counts, reverse=True)
    assert counts[0] > counts[1] > counts[2]


def test_predicted_time_of_two_halves_adds_up():
    records = all_records(PLAN)
    late, early = ({r for r in records if (r[1] < 2) == half} for half in (True, False))
    assert seconds(PLAN, late) + seconds(PLAN, early) == pytest.approx(seconds(PLAN))


def test_predicted_time_grows_with_the_realizations():
    twice = small_plan(*GRID, "study.realizations=8")
    assert seconds(twice) == pytest.approx(2 * seconds(PLAN))


def test_nothing_is_predicted_where_all_is_stored():
    assert seconds(PLAN, all_records(PLAN)) == 0


def test_less_is_predicted_where_less_is_asked():
    steady = small_plan(*GRID, 'scene.quantities=["steady"]')
    jump = small_plan(*GRID, 'scene.quantities=["steady", "jump"]')
    assert seconds(steady) < seconds(jump)


@pytest.mark.parametrize(("work", "target"), [(1.0, 1.0), (600.0, 3.0), (1e9, 10.0)])
def test_batches_grow_with_the_work_within_limits(work, target):
    assert batch_target(work) == pytest.approx(target)


def test_only_a_relaxation_is_marched():
    jump = small_plan('scene.quantities=["jump"]')
    assert all(task.march_steps == 0 for task in jump.variants[0].tasks)
    assert all(task.march_steps >= 8 for task in PLAN.variants[0].tasks)


def test_memory_follows_the_longest_line():
    assert PLAN.longest_line() == max(
        t.problem.elements * t.steps_per_spacing for t in PLAN.variants[0].tasks
    )
    longer = small_plan("numerics.steps_per_spacing=50000")
    assert longer.predicted_worker_bytes() > 2 * PLAN.predicted_worker_bytes()


UNCHANGED = [
    "grid.normal_force=[0.01, 0.04, 0.4, 9.0]",
    "grid.hurst=[0.0, 0.3, 0.5, 0.7, 1.0]",
    "grid.spacing=[1e-4, 5e-5]",
    "grid.velocity=[0.1, 0.03, 0.2]",
    "grid.velocity_step=[0.2, -0.5]",
    "study.realizations=40",
    "study.title=other",
    "compare.coarse.samples=20",
    'scene.quantities=["steady", "jump", "relaxation", "models"]',
]


@pytest.mark.parametrize("setting", UNCHANGED)
def test_widening_a_study_keeps_the_keys_it_had(setting):
    assert set(keys(small_plan())) <= set(keys(small_plan(setting)))


CHANGED = [
    "study.seed=2",
    "study.realizations_per_block=2",
    "surface.normalisation=integral",
    'scene.quantities=["steady", "jump"]',
    "scene.indentation_rate=false",
    "numerics.scheme=implicit-euler",
    "numerics.steps_per_spacing=64",
    "numerics.samples=17",
    "numerics.horizon=8.0",
    "grid.velocity_step=0.3",
    "material.shear_modulus=1.01e7",
]


@pytest.mark.parametrize("setting", CHANGED)
def test_a_setting_that_changes_results_changes_every_key(setting):
    assert set(keys(small_plan())).isdisjoint(keys(small_plan(setting)))


def test_other_program_code_changes_every_key(monkeypatch):
    before = keys(small_plan())
    monkeypatch.setattr(planning, "CODE", "0" * 16)
    assert set(before).isdisjoint(keys(small_plan()))


def test_study_and_comparison_do_not_share_keys():
    own, compared = ({task.key for task in variant.tasks} for variant in PLAN.variants)
    assert own.isdisjoint(compared)


def test_copies_of_a_problem_share_a_key_between_studies():
    scaled = small_plan("grid.roughness=2e-5", "grid.normal_force=[0.08, 0.8]")
    assert keys(scaled) == keys(small_plan())
