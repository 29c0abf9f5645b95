"""The store: what goes in comes out bit for bit, and a disk that refuses is reported."""

import dataclasses
import errno
import os

import numpy as np
import pytest

from tests.workflow.shards import BATCH, SAMPLES, WORK, assert_holds, filled, records, shard_of
from tests.workflow.small import random_result
from workflow.errors import UserError
from workflow.store import Store, write_durably


def test_result_comes_back_bit_for_bit(tmp_path):
    store, (result,) = filled(tmp_path, [BATCH])
    assert store.records() == set(records(BATCH))
    assert_holds(store, BATCH, result)


def test_result_survives_reopening(tmp_path):
    _, results = filled(tmp_path, [BATCH, WORK[20]])
    again = Store(tmp_path)
    assert again.records() == set(records(BATCH)) | set(records(WORK[20]))
    assert_holds(again, BATCH, results[0])
    assert_holds(again, WORK[20], results[1])


def test_blocks_keep_their_numbers(tmp_path):
    later = dataclasses.replace(BATCH, first_block=7)
    filled(tmp_path, [later])
    assert {block for _, block in Store(tmp_path).records()} == {7, 8, 9, 10}


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


def test_new_store_is_empty_and_makes_its_folder(tmp_path):
    assert Store(tmp_path / "a" / "store").records() == set()
    assert (tmp_path / "a" / "store").is_dir()


def test_nothing_but_shards_is_left_in_the_folder(tmp_path):
    filled(tmp_path, WORK[:3])
    assert sorted(path.suffix for path in tmp_path.iterdir()) == [".nc"] * 3


def test_same_result_gives_the_same_file(tmp_path):
    one, _ = filled(tmp_path / "one", [BATCH])
    two, _ = filled(tmp_path / "two", [BATCH])
    assert shard_of(one, BATCH).read_bytes() == shard_of(two, BATCH).read_bytes()


def full_disk(*_):
    """Fail like a full disk."""
    raise OSError(errno.ENOSPC, "No space left on device")


def test_full_disk_is_reported_and_leaves_no_file(tmp_path, monkeypatch):
    store = Store(tmp_path)
    monkeypatch.setattr(os, "fsync", full_disk)
    with pytest.raises(UserError, match=r"cannot be written: No space left on device$"):
        store.add(BATCH, random_result(BATCH))
    assert list(tmp_path.iterdir()) == []
    assert store.records() == set()


def test_failure_leaves_the_old_file_as_it_was(tmp_path, monkeypatch):
    path = tmp_path / "shard.nc"
    write_durably(path, b"old")
    monkeypatch.setattr("pathlib.Path.replace", full_disk)
    with pytest.raises(UserError, match=r"shard\.nc: cannot be written"):
        write_durably(path, b"new")
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


def test_file_is_flushed_before_it_gets_its_name(tmp_path, monkeypatch):
    path = tmp_path / "shard.nc"
    seen = []
    monkeypatch.setattr(os, "fsync", lambda _: seen.append(path.exists()))
    write_durably(path, b"content")
    assert seen == [False, True]  # the file, then its folder


def test_folder_that_cannot_be_made_is_reported(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(UserError, match=r"cannot be used for results: Not a directory$"):
        Store(tmp_path / "file" / "store")


def test_folder_that_vanished_is_reported(tmp_path):
    store = Store(tmp_path / "store")
    (tmp_path / "store").rmdir()
    with pytest.raises(UserError, match="cannot be written: No such file or directory"):
        store.add(BATCH, random_result(BATCH))
