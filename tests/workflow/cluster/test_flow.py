"""Streaming: each item once, a bounded number in flight, and no silent end."""

import math
import time

import pytest
from distributed import Client
from distributed.comm import CommClosedError
from distributed.scheduler import KilledWorker

from tests.support.runs import PATIENCE, standing
from workflow.cluster.flow import raise_error, stream
from workflow.cluster.watch import Watch
from workflow.errors import UserError


@pytest.mark.parametrize("items", [range(100), [4, 4, 4], []], ids=["many", "equal", "none"])
def test_each_item_comes_back_once_with_its_result(client, items):
    found = list(stream(client, math.sqrt, items))
    assert sorted(found) == [(i, math.sqrt(i)) for i in items]


@pytest.fixture
def counted():
    """Return a hundred items, and a list of those that were drawn."""
    drawn = []

    def items():
        for i in range(100):
            drawn.append(i)
            yield i

    return items(), drawn


def test_few_items_are_in_flight(client, counted):
    items, drawn = counted
    ahead = [len(drawn) - count for count, _ in enumerate(stream(client, abs, items), start=1)]
    assert len(ahead) == len(drawn) == 100
    assert max(ahead) <= 16  # eight in flight for two workers, eight being handed over


def test_after_a_stop_only_what_is_running_is_awaited(client, counted):
    items, drawn = counted
    found = []
    for item, _ in stream(client, abs, items, Watch(lambda: bool(found))):
        found.append(item)
    assert 1 <= len(set(found)) == len(found) <= len(drawn) <= 24


def test_an_error_on_a_worker_is_raised_here(client):
    with pytest.raises(ValueError, match=r"math domain error|nonnegative"):
        list(stream(client, math.sqrt, [1.0, -1.0]))


def test_an_item_whose_worker_died_gets_one_chance_alone():
    killed = KilledWorker("key", None, 3)
    assert raise_error(7, killed, False) == [7]
    with pytest.raises(KilledWorker):
        raise_error(7, killed, True)


def test_what_failed_is_replaced_and_the_rest_goes_on(client):
    twice = {"retry": lambda item, error, alone: [abs(item) / 2.0] * 2}
    found = list(stream(client, math.sqrt, [4.0, -2.0, 9.0], **twice))
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


def test_a_scheduler_that_dies_is_no_end_of_the_work():
    with (
        standing(SCHEDULER) as (process, address),
        Client(address, timeout=PATIENCE) as client,
    ):
        results = stream(client, time.sleep, [0.01] + [600.0] * 15)
        assert next(results) == (0.01, None)
        process.kill()
        with pytest.raises(UserError, match="the scheduler was lost; run again to resume"):
            list(results)
