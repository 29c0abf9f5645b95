"""A chunk that kills whoever computes it: isolated, named, and the rest of the study finished."""

import os

import pytest

from tests.support.runs import run
from tests.support.shards import held
from tests.support.small import all_records, small_plan
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


def test_the_poisonous_problem_alone_is_blamed_and_the_rest_computed(standing, tmp_path):
    plan, _, path = run(standing.address, tmp_path, max_failures=1, work=poisonous)
    key = plan.variants[0].tasks[BAD].key
    store = Store(store_folder(path))
    assert list(store.failed) == [key]
    assert store.failed[key].startswith("its worker died 4 times")
    assert held(store) == {record for record in all_records(plan) if record[0] != key}
    whole = run(standing.address, tmp_path, retry_failed=True)
    assert whole.summary.failures == []
