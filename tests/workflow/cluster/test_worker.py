"""What a worker does with a batch: the numbers of the driver, or a refusal."""

import pytest

from tests.support.small import cut_batches, small_plan
from workflow.cluster.versions import own_versions
from workflow.cluster.worker import run_batch
from workflow.errors import UserError
from workflow.simulate.realizations import block_means

BATCH = next(cut_batches(small_plan(), set(), 1e9))


def test_a_batch_on_a_worker_gives_the_bits_of_the_driver(client):
    """And what a network does to a batch and its results changes none."""
    far = client.submit(run_batch, BATCH, own_versions()).result()
    here = block_means(BATCH)
    assert far.scalars.tobytes() == here.scalars.tobytes()
    assert far.curves.tobytes() == here.curves.tobytes()


def test_a_worker_that_runs_something_else_computes_nothing():
    with pytest.raises(UserError, match="must run what the driver runs"):
        run_batch(BATCH, {"numpy": "0.1"})
