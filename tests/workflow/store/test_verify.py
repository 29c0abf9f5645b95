"""Verifying and merging stores: faults are named, and nothing else changes."""

import errno
import fcntl

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.store import journal
from elastomer_friction.workflow.store.merge import merge_into
from elastomer_friction.workflow.store.shard import digest
from elastomer_friction.workflow.store.store import Store, enter_result
from elastomer_friction.workflow.store.verify import Verification
from elastomer_friction.workflow.system.lock import hold
from tests.support.faults import DAMAGE
from tests.support.shards import (
    BATCH,
    WORK,
    assert_holds,
    contents,
    filled,
    held,
    records,
    reopened,
    shard_of,
)
from tests.support.small import MAKER, random_result


@pytest.fixture
def store(tmp_path):
    """Return a store of three shards, begun as a run begins it."""
    store = reopened(tmp_path)
    for seed, batch in enumerate([BATCH, *WORK[4:6]]):
        store.add([(batch, random_result(batch, seed))])
    return store


def verified(folder):
    """Return the verification of a store, which must not change it."""
    before = contents(folder)
    verification = Verification(folder)
    assert contents(folder) == before
    return verification


def test_a_sound_store_has_no_fault(store):
    verification = verified(store.folder)
    assert verification.faults == verification.notes == []
    assert verification.lines()[1:6] == [
        "journal     7 lines",
        "shards      3 of 3 sound",
        f"records     18 of {len({key for key, _ in held(store)})} problems",
        f"computed    with {MAKER.versions}, on {MAKER.processor}",
        "failed      0 problems",
    ]
    assert verification.lines()[-1] == "verified    no faults"


@pytest.mark.parametrize("name", [name for name in DAMAGE if name != "of another program"])
def test_a_damaged_shard_is_named(store, name):
    path = shard_of(store, WORK[4])
    path.write_bytes(DAMAGE[name](path.read_bytes()))
    verification = verified(store.folder)
    assert verification.undamaged == 2
    (fault,) = verification.faults
    assert fault.startswith(f"{path.name}: damaged (")


def test_a_file_of_another_program_is_noted(store):
    path = shard_of(store, WORK[4])
    content = DAMAGE["of another program"](b"")
    path.with_name(f"{digest(content)}.npz").write_bytes(content)
    verification = verified(store.folder)
    assert (verification.undamaged, verification.shards, verification.faults) == (3, 4, [])
    (note,) = verification.notes
    assert note.startswith(f"{digest(content)}.npz: is not a shard of this program")


def test_a_missing_shard_and_a_foreign_file_are_named(store):
    path = shard_of(store, BATCH)
    path.replace(path.with_suffix(".damaged"))
    verification = verified(store.folder)
    assert verification.faults == [f"{path.name}: missing, but listed in the journal"]
    assert verification.notes == [f"{path.stem}.damaged: not part of the store"]


@pytest.mark.parametrize("line", range(7))
def test_a_spoilt_line_is_named_by_its_number(store, line):
    path = store.folder / journal.NAME
    lines = path.read_bytes().splitlines(keepends=True)
    lines[line] = lines[line][:20] + b"?" + lines[line][21:]
    path.write_bytes(b"".join(lines))
    faults = verified(store.folder).faults
    assert f"{journal.NAME}, line {line + 1}: spoilt" in faults
    assert not any("invalid" in fault for fault in faults)


def test_an_edited_result_is_a_fault(tmp_path):
    result = tmp_path / "fig2.nc"
    result.write_bytes(b"as a run wrote it")
    enter_result(result)
    assert verified(tmp_path / "store").faults == []
    result.write_bytes(b"by hand")
    assert verified(tmp_path / "store").faults == [
        f"{result}: was changed or replaced since a run wrote it"
    ]


def test_every_key_is_compared_with_the_journal(store):
    entries = [entry for entry, _ in journal.entries(store.folder)]
    shards = [entry for entry in entries if "shard" in entry]
    shards[1]["chunks"], shards[2]["chunks"] = shards[2]["chunks"], shards[1]["chunks"]
    (store.folder / journal.NAME).write_bytes(journal.encoded(entries))
    verification = verified(store.folder)
    assert len(verification.faults) == 2
    key, block = records(WORK[5])[0]
    assert any(
        f"does not hold block {block} of {key} where" in fault for fault in verification.faults
    )


