"""What a worker does with a batch: the numbers of the driver, or a refusal."""

import asyncio
from types import SimpleNamespace

import dask
import pytest

from elastomer_friction.workflow.cluster import client as client_module
from elastomer_friction.workflow.cluster.client import open_client
from elastomer_friction.workflow.cluster.worker import forget_tasks
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.run.workers import run_batch
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.study.cluster import Cluster
from elastomer_friction.workflow.system import own_versions, version_of
from tests.support.python import PATIENCE
from tests.support.small import cut_batches, small_plan

PACKAGES = ("dask", "distributed")  # of a scheduler
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


def test_a_scheduler_forgets_how_to_compute_only_what_is_computed():
    tasks = {state: SimpleNamespace(state=state, run_spec=1) for state in ("memory", "processing")}
    forget_tasks(["gone", *tasks], SimpleNamespace(tasks=tasks))
    assert [task.run_spec for task in tasks.values()] == [None, 1]


def test_a_scheduler_of_other_versions_is_refused_before_a_client_connects(scheduler, monkeypatch):
    others = dict.fromkeys(PACKAGES, "0.1")
    monkeypatch.setattr(client_module, "own_versions", lambda: others)
    monkeypatch.setattr(client_module, "_connected", None)
    refusal = pytest.raises(UserError, match="schedulers must have the versions")
    with refusal as refused, open_client(Cluster(scheduler)):
        pass
    rows = [line.split() for line in str(refused.value).splitlines()[2:]]
    assert rows == [[name, version_of(name), "0.1"] for name in PACKAGES]


def test_settings_of_the_user_do_not_end_workers_or_the_scheduler():
    hostile = {
        "distributed.scheduler.idle-timeout": "1ms",
        "distributed.scheduler.no-workers-timeout": "1ms",
        "distributed.worker.lifetime.duration": "1ms",
    }
    with dask.config.set(hostile), open_client(Cluster(), 1) as client:
        settings = client.run(lambda: dask.config.get("distributed.worker.lifetime.duration"))
        assert list(settings.values()) == [None]
        scheduler = client.cluster.scheduler
        assert scheduler.idle_timeout is None
        assert scheduler.no_workers_timeout is None
        assert scheduler.WORKER_SATURATION == 1.0  # no batch waits on a worker


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
