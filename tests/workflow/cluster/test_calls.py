"""Calls that may never return: waited for while patience lasts, given up after a stop."""

import threading
from operator import truediv

import pytest
from distributed import wait
from distributed.comm import CommClosedError

from elastomer_friction.workflow.cluster import calls
from elastomer_friction.workflow.cluster.calls import Call, Fetches, fetch, patiently
from elastomer_friction.workflow.cluster.watch import NO_ANSWER, Watch
from elastomer_friction.workflow.errors import UserError


@pytest.fixture
def never():
    """Return a function that returns when the test is over."""
    over = threading.Event()
    yield over.wait
    over.set()


@pytest.fixture
def quick(monkeypatch):
    """Let a look come after a hundredth of a second."""
    monkeypatch.setattr(calls, "BEAT_SECONDS", 0.01)


def test_a_call_gives_what_the_function_gives_or_raises():
    assert Call(truediv, 3.0, 2.0).wait(10.0)
    assert patiently(Watch(), NO_ANSWER, truediv, 3.0, 2.0) == 1.5
    with pytest.raises(ZeroDivisionError):
        patiently(Watch(), NO_ANSWER, truediv, 3.0, 0.0)


def test_a_call_that_does_not_return_is_not_waited_for(never):
    call = Call(never)
    assert not call.wait(0.0)
    assert not call.wait(0.01)


def test_patience_with_a_call_ends(never, quick, clock, monkeypatch):
    monkeypatch.setattr(Call, "wait", lambda *_: clock.__setitem__(0, clock[0] + 1.0))
    with pytest.raises(UserError, match="no answer of the scheduler for 21 s: given up"):
        patiently(Watch(patience=20.0), NO_ANSWER, never)


def test_after_a_stop_a_call_is_not_waited_for(never, quick, monkeypatch):
    monkeypatch.setattr(calls, "QUIET_SECONDS", 0.05)
    with pytest.raises(KeyboardInterrupt):
        patiently(Watch(stop=lambda: True), NO_ANSWER, never)


def test_results_and_errors_are_fetched_with_the_workers_they_come_from(client):
    good, bad = client.submit(placed, 4.0), client.submit(truediv, 1.0, 0.0, pure=False)
    wait([good, bad])
    found = fetch(client, [good, bad])
    workers = client.nthreads()
    address, result = found.results[good.key]
    assert (result, address in workers) == (4.0, True)
    address, error = found.errors[bad.key]
    assert isinstance(error, ZeroDivisionError)
    assert address in workers


def placed(value):
    """Return an address and a result, as workers do."""
    from elastomer_friction.workflow.cluster.worker import placed

    return placed(value, float)


def test_a_scheduler_that_dies_during_a_transfer_is_reported(client, monkeypatch):
    def lost(_):
        raise CommClosedError("in <TCP (closed) ConnectionPool.gather>")

    monkeypatch.setattr(client, "gather", lost)
    with pytest.raises(UserError, match="the scheduler was lost; run again to resume"):
        fetch(client, [])


def test_what_does_not_come_is_overdue(never):
    class Future:
        key = "a"

    now = [0.0]

    class Clock:
        @staticmethod
        def monotonic():
            return now[0]

    fetches = Fetches(None, Clock, lambda *_: Call(never))
    fetches.begin([])
    fetches.begin([Future])
    assert fetches.done() == []
    now[0] = 30.0
    assert fetches.overdue(30.0) == []
    now[0] = 31.0
    assert fetches.overdue(30.0) == ["a"]
