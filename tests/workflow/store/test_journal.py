"""The journal: every sound line is read, no other, whatever a crash or a disk did to it."""

import dataclasses

import pytest

from elastomer_friction.workflow.store import journal
from elastomer_friction.workflow.store.store import Store
from tests.support.shards import BATCH, filled

ENTRIES = [{"part": "ab", "keys": "00" * 16}, {"shard": "x\n", "bytes": 17}, {"dropped": "ü"}]


@pytest.fixture
def folder(tmp_path):
    """Return a folder with a journal of three entries."""
    for entry in ENTRIES:
        journal.append(tmp_path, [entry])
    return tmp_path


def read(folder, offset=0):
    """Return the entries of a journal."""
    return [entry for entry, _ in journal.entries(folder, offset)]


def test_no_journal_has_no_entries(tmp_path):
    assert read(tmp_path) == []
    assert list(tmp_path.iterdir()) == []


def test_one_can_go_on_reading_where_one_stopped(folder):
    offsets = [offset for _, offset in journal.entries(folder)]
    assert offsets[-1] == (folder / journal.NAME).stat().st_size
    assert [read(folder, offset) for offset in (0, *offsets)] == [ENTRIES[i:] for i in range(4)]


def test_any_prefix_is_read_up_to_its_last_whole_line(folder):
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
        found = read(folder)
        assert 1 <= len(found) <= 2
        assert all(entry in ENTRIES for entry in found)


def test_entries_after_a_torn_line_are_read(folder):
    path = folder / journal.NAME
    path.write_bytes(path.read_bytes()[:-3])
    journal.append(folder, [{"dropped": "y"}])
    assert read(folder) == [*ENTRIES[:2], {"dropped": "y"}]


def test_the_keys_of_tasks_that_stay_together_are_written_once(tmp_path):
    later = [dataclasses.replace(BATCH, first_block=4 * i) for i in range(5)]
    filled(tmp_path, later)
    for kind, count in (("part", 1), ("shard", 5)):
        assert sum(kind in entry for entry in read(tmp_path)) == count


def test_the_journal_tells_records_and_core_time(tmp_path):
    filled(tmp_path, [BATCH])
    (shard,) = [entry for entry in read(tmp_path) if "shard" in entry]
    assert shard["records"] == 16
    assert shard["used"] == 0.1  # of random_result
    assert shard["predicted"] == round(BATCH.seconds, 3)


def test_the_journal_tells_with_what_a_run_computes(tmp_path):
    Store(tmp_path).begin("a study", "numpy 2.4", "a processor")
    (run,) = read(tmp_path)
    assert run.items() >= {"run": "a study", "versions": "numpy 2.4"}.items()
    assert run["processor"] == "a processor"


def test_a_new_journal_begins_with_its_format_and_tells_it_once(tmp_path):
    for _ in range(2):
        Store(tmp_path).prepare()
    assert read(tmp_path) == [{"format": journal.FORMAT}]
