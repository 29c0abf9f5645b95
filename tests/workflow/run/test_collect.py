"""Collecting: stored block means become estimates, those of a task once, however they lie."""

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.plan.goal import JACKKNIFE_GROUPS
from elastomer_friction.workflow.run import collect
from elastomer_friction.workflow.run.collect import Collector, Fitted
from elastomer_friction.workflow.run.summary import Summary
from elastomer_friction.workflow.run.workers import Workers, stream_here
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.simulate.tasks import SCALARS
from elastomer_friction.workflow.store.store import Store
from elastomer_friction.workflow.system.watch import Watch
from tests.support.small import cut_batches, random_result, small_plan

PLAN = small_plan()
VARIANT = PLAN.variants[0]
BLOCKS = {task.key: 4 for variant in PLAN.variants for task in variant.tasks}


@pytest.fixture
def store(tmp_path):
    """Return a store of random block means for the whole plan."""
    store = Store(tmp_path)
    work = list(cut_batches(PLAN, set(), 1e9))
    store.add([(batch, random_result(batch, seed)) for seed, batch in enumerate(work)])
    return store


HERE = Workers(stream_here, block_means)


@pytest.fixture
def collector(store):
    """Return a collector of that store."""
    return Collector(HERE, store, PLAN, Summary(), Watch())


def test_estimates_of_every_point_are_the_means_of_its_own_blocks(collector, store):
    data = collector.datasets(BLOCKS)[""]
    task = VARIANT.point_task
    h_over_dx = 1e-5 / 1e-4
    for place in np.ndindex(task.shape):
        records = [(VARIANT.tasks[task[place]].key, block) for block in range(4)]
        means = store.read(records, 15)[0][:, SCALARS.index("mu_1")]
        assert data.mu_1.values[place] == pytest.approx(means.mean() * h_over_dx, rel=1e-12)
        error = means.std(ddof=1) / 2.0 * h_over_dx
        assert data.mu_1_error.values[place] == pytest.approx(error, rel=1e-9)
    assert "rate_replicates" not in data  # they are for the power law
    assert data.alpha.dims == ("hurst",)


def test_portions_do_not_show(collector, monkeypatch):
    whole = collector.datasets(BLOCKS)
    monkeypatch.setattr(collect, "TASKS_PER_REDUCTION", 1)
    collector.fitted = {variant.label: Fitted(variant) for variant in PLAN.variants}
    for label, data in collector.datasets(BLOCKS).items():
        assert data.identical(whole[label])


def test_what_is_fitted_from_so_many_blocks_stays_as_it_is(collector, monkeypatch):
    rows = [0, 2]
    reporter = collector.reporter("fitting", [(VARIANT, rows)], BLOCKS)
    assert reporter.total > 0.0
    collector.fit(VARIANT, rows, BLOCKS, reporter)
    assert reporter.done == pytest.approx(reporter.total)
    assert collector.fitted[""].blocks.tolist() == [4, 0, 4, 0, 0, 0, 0, 0]
    assert collector.summary.phases["fits"] > 0.0
    assert collector.fitted[""].at(rows)["rate_replicates"].shape == (2, JACKKNIFE_GROUPS + 1)
    monkeypatch.setattr(collector, "_load", pytest.fail)
    assert collector.fit(VARIANT, rows, BLOCKS, reporter)


def test_failed_tasks_are_marked_and_nothing_left_is_said(collector, store):
    for task in VARIANT.tasks[1:]:
        store.record_failure(task.key, "why")
    data = collector.datasets(BLOCKS)[""]
    sound = VARIANT.point_task == 0
    assert np.array_equal(data.realizations.values > 0, sound)
    assert np.array_equal(np.isfinite(data.mu_1.values), sound)
    assert (data.fit_status.values[~sound] == -1).all()
    store.record_failure(VARIANT.tasks[0].key, "why")
    with pytest.raises(UserError, match="the study: all problems failed"):
        collector.datasets(BLOCKS)


def test_after_a_stop_there_is_no_dataset(store):
    stopped = Collector(HERE, store, PLAN, Summary(), Watch(lambda: True))
    assert stopped.datasets(BLOCKS) == {}
