"""Collecting: stored block means become estimates, those of a task once, however they lie."""

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.plan.batches import cut, make_batches, missing_work
from elastomer_friction.workflow.plan.goal import JACKKNIFE_GROUPS
from elastomer_friction.workflow.reduce.portions import reduce_portion
from elastomer_friction.workflow.run import graph as graph_module
from elastomer_friction.workflow.run.collect import Collector
from elastomer_friction.workflow.run.graph import FitNode
from elastomer_friction.workflow.run.workers import PoolHere
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.simulate.tasks import SCALARS
from elastomer_friction.workflow.store.store import Store
from tests.support.simulated import stream
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


@pytest.fixture
def collector(store):
    """Return a collector of that store."""
    return Collector(PLAN, store)


def fit_all(collector, marches=(), blocks=None):
    """Fit all tasks in this process; return the marches' nodes and the fits, in order."""
    graph, done = collector.graph(blocks or BLOCKS, collector.store.read), []
    nodes = graph.nodes([*marches], 1e9, lambda _: 1.0)
    functions = {"march": block_means, "fit": reduce_portion}
    for node, value in stream(PoolHere(functions), nodes, retry=pytest.fail):
        done.append(node.name)
        if isinstance(node, FitNode):
            collector.enter(node, value[0])
    return done


def datasets(collector):
    """Return the datasets after all is fitted."""
    fit_all(collector)
    return collector.datasets(BLOCKS)


def test_estimates_of_every_point_are_the_means_of_its_own_blocks(collector, store):
    data = datasets(collector)[""]
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


def test_portions_do_not_show(collector, store, monkeypatch):
    whole = datasets(collector)
    monkeypatch.setattr(graph_module, "MAX_TASKS", 1)
    for label, data in datasets(Collector(PLAN, store)).items():
        assert data.identical(whole[label])


@pytest.mark.parametrize("kept", [0, 12])
def test_results_of_marches_and_stored_records_give_the_same_fit(tmp_path, kept):
    """Of marches in batches of one block, some of which are stored; a fit precedes the last."""
    batches = [*make_batches(cut(missing_work(PLAN, ()), 1e-9), 1e-9)]
    store = Store(tmp_path)
    if kept:
        store.add([(batch, block_means(batch)) for batch in batches[:kept]])
    collector, rest = Collector(PLAN, store), cut(missing_work(PLAN, store), 1e-9)
    done = fit_all(collector, rest)
    assert done.index("fit") < len(done) - 1 - done[::-1].index("march")
    left = [batch for batch in batches if (batch.tasks[0].key, batch.first_block) not in store]
    store.add([(batch, block_means(batch)) for batch in left])
    expected = datasets(Collector(PLAN, store))
    for label, data in collector.datasets(BLOCKS).items():
        assert data.identical(expected[label])


def test_what_is_fitted_from_so_many_blocks_stays_as_it_is(collector):
    assert fit_all(collector) == ["fit"] * 2  # a variant each
    assert fit_all(collector) == []
    fitted = collector.fitted[""]
    assert fitted.blocks.tolist() == [4] * 8
    assert fitted.at([0, 2])["rate_replicates"].shape == (2, JACKKNIFE_GROUPS + 1)
    fewer = BLOCKS | {VARIANT.tasks[1].key: 3}
    assert fit_all(collector, blocks=fewer) == ["fit"]
    assert fitted.blocks.tolist() == [4, 3, *[4] * 6]


def test_failed_tasks_are_marked_and_nothing_left_is_said(collector, store):
    for task in VARIANT.tasks[1:]:
        store.record_failure(task.key, "why")
    data = datasets(collector)[""]
    sound = VARIANT.point_task == 0
    assert np.array_equal(data.realizations.values > 0, sound)
    assert np.array_equal(np.isfinite(data.mu_1.values), sound)
    assert (data.fit_status.values[~sound] == -1).all()
    store.record_failure(VARIANT.tasks[0].key, "why")
    with pytest.raises(UserError, match="the study: all problems failed"):
        collector.datasets(BLOCKS)
