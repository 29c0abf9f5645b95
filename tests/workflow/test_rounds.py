"""Rounds: the same bits whatever workers and crashes, and a file that says what was reached."""

import numpy as np
import pytest

from tests.workflow.runs import run, shards
from workflow.plan.goal import JACKKNIFE_GROUPS
from workflow.plan.plan import make_plan
from workflow.reduce.attainment import MET, MISSED
from workflow.reduce.jackknife import grouped_means, replicates, standard_error

WANTED = 0.08
SETTINGS = (
    f"numerics.accuracy={WANTED}",
    "grid.hurst=0.7",
    "compare.coarse.max_realizations=64",
    "compare.coarse.accuracy=0.05",
)


@pytest.fixture(scope="module")
def reached(scheduler, tmp_path_factory):
    """Return a finished run that was asked for an accuracy."""
    return run(scheduler, tmp_path_factory.mktemp("rounds"), *SETTINGS)


def test_points_end_with_what_they_need(reached):
    data = reached.load()
    assert (data.accuracy_status == MET).all()
    assert (data.accuracy_reached <= WANTED).all()
    assert (data.bias_bound <= 0.5 * WANTED).all()
    for name in ("mu_1", "jump", "relaxation_rate"):
        relative = data[f"{name}_error"] / abs(data[name])
        assert (relative + data.bias_bound >= relative).all()
        assert (relative <= data.accuracy_reached).all()
    assert (data.realizations % JACKKNIFE_GROUPS == 0).all()
    assert data.attrs["accuracy"] == WANTED


def test_points_that_hit_the_cap_are_named(reached):
    data = reached.load("coarse")
    assert data.realizations.max() == 64
    missed = data.accuracy_status == MISSED
    assert missed.any()
    assert (data.realizations.where(missed, 64) == 64).all()
    assert (data.accuracy_reached.where(missed, 1.0) > 0.05).all()
    (line, worst) = reached.summary.accuracy[1:]
    assert f"met at {int((~missed).sum())} of {missed.size} points" in line
    assert f"{float(data.accuracy_reached.max()):.2g}" in worst


def test_more_than_one_round_was_taken(reached):
    first = reached.plan.first
    counts = {t.key: first[t.key] for v in reached.plan.variants for t in v.tasks}
    data = reached.load()
    assert int(data.realizations.sum()) > sum(counts[t.key] for t in reached.plan.variants[0].tasks)


def test_other_batches_give_the_same_bytes(reached, scheduler, tmp_path):
    again = run(scheduler, tmp_path, *SETTINGS, batch_seconds=0.05)
    assert again.summary.batches > reached.summary.batches
    assert again.path.read_bytes() == reached.path.read_bytes()


def test_a_store_that_holds_more_or_less_gives_the_same_bytes(reached, scheduler, tmp_path):
    fine = (f"numerics.accuracy={WANTED / 1.3}", *SETTINGS[1:])
    run(scheduler, tmp_path, *fine)
    for victim in sorted((tmp_path / "store").glob("*.nc"))[::2]:
        victim.unlink()  # a crash of the disk
    again = run(scheduler, tmp_path, *SETTINGS)
    assert again.path.read_bytes() == reached.path.read_bytes()


def test_a_second_run_computes_nothing(reached, scheduler):
    before = shards(reached.path.parent)
    again = run(scheduler, reached.path.parent, *SETTINGS)
    assert (again.summary.batches, shards(reached.path.parent)) == (0, before)


def test_the_speed_of_the_machine_plays_no_part(reached):
    slow = reached.plan.timings._replace(case=1.0)
    plan = make_plan(reached.plan.study, slow)
    assert (plan.first, plan.expected) == (reached.plan.first, reached.plan.expected)
    assert [v.tasks for v in plan.variants] == [v.tasks for v in reached.plan.variants]


def test_groups_share_the_blocks_that_two_points_have_in_common():
    blocks = np.arange(12.0)
    assert grouped_means(blocks, 4).tolist() == [4.0, 5.0, 6.0, 7.0]
    assert grouped_means(blocks[:4], 4).tolist() == [0.0, 1.0, 2.0, 3.0]


def test_grouping_keeps_the_mean_and_its_error():
    rng = np.random.default_rng(4)
    blocks = rng.normal(1.0, 0.3, (JACKKNIFE_GROUPS * 50, 2))
    grouped = replicates(grouped_means(blocks, JACKKNIFE_GROUPS), 0)
    np.testing.assert_allclose(grouped[0], blocks.mean(axis=0))
    expected = 0.3 / np.sqrt(len(blocks))
    assert standard_error(grouped, 0) == pytest.approx(expected, rel=0.5)
