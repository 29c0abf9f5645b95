"""The store: what goes in comes out bit for bit, and a disk that refuses is reported."""

import dataclasses

import numpy as np
import pytest

from tests.support.shards import (
    BATCH,
    ELSEWHERE,
    SAMPLES,
    WORK,
    assert_holds,
    filled,
    held,
    records,
    reopened,
)
from tests.support.small import random_result
from workflow.errors import UserError
from workflow.store.store import Store


def test_result_comes_back_bit_for_bit(tmp_path):
    store, (result,) = filled(tmp_path, [BATCH])
    assert held(store) == set(records(BATCH))
    assert_holds(store, BATCH, result)


def test_result_survives_reopening(tmp_path):
    _, results = filled(tmp_path, [BATCH, ELSEWHERE])
    for again in (Store(tmp_path), reopened(tmp_path)):
        assert held(again) == set(records(BATCH)) | set(records(ELSEWHERE))
        assert_holds(again, BATCH, results[0])
        assert_holds(again, ELSEWHERE, results[1])


def test_blocks_keep_their_numbers(tmp_path):
    later = dataclasses.replace(BATCH, first_block=7)
    store, _ = filled(tmp_path, [later])
    assert {block for _, block in held(store)} == {7, 8, 9, 10}
    assert (BATCH.tasks[0].key, 6) not in store
    assert (BATCH.tasks[0].key, 7) in store
    assert ("0" * 32, 7) not in store


def test_tasks_may_come_in_other_company(tmp_path):
    alone = dataclasses.replace(BATCH, tasks=BATCH.tasks[1:2], first_block=4, blocks=2)
    _, results = filled(tmp_path, [BATCH, alone])
    key = BATCH.tasks[1].key
    _, curves = Store(tmp_path).read([(key, block) for block in range(6)], SAMPLES)
    assert np.array_equal(curves[:4], results[0].curves[1], equal_nan=True)
    assert np.array_equal(curves[4:], results[1].curves[0], equal_nan=True)


def test_records_are_read_in_the_order_asked_for(tmp_path):
    store, (result,) = filled(tmp_path, [BATCH])
    scalars, _ = store.read(records(BATCH)[::-1], SAMPLES)
    assert np.array_equal(scalars[::-1].ravel(), result.scalars.ravel())


def test_records_of_many_shards_are_read_together(tmp_path):
    store, results = filled(tmp_path, WORK[:6])
    wanted = [records(batch)[0] for batch in WORK[:6]]
    _, curves = store.read(wanted, SAMPLES)
    for row, result in zip(curves, results, strict=True):
        assert row.tobytes() == result.curves.tobytes()


def test_a_store_that_is_not_there_is_empty_and_not_made(tmp_path):
    assert held(Store(tmp_path / "store")) == set()
    assert list(tmp_path.iterdir()) == []


def test_nothing_but_shards_and_the_journal_is_left_in_the_folder(tmp_path):
    filled(tmp_path, WORK[:3])
    names = sorted(path.suffix or path.name for path in tmp_path.iterdir())
    assert names == [".nc"] * 3 + ["journal"]


def test_opening_reads_the_journal_and_no_shard(tmp_path, monkeypatch):
    filled(tmp_path, WORK[:5])
    monkeypatch.setattr(Store, "_load", None)
    assert len(held(reopened(tmp_path))) == 5


def test_folder_that_vanished_is_reported(tmp_path):
    store = Store(tmp_path / "store")
    with pytest.raises(UserError, match="cannot be written: No such file or directory"):
        store.add([(BATCH, random_result(BATCH))])
