"""Rounds: the same bits whatever workers and crashes, and a file that says what was reached."""

import math
import shutil

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.kernels import QUARTET
from elastomer_friction.workflow.plan.batches import missing_work
from elastomer_friction.workflow.plan.goal import JACKKNIFE_GROUPS
from elastomer_friction.workflow.reduce.attainment import MISSED
from elastomer_friction.workflow.reduce.fits import FITTED, NEGLIGIBLE
from elastomer_friction.workflow.run.collect import next_blocks
from elastomer_friction.workflow.run.failures import Failures
from elastomer_friction.workflow.run.store_key import is_unchanged
from elastomer_friction.workflow.store.store import Store, store_folder
from tests.support.runs import run

WANTED = 0.03
SETTINGS = (
    f"numerics.accuracy={WANTED}",
    "grid.hurst=0.7",
    "compare.coarse.max_realizations=256",
    "compare.coarse.accuracy=0.02",
)


@pytest.fixture(scope="module")
def reached(tmp_path_factory):
    """Return a finished run that was asked for an accuracy."""
    return run(tmp_path_factory.mktemp("rounds"), *SETTINGS)


def test_points_end_with_what_they_need_after_more_than_one_round(reached):
    data = reached.load()
    assert (data.accuracy_status != MISSED).all()  # next to nothing relaxes at slow points
    assert (data.fit_status == NEGLIGIBLE).any()
    assert (data.accuracy_reached <= WANTED).all()
    for name in ("mu_1", "jump", "relaxation_rate"):
        sought = data.fit_status == FITTED if name == "relaxation_rate" else data.mu_1 > 0.0
        assert (data[f"{name}_bias"].where(sought, 0.0) <= 0.5 * WANTED).all()
        error = (data[f"{name}_error"] / abs(data[name])).where(sought, 0.0)
        assert (error <= data.accuracy_reached).all()
    groups = np.minimum(data.realizations // QUARTET, JACKKNIFE_GROUPS)
    assert np.array_equal(data.degrees_of_freedom, groups - 1)
    assert data.mu_1_error.attrs["degrees_of_freedom"] == data.degrees_of_freedom.min()
    assert data.attrs["accuracy"] == WANTED
    tasks = reached.plan.variants[0].tasks
    first = QUARTET * sum(reached.plan.first[task.key] for task in tasks)
    assert data.realizations.sum() > first


def test_points_that_hit_the_cap_are_named(reached):
    data = reached.load("coarse")
    assert data.realizations.max() == 256
    missed = data.accuracy_status == MISSED
    assert missed.any()
    assert (data.realizations.where(missed, 256) == 256).all()
    assert (data.accuracy_reached.where(missed, 1.0) > 0.02).all()
    *_, line, worst = reached.summary.estimates
    assert f"met at {int((~missed).sum())} of {missed.size} points" in line
    assert f"{float(data.accuracy_reached.max()):.2g}" in worst


def test_other_batches_and_a_store_that_holds_more_or_less_give_the_same_bytes(reached, tmp_path):
    fine = (f"numerics.accuracy={WANTED / 1.3}", *SETTINGS[1:])
    folder = shutil.copytree(reached.path.parent, tmp_path / "copy")
    needed = sorted((folder / "store").glob("*.npz"))
    run(folder, *fine)
    for victim in needed[::2]:
        victim.unlink()  # a crash of the disk
    again = run(folder, *SETTINGS, batch_seconds=0.01)
    assert again.summary.batches > 0
    assert again.path.read_bytes() == reached.path.read_bytes()


def test_a_result_stays_where_the_records_are_that_it_is_made_of_whatever_was_expected(reached):
    plan, store = reached.plan, Store(store_folder(reached.path))
    assert plan.first != plan.expected
    stored = Failures(store, plan, 0)
    assert is_unchanged(plan, store, stored, reached.path, missing_work(plan, ()))
    assert not is_unchanged(plan, store, (), reached.path, [])


@given(st.integers(2, 600), st.floats(0.0, 1e9) | st.just(math.inf), st.integers(2, 10_000))
def test_the_next_round_grows_within_the_cap(now, growth, most):
    most = max(now, most)
    found = next_blocks(now, growth, most)
    assert found <= most
    if growth <= 1.0 or now == most:
        assert found == now
    else:
        assert now < found <= 4 * now
        assert found == most or found >= min(growth, 4.0) * now - 1e-6


@pytest.mark.parametrize(
    ("growth", "expected"),
    [
        (1.01, 1.25),  # at least a quarter more, or many rounds would be needed
        (2.0, 2.2),  # a tenth more than is lacking, or every other point would miss it by a hair
        (3.6, 3.96),
        (50.0, 4.0),  # no more than four times as many: the error is an estimate itself
    ],
)
def test_the_next_round_has_a_margin_within_its_bounds(growth, expected):
    assert next_blocks(100 * JACKKNIFE_GROUPS, growth, 10**9) == pytest.approx(
        expected * 100 * JACKKNIFE_GROUPS, abs=JACKKNIFE_GROUPS
    )
