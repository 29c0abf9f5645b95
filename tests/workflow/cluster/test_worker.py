"""What a worker does with a batch: the numbers of the driver, or a refusal."""

import pickle
import signal

import numpy as np
import pytest

from tests.support.small import cut_batches, small_plan
from workflow.cluster.versions import Versions, own_versions
from workflow.cluster.worker import dask_setup, run_batch
from workflow.errors import UserError
from workflow.simulate.realizations import block_means

BATCH = next(cut_batches(small_plan(), set(), 1e9))


def test_a_batch_on_a_worker_gives_the_bits_of_the_driver(client):
    far = client.submit(run_batch, BATCH, own_versions()).result()
    here = block_means(BATCH)
    assert far.scalars.tobytes() == here.scalars.tobytes()
    assert far.curves.tobytes() == here.curves.tobytes()


def test_a_worker_that_runs_something_else_computes_nothing():
    with pytest.raises(UserError, match="must run what the driver runs"):
        run_batch(BATCH, Versions(("numpy",), ("0.1",)))


def test_a_worker_leaves_ctrl_c_to_the_driver():
    before = signal.getsignal(signal.SIGINT)
    try:
        dask_setup(None)
        assert signal.getsignal(signal.SIGINT) == signal.SIG_IGN
    finally:
        signal.signal(signal.SIGINT, before)


def test_what_is_sent_comes_back_as_it_was():
    """Batches and results travel: what a network does to them must not change a bit."""
    result = block_means(BATCH)
    batch, again = pickle.loads(pickle.dumps((BATCH, result)))
    assert batch == BATCH
    assert np.array_equal(again.curves, result.curves, equal_nan=True)