def test_a_maker_that_is_missing_in_the_shard_is_a_fault(store):
    entries = [entry for entry, _ in journal.entries(store.folder)]
    maker = next(entry for entry in entries if "maker" in entry)
    maker["versions"] = "numpy 1"
    (store.folder / journal.NAME).write_bytes(journal.encoded(entries))
    faults = verified(store.folder).faults
    assert len(faults) == 3
    assert all("was computed by other makers" in fault for fault in faults)


def test_shards_that_are_not_in_the_journal_are_noted(tmp_path):
    filled(tmp_path, WORK[:2])
    (tmp_path / journal.NAME).unlink()
    verification = verified(tmp_path)
    assert verification.faults == []
    assert len(verification.notes) == 3
    assert verification.undamaged == 2


@pytest.fixture
def folders(tmp_path):
    """Return two stores that share one batch, to the bit."""
    source, target = tmp_path / "source", tmp_path / "target"
    filled(source, WORK[:3])
    filled(target, WORK[:1])
    reopened(target).add([(WORK[4], random_result(WORK[4], 4))])
    return source, target


def test_a_merge_keeps_all_records_and_does_not_change_the_source(folders):
    source, target = folders
    before = contents(source)
    lines = merge_into(source, target)
    assert lines == ["merged      2 of 3 shards, 2 new records"]
    assert contents(source) == before
    store = Store(target)
    assert held(store) == {r for batch in (*WORK[:3], WORK[4]) for r in records(batch)}
    for seed in (0, 1, 2, 4):
        assert_holds(store, WORK[seed], random_result(WORK[seed], seed))
    assert Verification(target).faults == []
    assert store.index.makers_of({batch.tasks[0].key: 99 for batch in WORK[:5]}) == {MAKER}
    again = contents(target)
    assert merge_into(source, target) == ["merged      0 of 3 shards, 0 new records"]
    assert contents(target).keys() == again.keys()


def test_a_merge_creates_the_target(folders, tmp_path):
    merge_into(folders[0], tmp_path / "new" / "store")
    assert held(Store(tmp_path / "new" / "store")) == held(Store(folders[0]))


def test_records_that_differ_in_one_bit_are_counted(folders):
    source, target = folders
    result = random_result(WORK[4], 4)
    result.scalars[0, 0, 0] = np.nextafter(result.scalars[0, 0, 0], np.inf)
    Store(source).add([(WORK[4], result)])
    lines = merge_into(source, target)
    assert lines[0] == "differing   1 records are in both stores, with different bits"
    assert_holds(Store(target), WORK[4], random_result(WORK[4], 4))


def test_a_merge_without_locks_needs_an_option(folders, monkeypatch):
    def no_locks(*_):
        raise OSError(errno.ENOLCK, "No locks available")

    monkeypatch.setattr(fcntl, "flock", no_locks)
    with pytest.raises(UserError, match="then add --no-lock"):
        merge_into(*folders)
    assert merge_into(*folders, no_lock=True) == ["merged      2 of 3 shards, 2 new records"]


def test_a_damaged_shard_is_left_out_and_not_changed(folders):
    source, target = folders
    path = shard_of(Store(source), WORK[1])
    path.write_bytes(path.read_bytes()[:-50])
    before = contents(source)
    lines = merge_into(source, target)
    assert lines[0].startswith(f"left out    {path.name}: its content does not match")
    assert contents(source) == before
    assert not set(records(WORK[1])) & held(Store(target))


def test_a_damaged_shard_of_the_target_is_replaced(folders):
    source, target = folders
    path = shard_of(Store(target), WORK[0])
    path.write_bytes(path.read_bytes()[:-50] + 50 * b"x")
    lines = merge_into(source, target)
    assert lines == ["merged      3 of 3 shards, 3 new records"]
    assert_holds(Store(target), WORK[0], random_result(WORK[0], 0))
    assert Verification(target).faults == []


def test_a_store_in_use_another_format_and_the_store_itself_are_refused(folders, monkeypatch):
    monkeypatch.setattr("elastomer_friction.workflow.system.lock.PROBE_SECONDS", 0.1)
    source, target = folders
    with hold(target), pytest.raises(UserError, match="in use by"):
        merge_into(source, target)
    with pytest.raises(UserError, match="cannot be merged with itself"):
        merge_into(source, source)
    journal.append(source, [{"format": "elastomer-friction journal 99"}])
    with pytest.raises(UserError, match="has another format"):
        merge_into(source, target)
