"""Streaming: each item once, a bounded number in flight, and no silent end."""

import errno
import math
import time
from collections import Counter

import pytest
from distributed import Client, get_worker

from elastomer_friction.workflow.cluster.pool import Pool
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.run.node import Node
from elastomer_friction.workflow.system.watch import Watch
from tests.support.python import PATIENCE, standing
from tests.support.simulated import stream, streamed


def pool(client, function):
    """Return a pool whose marches are a function."""
    return Pool(client, {"march": function})


@pytest.mark.parametrize("items", [range(100), [4, 4, 4], []], ids=["many", "equal", "none"])
def test_each_item_comes_back_once_with_its_result(client, items):
    actual = streamed(pool(client, math.sqrt), items)
    assert sorted(actual) == [(i, math.sqrt(i)) for i in items]


@pytest.fixture
def counted():
    """Return a hundred items, and a list of those that were drawn."""
    drawn = []

    def items():
        for i in range(100):
            drawn.append(i)
            yield i

    return items(), drawn


def nap(item):
    """Take a while."""
    time.sleep(0.05)
    return item


def test_no_more_are_in_flight_than_are_done_in_a_second(client, counted):
    items, drawn = counted
    nodes = (Node("march", item) for item in items)
    ahead = [len(drawn) - n for n, _ in enumerate(stream(pool(client, nap), nodes), start=1)]
    assert len(ahead) == len(drawn) == 100
    assert max(ahead) <= 60  # 40 in flight for two workers, some being handed over


def test_after_a_stop_only_what_is_running_is_awaited(client, counted):
    items, drawn = counted
    actual = []
    nodes = (Node("march", item) for item in items)
    for node, _ in stream(pool(client, abs), nodes, Watch(lambda: bool(actual))):
        actual.append(node.item)
    assert 1 <= len(set(actual)) == len(actual) <= len(drawn) <= 24


def test_an_error_on_a_worker_is_raised_here(client):
    with pytest.raises(ValueError, match=r"math domain error|nonnegative"):
        streamed(pool(client, math.sqrt), [1.0, -1.0])


def test_what_failed_is_replaced_and_the_rest_goes_on(client):
    twice = {"retry": lambda item, error, alone: [abs(item) / 2.0] * 2}
    actual = streamed(pool(client, math.sqrt), [4.0, -2.0, 9.0], **twice)
    assert sorted(actual) == [(1.0, 1.0), (1.0, 1.0), (4.0, 2.0), (9.0, 3.0)]


def sick(item):
    """Fail on a worker, as on a node with a broken disk; work on the other once it is known."""
    worker = get_worker()
    if worker.address == min(item):
        FAILED.append(item)
        raise OSError(errno.EIO, "Input/output error")
    while len(FAILED) < 3:
        time.sleep(0.005)
    return worker.address


def test_one_sick_worker_fails_nothing_and_is_left_out_and_named(client, capsys):
    workers = tuple(client.nthreads())
    FAILED.clear()
    done = [result for _, result in streamed(pool(client, sick), [workers] * 40)]
    assert done == [max(workers)] * 40
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith(f"worker {min(workers)}: 3 consecutive batches failed there")


def test_while_the_sound_worker_is_busy_dask_hands_nothing_back_to_the_sick_one(client):
    """Until dask has twice looked for what to steal, which it does every second."""
    workers = tuple(client.nthreads())
    FAILED.clear()
    DONE.clear()
    items = [(*workers, number) for number in range(8)]
    assert len(streamed(pool(client, sick_beside_a_busy_one), items)) == 8
    assert {*Counter(FAILED).values()} == {1}


FAILED = []  # items, as they fail on the sick worker: one of the threads of this process


def sick_beside_a_busy_one(item):
    """Fail on a worker; take long on the other with what comes first."""
    *workers, number = item
    if get_worker().address == min(workers):
        FAILED.append(number)
        raise OSError(errno.EIO, "Input/output error")
    if not DONE:
        time.sleep(2.5)
    DONE.append(number)
    return number


DONE = []


def test_what_fails_everywhere_is_tried_on_two_workers_before_it_is_given_up(client):
    tried = []

    def note(item, error, alone):
        tried.append((item, alone))
        assert isinstance(error, ArithmeticError)
        return []

    assert streamed(pool(client, nowhere), [7], retry=note) == []
    assert tried == [(7, False)]
    assert set(PLACES) == set(client.nthreads())


PLACES = []  # the workers of these tests are threads of this process


def nowhere(_):
    """Fail."""
    PLACES.append(get_worker().address)
    raise ArithmeticError("no root")


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
        nodes = [Node("march", seconds) for seconds in [0.01] + [600.0] * 15]
        results = stream(pool(client, time.sleep), nodes)
        assert next(results) == (nodes[0], None)
        process.kill()
        with pytest.raises(UserError, match="the scheduler was lost; run again to resume"):
            list(results)
