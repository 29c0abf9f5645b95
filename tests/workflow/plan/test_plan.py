"""Plans: tasks sized by the laws, with keys that identify all inputs of their numbers."""

import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.plan import goal
from elastomer_friction.workflow.plan import variant as module
from elastomer_friction.workflow.plan.plan import make_plan
from tests.support.documents import without
from tests.support.small import all_records, keys, small_plan, small_study

PLAN = small_plan("grid.spacing=[1e-4, 2e-4]", "grid.velocity_step=[0.2, -0.2]")


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


def test_variants_of_one_material_share_their_problems():
    own, compared = PLAN.variants
    assert own.point_task is compared.point_task
    assert all(a.problem is b.problem for a, b in zip(own.tasks, compared.tasks, strict=True))


UNCHANGED = [
    "grid.normal_force=[0.01, 0.04, 0.4, 9.0]",
    "grid.hurst=[0.0, 0.3, 0.5, 0.7, 1.0]",
    "grid.spacing=[1e-4, 5e-5]",
    "grid.velocity=[0.1, 0.03, 0.2]",
    "grid.velocity_step=[0.2, -0.5]",
    "study.realizations=40",
    "study.title=other",
    "cluster.jobs=7",
    'cluster.memory="4GB"',
    "compare.coarse.samples=20",
    'scene.quantities=["steady", "jump", "relaxation", "models"]',
]


@pytest.mark.parametrize("setting", UNCHANGED)
def test_widening_a_study_keeps_the_keys_it_had(setting):
    assert set(keys(small_plan())) <= set(keys(small_plan(setting)))


CHANGED = [
    "study.seed=2",
    "study.realizations_per_block=8",
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
    monkeypatch.setattr(module, "CODE_HASH", "0" * 16)
    assert set(before).isdisjoint(keys(small_plan()))


def test_study_and_comparison_do_not_share_keys():
    own, compared = ({task.key for task in variant.tasks} for variant in PLAN.variants)
    assert own.isdisjoint(compared)


def test_a_measured_line_that_is_too_long_is_refused_with_a_remedy(monkeypatch):
    monkeypatch.setattr(goal, "MAX_SAMPLES_PER_LINE", 50)
    left_out = ("surface.length", "grid.hurst", "grid.spacing", "grid.roughness")
    text = without(*left_out, "study.realizations")
    study = small_study('surface.file="line.csv"', text=text)
    with pytest.raises(
        UserError, match=r"set numerics\.steps_per_spacing = 2 or less, surface\.per"
    ):
        make_plan(study)
