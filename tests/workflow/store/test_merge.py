"""Two stores joined: what the other one holds is there, and the other one is as it was."""

import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.store import journal
from elastomer_friction.workflow.store.merge import merge_into
from elastomer_friction.workflow.store.store import Store
from elastomer_friction.workflow.store.verify import Verified
from elastomer_friction.workflow.system.lock import hold
from tests.support.shards import (
    BATCH,
    SAMPLES,
    WORK,
    assert_holds,
    filled,
    held,
    records,
    reopened,
    shard_of,
)
from tests.support.small import random_result


@pytest.fixture
def folders(tmp_path):
    """Return two stores that have one batch in common, to the bit."""
    source, target = tmp_path / "source", tmp_path / "target"
    filled(source, WORK[:3])
    filled(target, WORK[:1])
    reopened(target).add([(WORK[4], random_result(WORK[4], 4))])
    return source, target


def contents(folder):
    """Return the files of a folder."""
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_all_that_either_holds_is_there_and_the_source_as_it_was(folders):
    source, target = folders
    before = contents(source)
    said = merge_into(source, target)
    assert said == ["taken over  2 of 3 shards, 2 records that are new"]
    assert contents(source) == before
    store = Store(target)
    assert held(store) == {r for batch in (*WORK[:3], WORK[4]) for r in records(batch)}
    for seed in (0, 1, 2, 4):
        assert_holds(store, WORK[seed], random_result(WORK[seed], seed))
    assert Verified(target).faults == []
    again = contents(target)
    assert merge_into(source, target) == ["taken over  0 of 3 shards, 0 records that are new"]
    assert contents(target).keys() == again.keys()


def test_into_a_folder_that_is_not_there_yet(folders, tmp_path):
    merge_into(folders[0], tmp_path / "new" / "store")
    assert held(Store(tmp_path / "new" / "store")) == held(Store(folders[0]))


def test_records_that_differ_are_counted(folders):
    source, target = folders
    Store(source).add([(WORK[4], random_result(WORK[4], 99))])
    said = merge_into(source, target)
    assert said[0] == "differing   1 records are in both, but not to the bit"
    assert_holds(Store(target), WORK[4], random_result(WORK[4], 4))  # as it was


def test_a_damaged_shard_is_left_out_and_left_as_it_is(folders):
    source, target = folders
    path = shard_of(Store(source), WORK[1])
    path.write_bytes(path.read_bytes()[:-50])
    before = contents(source)
    said = merge_into(source, target)
    assert said[0].startswith(f"left out    {path.name}: its content does not match")
    assert contents(source) == before
    assert not set(records(WORK[1])) & held(Store(target))


def test_the_makers_of_both_are_known_after(folders):
    source, target = folders
    merge_into(source, target)
    blocks = {batch.tasks[0].key: 99 for batch in WORK[:5]}
    assert len(Store(target).index.makers_of(blocks)) == 1


def test_a_store_in_use_another_version_and_itself_are_refused(folders, monkeypatch):
    monkeypatch.setattr("elastomer_friction.workflow.system.lock.GLANCE_SECONDS", 0.1)
    source, target = folders
    with hold(target), pytest.raises(UserError, match="in use by"):
        merge_into(source, target)
    with pytest.raises(UserError, match="cannot be joined with itself"):
        merge_into(source, source)
    journal.append(source, [{"format": "elastomer-friction journal 99"}])
    with pytest.raises(UserError, match="another version of the format"):
        merge_into(source, target)


def test_large_batches_are_taken_over_whole(tmp_path):
    filled(tmp_path / "source", [BATCH])
    merge_into(tmp_path / "source", tmp_path / "target")
    store = Store(tmp_path / "target")
    assert_holds(store, BATCH, random_result(BATCH, 0))
    scalars, _ = store.read(records(BATCH)[::-1], SAMPLES)
    assert len(scalars) == 16
