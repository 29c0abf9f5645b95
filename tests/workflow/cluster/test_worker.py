"""What a worker does with a batch: the numbers of the driver, or a refusal."""

import asyncio

import pytest

from elastomer_friction.workflow.cluster.client import open_client
from elastomer_friction.workflow.cluster.worker import run_batch
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.study.cluster import Cluster
from elastomer_friction.workflow.system import own_versions
from tests.support.python import PATIENCE
from tests.support.small import cut_batches, small_plan

BATCH = next(cut_batches(small_plan(), set(), 1e9))


def test_a_batch_on_a_worker_gives_the_bits_of_the_driver(client):
    """And what a network does to a batch and its results changes none."""
    far = client.submit(run_batch, BATCH, own_versions()).result()
    here = block_means(BATCH)
    assert far.scalars.tobytes() == here.scalars.tobytes()
    assert far.curves.tobytes() == here.curves.tobytes()


def test_a_worker_that_runs_something_else_computes_nothing():
    with pytest.raises(UserError, match="must have the versions of the driver"):
        run_batch(BATCH, {"numpy": "0.1"})


async def hang_a_heartbeat(dask_worker):
    """Let the next heartbeat of a worker find no connection and wait for a new one; wait for it."""
    pool, hangs = dask_worker.rpc, asyncio.Event()

    async def never(addr, timeout=None):
        hangs.set()
        await asyncio.sleep(PATIENCE)

    pool._connect = never
    for address in [*pool.available]:
        pool.remove(address)
    await asyncio.wait_for(hangs.wait(), PATIENCE)


def test_a_worker_that_closes_says_nothing_of_the_heartbeat_it_cuts_off(capfd):
    with open_client(Cluster(), 1) as client:
        client.run(hang_a_heartbeat)
    assert capfd.readouterr().err == ""
