"""Finished batches wait for company, but not for long."""

import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.store import shelf as module
from elastomer_friction.workflow.store.shelf import Shelf
from elastomer_friction.workflow.store.store import Store
from tests.support.shards import WORK, held
from tests.support.small import random_result


def shelf_of(store, clock):
    """Return a shelf for batches of three seconds that goes by the clock."""
    return Shelf(store, 3.0, lambda: clock[0])


@pytest.fixture
def store(tmp_path):
    """Return an empty store."""
    return Store(tmp_path)


def put(shelf, *numbers):
    """Put random results on a shelf."""
    for number in numbers:
        shelf.add(WORK[number], random_result(WORK[number], number))


def test_batches_of_two_batch_lengths_share_a_shard(store, clock):
    with shelf_of(store, clock) as shelf:
        put(shelf, 0, 1, 2)
        clock[0] += 5.9
        shelf.flush_when_due()
        assert held(store) == set()
        clock[0] += 0.2
        put(shelf, 3)
        assert len(held(store)) == 4
        put(shelf, 4)
        assert len(held(store)) == 4
    assert len(held(store)) == 5
    assert len(store.index.sizes) == 2


def test_the_last_batch_does_not_wait_for_the_next(store, clock):
    with shelf_of(store, clock) as shelf:
        put(shelf, 0)
        clock[0] += 6.0
        shelf.flush_when_due()
        assert len(held(store)) == 1


def test_a_long_run_writes_a_shard_every_thousandth_of_its_time(store, clock):
    with shelf_of(store, clock) as shelf:
        clock[0] += 30_000.0
        put(shelf, 0)
        clock[0] += 29.0
        put(shelf, 1)
        assert len(held(store)) == 1
        clock[0] += 2.0
        put(shelf, 2)
        assert len(held(store)) == 3


def test_much_is_stored_at_once(store, clock, monkeypatch):
    monkeypatch.setattr(module, "MOST_BYTES", 1000)
    with shelf_of(store, clock) as shelf:
        put(shelf, *range(10))
        assert len(held(store)) >= 6


def test_shards_are_of_sixteen_mebibytes_and_of_two_minutes_at_most(store, clock, monkeypatch):
    assert (module.MOST_BYTES, module.LONGEST_SECONDS) == (2**24, 120.0)
    each = random_result(WORK[0]).scalars.nbytes + random_result(WORK[0]).curves.nbytes
    monkeypatch.setattr(module, "MOST_BYTES", 3 * each)
    with shelf_of(store, clock) as shelf:
        put(shelf, 0, 1)
        assert held(store) == set()
        put(shelf, 2)  # at the bound itself, not only beyond it
        assert len(held(store)) == 3
        clock[0] += 1e6  # a thousandth of it is more than two minutes
        shelf.flush()
        put(shelf, 3)
        clock[0] += 119.9
        shelf.flush_when_due()
        assert len(held(store)) == 3
        clock[0] += 0.2
        shelf.flush_when_due()
        assert len(held(store)) == 4


def test_what_the_disk_refuses_waits_on(store, clock, monkeypatch):
    def refuse(_):
        raise UserError("full")

    with shelf_of(store, clock) as shelf:
        put(shelf, 0, 1)
        with monkeypatch.context() as full:
            full.setattr(store, "add", refuse)
            with pytest.raises(UserError, match="full"):
                shelf.flush()
        assert held(store) == set()
        put(shelf, 2)
    assert len(held(store)) == 3


def test_the_error_that_ends_a_run_is_the_first_one(store, clock, monkeypatch):
    def refuse(_):
        raise UserError("the last attempt")

    def ended(kind):
        with shelf_of(store, clock) as shelf:
            put(shelf, 0)
            raise kind("given up")

    monkeypatch.setattr(store, "add", refuse)
    with pytest.raises(UserError, match="given up"):
        ended(UserError)
    with pytest.raises(UserError, match="the last attempt"):
        ended(KeyboardInterrupt)


def test_what_waits_is_stored_whatever_ends_the_run(store, clock):
    def aborted():
        with shelf_of(store, clock) as shelf:
            put(shelf, 0, 1)
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        aborted()
    assert len(held(store)) == 2
