"""A chunk that kills whoever computes it: isolated, named, and the rest of the study finished."""

import os

import numpy as np
import pytest

from tests.workflow.runs import run
from tests.workflow.shards import held
from tests.workflow.small import all_records, small_plan
from workflow.cluster import worker as work
from workflow.cluster.versions import Versions
from workflow.simulate.tasks import Batch, BatchResult
from workflow.store.store import Store, store_folder

pytestmark = pytest.mark.cluster
BAD = 1  # number of the task that kills


def poisonous(batch: Batch, expected: Versions) -> BatchResult:
    """Run a batch, but die of one problem; stands in for run_batch."""
    if any(task.key == small_plan().variants[0].tasks[BAD].key for task in batch.tasks):
        os._exit(1)
    return work.run_batch(batch, expected)


@pytest.fixture(scope="module")
def poisoned(standing, tmp_path_factory):
    """Return a run of the small study with a poisonous problem, and its result."""
    folder = tmp_path_factory.mktemp("poisoned")
    done = run(standing.address, folder, max_failures=1, work=poisonous)
    return done, done.load()


def test_the_poisonous_problem_alone_is_blamed(poisoned):
    plan, _, path = poisoned[0]
    key = plan.variants[0].tasks[BAD].key
    store = Store(store_folder(path))
    assert list(store.failed) == [key]
    assert store.failed[key].startswith("its worker died 4 times")
    assert held(store) == {record for record in all_records(plan) if record[0] != key}


def test_the_result_marks_it_and_what_was_innocent_is_as_ever(poisoned, standing):
    (plan, _, path), marked = poisoned
    whole = run(standing.address, path.parent, retry_failed=True)
    assert whole.summary.failures == []
    sound = plan.point_task != BAD
    assert np.array_equal(marked.realizations.values > 0, sound)
    for name in ("mu_1", "jump", "deviation"):
        values, expected = marked[name].values[sound], whole.load()[name].values[sound]
        assert np.array_equal(values, expected, equal_nan=True)
