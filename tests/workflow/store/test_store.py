"""The store, its shards and its journal: records come back bit for bit."""

import dataclasses
import io
import time

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.simulate.tasks import SCALARS
from elastomer_friction.workflow.store import journal
from elastomer_friction.workflow.store.shard import SHARD_ARRAYS, encode
from elastomer_friction.workflow.store.store import (
    Store,
    enter_result,
    is_as_written,
    store_folder,
)
from tests.support.shards import BATCH, SAMPLES, WORK, assert_holds, filled, held, records, reopened
from tests.support.small import random_result


def test_results_come_back_bit_for_bit_in_any_order(tmp_path):
    alone = dataclasses.replace(BATCH, tasks=BATCH.tasks[1:2], first_block=4, blocks=2)
    elsewhere = [batch for batch in WORK if not set(records(batch)) & set(records(BATCH))]
    work = [BATCH, alone, *elsewhere[:6]]
    store, results = filled(tmp_path, work)
    stored = [record for batch in work for record in records(batch)]
    scalars = np.concatenate([result.scalars.reshape(-1, len(SCALARS)) for result in results])
    curves = np.concatenate([result.curves.reshape(-1, SAMPLES) for result in results])
    order = np.random.default_rng(1).permutation(len(stored))
    for again in (store, Store(tmp_path), reopened(tmp_path)):
        assert held(again) == set(stored)
        read_back = again.read([stored[i] for i in order], SAMPLES)
        assert read_back[0].tobytes() == scalars[order].tobytes()
        assert read_back[1].tobytes() == curves[order].tobytes()


def test_blocks_keep_their_numbers(tmp_path):
    store, _ = filled(tmp_path, [dataclasses.replace(BATCH, first_block=7)])
    key = BATCH.tasks[0].key
    assert {block for _, block in held(store)} == {7, 8, 9, 10}
    assert [record in store for record in ((key, 6), (key, 7), ("0" * 32, 7))] == [0, 1, 0]


def test_a_missing_store_is_empty_and_is_not_created(tmp_path):
    assert held(Store(tmp_path / "store")) == set()
    assert read(tmp_path) == []
    assert list(tmp_path.iterdir()) == []


def test_the_folder_holds_only_shards_and_the_journal(tmp_path):
    filled(tmp_path, WORK[:3])
    names = sorted(path.suffix or path.name for path in tmp_path.iterdir())
    assert names == [".npz"] * 3 + ["journal"]


def test_opening_reads_the_journal_and_no_shard(tmp_path, monkeypatch):
    filled(tmp_path, WORK[:5])
    monkeypatch.setattr(Store, "_load", None)
    assert len(held(reopened(tmp_path))) == 5


def test_folder_that_vanished_is_reported(tmp_path):
    store = Store(tmp_path / "store")
    with pytest.raises(UserError, match="cannot be written: No such file or directory"):
        store.add([(BATCH, random_result(BATCH))])


def test_one_shard_holds_many_batches(tmp_path):
    store = Store(tmp_path)
    work = [(batch, random_result(batch, seed)) for seed, batch in enumerate(WORK[:9])]
    store.add(work)
    assert len(list(tmp_path.glob("*.npz"))) == 1
    for again in (store, Store(tmp_path)):
        for batch, result in work:
            assert_holds(again, batch, result)


def test_batches_of_different_length_share_a_shard(tmp_path):
    longer = dataclasses.replace(WORK[1], recording=WORK[1].recording._replace(samples=40))
    work = [(batch, random_result(batch)) for batch in (WORK[0], longer)]
    store = Store(tmp_path)
    store.add(work)
    assert_holds(store, *work[0])
    _, curves = store.read(records(longer), 39)
    assert curves.tobytes() == work[1][1].curves.tobytes()


def test_equal_records_give_equal_bytes(tmp_path, monkeypatch):
    work = [(batch, random_result(batch, seed)) for seed, batch in enumerate(WORK[:2])]
    content = encode(work)
    monkeypatch.setattr(time, "localtime", None)
    assert encode(work) == content
    with np.load(io.BytesIO(content), allow_pickle=False) as arrays:
        assert arrays.files == list(SHARD_ARRAYS)


