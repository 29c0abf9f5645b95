"""The write buffer stores batches together, after a limited time."""

import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.store import write_buffer as module
from elastomer_friction.workflow.store.store import Store
from elastomer_friction.workflow.store.write_buffer import WriteBuffer
from tests.support.shards import WORK, held
from tests.support.small import random_result


def buffer_of(store, clock):
    """Return a buffer for batches of three seconds, with a test clock."""
    return WriteBuffer(store, 3.0, lambda: clock[0])


@pytest.fixture
def store(tmp_path):
    """Return an empty store."""
    return Store(tmp_path)


def put(buffer, *numbers):
    """Put random results into a buffer."""
    for number in numbers:
        buffer.add(WORK[number], random_result(WORK[number], number))


def test_batches_of_two_batch_lengths_share_a_shard(store, clock):
    with buffer_of(store, clock) as buffer:
        put(buffer, 0, 1, 2)
        clock[0] += 5.9
        buffer.flush_when_due()
        assert held(store) == set()
        clock[0] += 0.2
        put(buffer, 3)
        assert len(held(store)) == 4
        put(buffer, 4)
        assert len(held(store)) == 4
        clock[0] += 6.0  # the last batch does not wait for the next
        buffer.flush_when_due()
        assert len(held(store)) == 5
    assert len(store.index.sizes) == 2


def test_a_long_run_writes_a_shard_every_thousandth_of_its_time(store, clock):
    with buffer_of(store, clock) as buffer:
        clock[0] += 30_000.0
        put(buffer, 0)
        clock[0] += 29.0
        put(buffer, 1)
        assert len(held(store)) == 1
        clock[0] += 2.0
        put(buffer, 2)
        assert len(held(store)) == 3


def test_shards_are_of_sixteen_mebibytes_and_of_two_minutes_at_most(store, clock, monkeypatch):
    assert (module.MAX_BUFFER_BYTES, module.MAX_WAIT_SECONDS) == (2**24, 120.0)
    result = random_result(WORK[0])
    size = result.scalars.nbytes + result.curves.nbytes
    monkeypatch.setattr(module, "MAX_BUFFER_BYTES", 3 * size)
    with buffer_of(store, clock) as buffer:
        put(buffer, 0, 1)
        assert held(store) == set()
        put(buffer, 2)  # at the limit itself
        assert len(held(store)) == 3
        clock[0] += 1e6  # a thousandth of it is more than two minutes
        buffer.flush()
        put(buffer, 3)
        clock[0] += 119.9
        buffer.flush_when_due()
        assert len(held(store)) == 3
        clock[0] += 0.2
        buffer.flush_when_due()
        assert len(held(store)) == 4


def test_batches_stay_in_the_buffer_if_the_disk_refuses(store, clock, monkeypatch):
    def refuse(_):
        raise UserError("full")

    with buffer_of(store, clock) as buffer:
        put(buffer, 0, 1)
        with monkeypatch.context() as full:
            full.setattr(store, "add", refuse)
            with pytest.raises(UserError, match="full"):
                buffer.flush()
        assert held(store) == set()
        put(buffer, 2)
    assert len(held(store)) == 3


def ended(store, clock, kind):
    """End a buffer with a waiting batch by an error."""
    with buffer_of(store, clock) as buffer:
        put(buffer, 0)
        raise kind("given up")


def test_a_run_ends_with_its_first_error(store, clock, monkeypatch):
    def refuse(_):
        raise UserError("the last attempt")

    monkeypatch.setattr(store, "add", refuse)
    for kind, message in ((UserError, "given up"), (KeyboardInterrupt, "the last attempt")):
        with pytest.raises(UserError, match=message):
            ended(store, clock, kind)


def test_waiting_batches_are_stored_at_any_end_of_the_run(store, clock):
    with pytest.raises(KeyboardInterrupt):
        ended(store, clock, KeyboardInterrupt)
    assert len(held(store)) == 1
