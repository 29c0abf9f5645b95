"""What dask's workers come to: with the worker that did it, and never waited for without end."""

import asyncio
import time
from operator import truediv
from threading import Event

import pytest
from distributed.comm import CommClosedError
from distributed.scheduler import KilledWorker

from elastomer_friction.workflow.cluster import Call, ResultLost, WorkerDied
from elastomer_friction.workflow.cluster import pool as module
from elastomer_friction.workflow.cluster.pool import Pool
from elastomer_friction.workflow.ground import UserError
from tests.support.python import PATIENCE


def arrivals(pool, count):
    """Return what comes next."""
    actual, end = [], time.monotonic() + PATIENCE
    while len(actual) < count:
        assert time.monotonic() < end, actual
        actual += pool.take(0.01)
    return actual


def submitted(pool, items, workers=()):
    """Submit marches; return their futures by key."""
    return pool.submit([Call("march", item, []) for item in items], workers)


def reciprocal(value):
    """Divide by a value."""
    return truediv(1.0, value)


def test_what_is_for_one_worker_is_computed_there_and_what_is_dropped_does_not_come(client):
    pool, (first, _) = Pool(client, {"march": reciprocal}), client.nthreads()
    futures = submitted(pool, [1.0, 2.0, 3.0], [first])
    dropped = next(iter(futures))
    pool.drop([dropped])
    del futures[dropped]
    actual = arrivals(pool, 2)
    assert {one.key: one.address for one in actual} == dict.fromkeys(futures, first)
    assert pool.take(0.05) == []
    assert all(map(pool.holds, futures.values()))


SEEN = Event()  # the workers of these tests are threads of this process


def until_seen(_):
    """Last until it was seen that this has running."""
    SEEN.wait(PATIENCE)


def change(status, address, dask_scheduler):
    """Let a scheduler take a worker for paused, or running; run there."""
    dask_scheduler.handle_worker_status_change(status, address, "test")


def test_a_snapshot_tells_who_is_there_who_takes_up_work_and_what_has_running(client):
    first, second = client.nthreads()
    pool = Pool(client, {"march": until_seen})
    SEEN.clear()
    client.run_on_scheduler(change, "paused", first)
    try:
        actual = pool.request_snapshot().result(PATIENCE)
        assert (actual.threads, [*actual.ready], {*actual.running}) == (
            client.nthreads(),
            [second],
            set(),
        )
        futures = submitted(pool, [1], [second]) | submitted(pool, [2], [first])
        running, waiting = futures
        while not (actual := pool.request_snapshot().result(PATIENCE)).running:
            time.sleep(0.01)
        assert {*actual.running} == {running}
        assert pool.take(0.0) == []
        assert pool.pending(running)
        assert not pool.holds(futures[running])
        assert pool.pending(waiting)
        pool.drop(futures)
    finally:
        SEEN.set()
        client.run_on_scheduler(change, "running", first)


def test_results_that_do_not_come_are_lost_each_by_itself(client, monkeypatch):
    """As those of a worker that was stopped when it was done."""

    async def never(*_, **__):
        await asyncio.sleep(PATIENCE)

    monkeypatch.setattr(module, "FETCH_SECONDS", 0.05)
    monkeypatch.setattr(client, "_gather", never)
    pool = Pool(client, {"march": reciprocal})
    futures = submitted(pool, [4.0, 5.0])
    while any(map(pool.pending, futures)):
        time.sleep(0.01)
    lost = arrivals(pool, 2)
    assert {one.key: one.address for one in lost} == dict.fromkeys(futures, "")
    assert all(isinstance(one.error, ResultLost) for one in lost)


def test_a_slow_scheduler_is_told_of_all_that_was_fetched_by_one_call_at_a_time(
    client, monkeypatch
):
    """Each call at the same time would open a connection, which dask then keeps."""
    told, running, most = [], 0, 0

    async def slow(_, keys):
        nonlocal running, most
        running, most = running + 1, max(most, running + 1)
        await asyncio.sleep(0.1)
        told.append(keys)
        running -= 1

    monkeypatch.setattr(client, "run_on_scheduler", slow)
    pool = Pool(client, {"march": reciprocal})
    futures = {}
    for number in range(1, 13):
        futures |= submitted(pool, [number])
        arrivals(pool, 1)
    for _ in range(int(100 * PATIENCE)):
        if running == 0 and sum(map(len, told)) == len(futures):
            break
        time.sleep(0.01)
    assert sorted(key for keys in told for key in keys) == sorted(futures)
    assert most == 1
    assert len(told) < len(futures)


def test_a_scheduler_that_is_lost_while_it_is_asked_is_reported(client, monkeypatch):
    class Lost:
        async def ncores(self):
            raise CommClosedError

        ncores_running = processing = ncores

    pool = Pool(client, {})
    monkeypatch.setattr(pool, "_scheduler", Lost())
    with pytest.raises(UserError, match="the scheduler was lost; run again to resume"):
        pool.request_snapshot().result(PATIENCE)


def test_a_call_that_killed_its_workers_says_how_many():
    died = module._meaning(None, KilledWorker("march-1", None, 3))
    assert isinstance(died, WorkerDied)
    assert (died.deaths, str(died)) == (4, "4 different workers died")
