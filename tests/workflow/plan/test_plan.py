"""The plan: every missing record exactly once, stable keys, additive prediction."""

from tests.support.small import all_records, keys, small_plan

GRID = ("grid.spacing=[1e-4, 2e-4]", "grid.velocity_step=[0.2, -0.2]")
PLAN = small_plan(*GRID)


def test_records_are_counted_and_have_keys_of_their_own():
    records = all_records(PLAN)
    assert len(set(records)) == len(records) == PLAN.records == 32 * 2 * 4


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


def test_copies_of_a_problem_share_a_key_between_studies():
    scaled = small_plan("grid.roughness=2e-5", "grid.normal_force=[0.08, 0.8]")
    assert keys(scaled) == keys(small_plan())
