"""The index of a store, from journals with lost, repeated, joined and wrong lines."""

import dataclasses

import pytest

from elastomer_friction.workflow.simulate.tasks import SCALARS
from elastomer_friction.workflow.store import journal
from elastomer_friction.workflow.store.index import Index
from elastomer_friction.workflow.store.shard import digest
from elastomer_friction.workflow.store.store import DamagedShard, Store
from elastomer_friction.workflow.system import Maker
from tests.support.shards import BATCH, SAMPLES, WORK, assert_holds, filled, held, records, reopened
from tests.support.small import MAKER, random_result


@pytest.mark.parametrize("lost", [None, 0, 1, 2, 3, 4])
def test_lost_lines_of_the_journal_are_restored_from_the_shards(tmp_path, lost):
    _, results = filled(tmp_path, WORK[:3])
    path = tmp_path / journal.NAME
    lines = path.read_bytes().splitlines(keepends=True)
    assert len(lines) == 5  # the maker, the keys of the one task, then three shards
    path.write_bytes(b"".join(line for i, line in enumerate(lines) if lost not in (None, i)))
    for store in (reopened(tmp_path), Store(tmp_path)):
        for batch, result in zip(WORK[:3], results, strict=True):
            assert_holds(store, batch, result)


def repeated_lines(folder, repeats):
    """Repeat every line of a journal, as joined journals may do."""
    path = folder / journal.NAME
    lines = path.read_bytes().splitlines(keepends=True)
    path.write_bytes(b"".join(line for line in lines for _ in range(repeats)))


PARTS = [dataclasses.replace(BATCH, tasks=tasks) for tasks in (BATCH.tasks[:1], BATCH.tasks[1:])]


@pytest.mark.parametrize("repeats", [2, 3])
def test_repeated_lines_do_not_mix_up_the_numbers_of_problems(tmp_path, repeats):
    filled(tmp_path, PARTS[:1])
    repeated_lines(tmp_path, repeats)
    store = reopened(tmp_path)
    store.add([(PARTS[1], random_result(PARTS[1], 1))])
    for again in (store, Store(tmp_path), reopened(tmp_path)):
        for seed, batch in enumerate(PARTS):
            assert_holds(again, batch, random_result(batch, seed))


def test_two_joined_journals_are_one_store(tmp_path):
    folders = tmp_path / "one", tmp_path / "two"
    for folder, work in zip(folders, ([BATCH, WORK[5]], [WORK[5], BATCH, WORK[2]]), strict=True):
        filled(folder, work)
    joined = b"".join((folder / journal.NAME).read_bytes() for folder in folders)
    for path in folders[1].glob("*.npz"):
        path.replace(folders[0] / path.name)
    (folders[0] / journal.NAME).write_bytes(joined)
    store = reopened(folders[0])
    assert held(store) == {*records(BATCH), *records(WORK[5]), *records(WORK[2])}
    store.read(sorted(held(store)), SAMPLES)


def test_a_wrong_journal_is_mended_from_the_shards(tmp_path, capsys):
    store, results = filled(tmp_path, PARTS)
    entries = [entry for entry, _ in journal.entries(tmp_path)]
    entries.sort(key=lambda entry: "part" not in entry)
    tables = [(entry["chunks"], entry["records"]) for entry in entries if "shard" in entry]
    swapped = iter(tables[::-1])
    for entry in entries:
        if "shard" in entry:
            entry["chunks"], entry["records"] = next(swapped)
    (tmp_path / journal.NAME).write_bytes(journal.encoded(entries))
    store = reopened(tmp_path)
    with pytest.raises(DamagedShard):
        store.read(records(PARTS[1]), SAMPLES)
    assert "all shards are read again" in capsys.readouterr().err
    for again in (store, Store(tmp_path)):
        for batch, result in zip(PARTS, results, strict=True):
            assert_holds(again, batch, result)
    assert len(list(tmp_path.glob("*.npz"))) == 2  # neither is set aside


def test_records_that_a_shard_lacks_are_removed_from_the_index_by_a_read(tmp_path):
    _, (result, _) = filled(tmp_path, PARTS)
    entries = [entry for entry, _ in journal.entries(tmp_path)]
    entries.sort(key=lambda entry: "shard" in entry)
    first, second = (entry for entry in entries if "shard" in entry)
    first["chunks"] += second["chunks"]
    first["records"] += second["records"]
    (tmp_path / journal.NAME).write_bytes(journal.encoded(entries[:-1]))  # without the second
    (tmp_path / f"{second['shard']}.npz").unlink()
    store = Store(tmp_path)
    with pytest.raises(DamagedShard):
        store.read(records(PARTS[1]), SAMPLES)
    for again in (store, Store(tmp_path)):
        assert held(again) == set(records(PARTS[0]))
        assert_holds(again, PARTS[0], result)


def test_a_line_with_more_records_than_its_bytes_can_hold_is_invalid():
    index = Index({"a": 3 * 8 * len(SCALARS)})
    index.replay({"part": digest(32 * b"0"), "keys": 32 * "0"})
    line = {"shard": "a", "records": 3, "chunks": [[digest(32 * b"0"), 0, 3]]}
    with pytest.raises(ValueError, match=f"3 records, not 3, in {3 * 8 * len(SCALARS) - 1} bytes"):
        index.replay(line | {"bytes": 3 * 8 * len(SCALARS) - 1})
    index.replay(line | {"chunks": [*line["chunks"], ["unknown", 0, 1]], "bytes": 1})
    assert index.sizes == {}
    index.replay(line | {"bytes": 3 * 8 * len(SCALARS)})
    assert index.sizes == {"a": 3 * 8 * len(SCALARS)}


def test_a_part_whose_keys_do_not_match_its_checksum_is_ignored(tmp_path):
    filled(tmp_path, [BATCH])
    entries = [entry for entry, _ in journal.entries(tmp_path)]
    keys = entries[1]["keys"]
    entries[1]["keys"] = keys[32:] + keys[:32]  # two tasks exchanged
    (tmp_path / journal.NAME).write_bytes(journal.encoded(entries))
    assert held(Store(tmp_path)) == set()
    assert_holds(reopened(tmp_path), BATCH, random_result(BATCH, 0))


def test_makers_are_those_of_the_requested_blocks(tmp_path):
    other = Maker("python 3, numpy 3", "another processor")
    first, later = (dataclasses.replace(BATCH, first_block=block, blocks=1) for block in (0, 1))
    store = Store(tmp_path)
    store.add([(first, random_result(first))])
    store.add([(later, random_result(later)._replace(maker=other))])
    key, *_, last = (task.key for task in BATCH.tasks)
    for again in (store, Store(tmp_path)):
        makers = again.index.makers_of
        assert (makers({key: 1}), makers({key: 2})) == ({MAKER}, {MAKER, other})
        assert makers({key: 1, last: 2}) == {MAKER, other}  # the maximum over the part
        assert makers({key: 0}) == makers({"0" * 32: 9}) == makers({}) == set()


def test_finding_a_missing_record_raises_key_error(tmp_path):
    store, _ = filled(tmp_path, [BATCH])
    with pytest.raises(KeyError):
        store.index.find((BATCH.tasks[0].key, 99))
    with pytest.raises(KeyError):
        store.index.find(("0" * 32, 0))


@pytest.mark.parametrize("chunk", [("part", 0.0, 1), ("part", 0, 1.0)])
def test_an_entry_with_one_number_that_is_not_an_integer_is_refused(chunk):
    entry = {"shard": "name", "bytes": 100, "records": 1, "chunks": [chunk]}
    with pytest.raises(TypeError, match="not integers"):
        Index().replay(entry)