def test_failures_are_kept_until_they_are_to_be_retried(tmp_path):
    store = Store(tmp_path)
    for key in ("aa", "bb"):
        store.record_failure(key, f"{key} overflowed")
    reasons = {"aa": "aa overflowed", "bb": "bb overflowed"}
    assert store.failed == Store(tmp_path).failed == reasons
    before = (tmp_path / journal.NAME).read_bytes()
    store.forget_failures({"cc"})
    assert (tmp_path / journal.NAME).read_bytes() == before
    store.forget_failures({"bb", "cc"})
    assert store.failed == Store(tmp_path).failed == {"aa": "aa overflowed"}


def test_an_edited_result_is_recognised_by_the_store_beside_it(tmp_path):
    result = tmp_path / "fig2.nc"
    result.write_bytes(b"as a run wrote it")
    assert is_as_written(result) is None  # without a store
    folder = store_folder(result)
    enter_result(result)
    assert Store(folder).wrote(result)
    assert is_as_written(result) is True
    result.write_bytes(b"as a run wrote it, and more")
    assert not Store(folder).wrote(result)
    assert is_as_written(result) is False
    enter_result(result)  # by a later run
    assert is_as_written(result) is True


SHARD = {"shard": "x\n", "bytes": 17, "records": 0, "chunks": []}
ENTRIES = [{"part": "ab", "keys": "00" * 16}, SHARD, {"dropped": "ü"}]


@pytest.fixture
def folder(tmp_path):
    """Return a folder with a journal of three entries."""
    for entry in ENTRIES:
        journal.append(tmp_path, [entry])
    return tmp_path


def read(folder, offset=0):
    """Return the entries of a journal."""
    return [entry for entry, _ in journal.entries(folder, offset)]


def test_reading_continues_at_any_offset(folder):
    offsets = [offset for _, offset in journal.entries(folder)]
    assert offsets[-1] == (folder / journal.NAME).stat().st_size
    assert [read(folder, offset) for offset in (0, *offsets)] == [ENTRIES[i:] for i in range(4)]


def test_any_prefix_is_read_up_to_its_last_complete_line(folder):
    content = (folder / journal.NAME).read_bytes()
    for length in range(len(content)):
        (folder / journal.NAME).write_bytes(content[:length])
        assert read(folder) == ENTRIES[: content[:length].count(b"\n")]


def test_any_flipped_bit_spoils_at_most_the_lines_it_touches(folder):
    content = (folder / journal.NAME).read_bytes()
    for place in range(len(content)):
        damaged = bytearray(content)
        damaged[place] ^= 1
        (folder / journal.NAME).write_bytes(damaged)
        entries = read(folder)
        assert 1 <= len(entries) <= 2
        assert all(entry in ENTRIES for entry in entries)


def test_entries_after_a_torn_line_are_read(folder):
    path = folder / journal.NAME
    path.write_bytes(path.read_bytes()[:-3])
    journal.append(folder, [{"dropped": "y"}])
    assert read(folder) == [*ENTRIES[:2], {"dropped": "y"}]


def test_the_keys_of_a_part_are_written_once(tmp_path):
    later = [dataclasses.replace(BATCH, first_block=4 * i) for i in range(5)]
    filled(tmp_path, later)
    for kind, count in (("part", 1), ("shard", 5)):
        assert sum(kind in entry for entry in read(tmp_path)) == count


def test_the_journal_lists_records_and_predicted_time(tmp_path):
    filled(tmp_path, [BATCH])
    (shard,) = [entry for entry in read(tmp_path) if "shard" in entry]
    assert shard["records"] == 16
    assert shard["predicted"] == round(BATCH.seconds, 3)


def test_a_new_journal_begins_with_its_format(tmp_path):
    for _ in range(2):
        Store(tmp_path).prepare()
    assert read(tmp_path) == [{"format": journal.JOURNAL_FORMAT}]
