"""A store that is checked: what is wrong is found and named, and nothing is changed."""

import pytest

from elastomer_friction.workflow.store import journal
from elastomer_friction.workflow.store.shard import digest
from elastomer_friction.workflow.store.verify import Verified
from tests.support.faults import DAMAGE
from tests.support.shards import BATCH, WORK, filled, records, reopened, shard_of
from tests.support.small import MAKER, random_result


@pytest.fixture
def store(tmp_path):
    """Return a store of three shards, begun as a run begins it."""
    store = reopened(tmp_path)
    for seed, batch in enumerate([BATCH, *WORK[4:6]]):
        store.add([(batch, random_result(batch, seed))])
    return store


def verified(folder):
    """Return what is found in a store, which is left as it is."""
    before = {path: path.read_bytes() for path in folder.iterdir()}
    found = Verified(folder)
    assert {path: path.read_bytes() for path in folder.iterdir()} == before
    return found


def test_a_sound_store_has_no_fault(store):
    found = verified(store.folder)
    assert found.faults == found.notes == []
    assert found.lines()[1:6] == [
        "journal     7 lines",
        "shards      3 of 3 sound",
        f"records     18 of {len(found.keys)} problems",
        f"computed    with {MAKER.versions}, on {MAKER.processor}",
        "failed      0 problems",
    ]
    assert found.lines()[-1] == "verified    no faults"


@pytest.mark.parametrize("name", [name for name in DAMAGE if name != "of another program"])
def test_a_damaged_shard_is_named(store, name):
    path = shard_of(store, WORK[4])
    path.write_bytes(DAMAGE[name](path.read_bytes()))
    found = verified(store.folder)
    assert found.sound == 2
    (fault,) = found.faults
    assert fault.startswith(f"{path.name}: damaged (")


def test_a_file_of_another_program_is_noted_and_no_fault(store):
    path = shard_of(store, WORK[4])
    content = DAMAGE["of another program"](b"")
    path.with_name(f"{digest(content)}.nc").write_bytes(content)
    found = verified(store.folder)
    assert (found.sound, found.shards, found.faults) == (3, 4, [])
    (note,) = found.notes
    assert note.startswith(f"{digest(content)}.nc: is no shard of this program")


def test_a_missing_shard_and_a_strange_file_are_named(store):
    path = shard_of(store, BATCH)
    path.replace(path.with_suffix(".damaged"))
    found = verified(store.folder)
    assert found.faults == [f"{path.name}: missing, but told by the journal"]
    assert found.notes == [f"{path.stem}.damaged: no part of the store"]


@pytest.mark.parametrize("line", range(7))
def test_a_spoilt_line_is_named_by_its_number(store, line):
    path = store.folder / journal.NAME
    lines = path.read_bytes().splitlines(keepends=True)
    lines[line] = lines[line][:20] + b"?" + lines[line][21:]
    path.write_bytes(b"".join(lines))
    faults = verified(store.folder).faults
    assert f"{journal.NAME}, line {line + 1}: spoilt" in faults
    assert not any("not understood" in fault for fault in faults)


def test_every_key_is_compared_with_what_the_journal_tells(store):
    entries = [entry for entry, _ in journal.entries(store.folder)]
    shards = [entry for entry in entries if "shard" in entry]
    shards[1]["chunks"], shards[2]["chunks"] = shards[2]["chunks"], shards[1]["chunks"]
    (store.folder / journal.NAME).write_bytes(journal.encoded(entries))
    found = verified(store.folder)
    assert len(found.faults) == 2
    key, block = records(WORK[5])[0]
    assert any(f"does not hold block {block} of {key} where" in fault for fault in found.faults)


def test_a_maker_that_the_shard_does_not_name_is_a_fault(store):
    entries = [entry for entry, _ in journal.entries(store.folder)]
    maker = next(entry for entry in entries if "maker" in entry)
    maker["versions"] = "numpy 1"
    (store.folder / journal.NAME).write_bytes(journal.encoded(entries))
    faults = verified(store.folder).faults
    assert len(faults) == 3
    assert all("was computed with something else" in fault for fault in faults)


def test_shards_that_the_journal_does_not_tell_are_noted(tmp_path):
    filled(tmp_path, WORK[:2])
    (tmp_path / journal.NAME).unlink()
    found = verified(tmp_path)
    assert found.faults == []
    assert len(found.notes) == 3
    assert found.sound == 2
