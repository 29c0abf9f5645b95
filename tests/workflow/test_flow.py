"""Streaming: each item once, a bounded number in flight, and no silent end."""

import math
import subprocess
import sys
import time

import pytest
from distributed import Client
from distributed.comm import CommClosedError
from distributed.scheduler import KilledWorker

from tests.workflow.runs import PATIENCE
from workflow.cluster.flow import raise_error, stream
from workflow.cluster.watch import Watch
from workflow.errors import UserError


def test_each_item_comes_back_once_with_its_result(client):
    found = list(stream(client, math.sqrt, range(100)))
    assert sorted(found) == [(i, math.sqrt(i)) for i in range(100)]


def test_equal_items_are_computed_each(client):
    assert list(stream(client, abs, [-1, -1, -1])) == [(-1, 1)] * 3


def test_nothing_comes_of_nothing(client):
    assert list(stream(client, math.sqrt, [])) == []


def test_few_items_are_in_flight(client):
    drawn, ahead = [0], []

    def items():
        for i in range(200):
            drawn[0] += 1
            yield i

    for count, _ in enumerate(stream(client, abs, items()), start=1):
        ahead.append(drawn[0] - count)
    assert drawn[0] == 200
    assert max(ahead) <= 16  # eight in flight for two workers, eight being handed over


def test_after_a_stop_only_what_is_running_is_awaited(client):
    drawn, stopped = [0], [False]

    def items():
        for i in range(1000):
            drawn[0] += 1
            yield i

    found = []
    for item, _ in stream(client, abs, items(), Watch(lambda: stopped[0])):
        found.append(item)
        stopped[0] = True
    assert 1 <= len(set(found)) == len(found) <= drawn[0] <= 24


def test_an_error_on_a_worker_is_raised_here(client):
    with pytest.raises(ValueError, match=r"math domain error|nonnegative"):
        list(stream(client, math.sqrt, [1.0, -1.0]))


def test_an_item_whose_worker_died_gets_one_chance_alone():
    killed = KilledWorker("key", None, 3)
    assert raise_error(7, killed, False) == [7]
    with pytest.raises(KilledWorker):
        raise_error(7, killed, True)


def halves(item, error, alone):
    """Return two items instead of one that failed."""
    return [abs(item) / 2.0] * 2


def test_what_failed_is_replaced_and_the_rest_goes_on(client):
    found = list(stream(client, math.sqrt, [4.0, -2.0, 9.0], retry=halves))
    assert sorted(found) == [(1.0, 1.0), (1.0, 1.0), (4.0, 2.0), (9.0, 3.0)]


def test_a_scheduler_that_dies_during_a_transfer_is_reported(client, monkeypatch):
    def lost(_):
        raise CommClosedError("in <TCP (closed) ConnectionPool.gather>")

    monkeypatch.setattr(client, "gather", lost)
    with pytest.raises(UserError, match="the scheduler was lost; run again to resume"):
        list(stream(client, abs, [1]))


SCHEDULER = """
import time
from distributed import LocalCluster
options = {"protocol": "tcp", "dashboard_address": ":0"}
with LocalCluster(n_workers=1, threads_per_worker=2, processes=False, **options) as cluster:
    print(cluster.scheduler_address, flush=True)
    time.sleep(600)
"""


@pytest.fixture
def mortal():
    """Return a process that runs a scheduler with workers, and the address of that."""
    process = subprocess.Popen([sys.executable, "-c", SCHEDULER], stdout=subprocess.PIPE, text=True)
    try:
        yield process, process.stdout.readline().strip()
    finally:
        process.kill()
        process.communicate(timeout=PATIENCE)


def test_a_scheduler_that_dies_is_no_end_of_the_work(mortal):
    process, address = mortal
    with Client(address, timeout=PATIENCE) as client:
        results = stream(client, time.sleep, [0.01] + [600.0] * 15)
        assert next(results) == (0.01, None)
        process.kill()
        with pytest.raises(UserError, match="the scheduler was lost; run again to resume"):
            list(results)
