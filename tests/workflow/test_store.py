"""The store: what goes in comes out bit for bit, and a disk that refuses is reported."""

import dataclasses
import errno
import os

import numpy as np
import pytest

from tests.workflow.shards import (
    BATCH,
    ELSEWHERE,
    SAMPLES,
    WORK,
    assert_holds,
    filled,
    held,
    records,
    reopened,
    shard_of,
)
from tests.workflow.small import random_result
from workflow.errors import UserError
from workflow.store import journal
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


def test_one_shard_holds_many_batches(tmp_path):
    store = Store(tmp_path)
    work = [(batch, random_result(batch, seed)) for seed, batch in enumerate(WORK[:9])]
    store.add(work)
    assert len(list(tmp_path.glob("*.nc"))) == 1
    for again in (store, Store(tmp_path)):
        for batch, result in work:
            assert_holds(again, batch, result)


def test_batches_of_different_length_share_a_shard(tmp_path):
    longer = dataclasses.replace(WORK[1], curve_samples=40)
    work = [(batch, random_result(batch)) for batch in (WORK[0], longer)]
    store = Store(tmp_path)
    store.add(work)
    assert_holds(store, *work[0])
    _, curves = store.read(records(longer), 39)
    assert curves.tobytes() == work[1][1].curves.tobytes()


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


def test_same_result_gives_the_same_file(tmp_path):
    one, _ = filled(tmp_path / "one", [BATCH])
    two, _ = filled(tmp_path / "two", [BATCH])
    assert shard_of(one, BATCH).read_bytes() == shard_of(two, BATCH).read_bytes()


def test_opening_reads_the_journal_and_no_shard(tmp_path, monkeypatch):
    filled(tmp_path, WORK[:5])
    monkeypatch.setattr(Store, "_load", None)
    assert len(held(reopened(tmp_path))) == 5


def test_the_keys_of_tasks_that_stay_together_are_written_once(tmp_path):
    later = [dataclasses.replace(BATCH, first_block=4 * i) for i in range(5)]
    filled(tmp_path, later)
    entries = [entry for entry, _ in journal.entries(tmp_path)]
    assert sum("part" in entry for entry in entries) == 1
    assert sum("shard" in entry for entry in entries) == 5


def test_the_journal_tells_records_and_core_time(tmp_path):
    filled(tmp_path, [BATCH])
    (shard,) = [entry for entry, _ in journal.entries(tmp_path) if "shard" in entry]
    assert shard["records"] == 16
    assert shard["used"] == 0.1  # of random_result
    assert shard["predicted"] == round(BATCH.seconds, 3)


def test_the_journal_tells_with_what_a_run_computes(tmp_path):
    Store(tmp_path).begin("a study", "numpy 2.4", "a processor")
    (run,) = [entry for entry, _ in journal.entries(tmp_path)]
    assert (run["run"], run["versions"], run["processor"]) == (
        "a study",
        "numpy 2.4",
        "a processor",
    )


def full_disk(*_):
    """Fail like a full disk."""
    raise OSError(errno.ENOSPC, "No space left on device")


def test_full_disk_is_reported_and_leaves_no_file(tmp_path, monkeypatch):
    store = Store(tmp_path)
    monkeypatch.setattr(os, "fsync", full_disk)
    with pytest.raises(UserError, match=r"cannot be written: No space left on device$"):
        store.add([(BATCH, random_result(BATCH))])
    assert list(tmp_path.iterdir()) == []
    assert held(store) == set()


def test_folder_that_vanished_is_reported(tmp_path):
    store = Store(tmp_path / "store")
    with pytest.raises(UserError, match="cannot be written: No such file or directory"):
        store.add([(BATCH, random_result(BATCH))])
