"""Damaged shards are set aside, and all others are read; lost lines of the journal come back."""

import contextlib
import dataclasses

import netCDF4
import pytest

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
from workflow.store import journal, shard
from workflow.store.store import DamagedShard, Store


def truncated(share):
    """Return how to cut a file down to ``share`` of what it is without its padding."""
    return lambda content: content[: int(share * len(content.rstrip(b"\0")))]


def flipped(content):
    """Flip one bit in the middle of the stored numbers."""
    place = content.index(random_result(WORK[0], 0).curves[0, 0, :4].tobytes())
    return content[: place + 9] + bytes([content[place + 9] ^ 1]) + content[place + 10 :]


def foreign(_):
    """Return a netCDF file of another program."""
    data = netCDF4.Dataset("foreign.nc", "w", memory=1024)
    data.createDimension("x", 3)
    return bytes(data.close())


DAMAGE = {
    "empty": truncated(0.0),
    "first bytes": truncated(0.001),
    "tenth": truncated(0.1),
    "half": truncated(0.5),
    "most": truncated(0.9),
    "flipped bit": flipped,
    "zeros": lambda content: bytes(len(content)),
    "text": lambda content: b"not netCDF at all",
    "foreign": foreign,
}


def seen(folder, batch):
    """Return the store of a folder once whatever is wrong with a batch has shown."""
    store = reopened(folder)
    if records(batch)[0] in store:  # what kept its length shows when it is read
        with contextlib.suppress(DamagedShard):
            store.read(records(batch), SAMPLES)
    return store


@pytest.mark.parametrize("name", DAMAGE)
def test_damaged_shard_is_set_aside_and_the_others_are_read(tmp_path, capsys, name):
    store, results = filled(tmp_path, WORK[:3])
    damaged = shard_of(store, WORK[0])
    content = DAMAGE[name](damaged.read_bytes())
    damaged.write_bytes(content)
    again = seen(tmp_path, WORK[0])
    assert held(again) == held(Store(tmp_path)) == {*records(WORK[1]), *records(WORK[2])}
    assert_holds(again, WORK[1], results[1])
    assert_holds(again, WORK[2], results[2])
    assert not damaged.exists()
    assert damaged.with_suffix(".damaged").read_bytes() == content
    warning = capsys.readouterr().err
    assert warning.startswith(f"warning: {damaged} is damaged")
    assert warning.count("\n") == 1


def test_a_shard_that_vanished_is_named(tmp_path, capsys):
    store, _ = filled(tmp_path, WORK[:2])
    shard_of(store, WORK[0]).unlink()
    assert held(reopened(tmp_path)) == set(records(WORK[1]))
    assert f"{shard_of(store, WORK[0])} is damaged (missing)" in capsys.readouterr().err


def test_damaged_shard_can_be_computed_again(tmp_path, capsys):
    store, results = filled(tmp_path, WORK[:1])
    shard_of(store, WORK[0]).write_bytes(b"")
    again = reopened(tmp_path)
    again.add([(WORK[0], results[0])])
    assert_holds(Store(tmp_path), WORK[0], results[0])
    assert "damaged" in capsys.readouterr().err


def test_shard_of_another_format_is_set_aside(tmp_path, capsys, monkeypatch):
    with monkeypatch.context() as earlier:
        earlier.setattr(shard, "FORMAT", "elastomer-friction shard 0")
        filled(tmp_path, WORK[:1])
    (tmp_path / journal.NAME).unlink()
    assert held(reopened(tmp_path)) == set()
    assert [path.suffix for path in tmp_path.iterdir()] == [".damaged"]
    assert "not a shard of this program" in capsys.readouterr().err


@pytest.mark.parametrize("length", [*range(0, 2**16, 3001)])
def test_shard_cut_at_any_length_is_set_aside_or_whole(tmp_path, capsys, length):
    store, (result,) = filled(tmp_path, WORK[:1])
    path = shard_of(store, WORK[0])
    path.write_bytes(path.read_bytes()[:length])
    again = reopened(tmp_path)
    if held(again):
        assert_holds(again, WORK[0], result)
    else:
        assert "set aside" in capsys.readouterr().err


@pytest.mark.parametrize("place", [*range(0, 2**16, 4099)])
def test_a_flipped_bit_anywhere_is_found(tmp_path, capsys, place):
    store, _ = filled(tmp_path, WORK[:1])
    path = shard_of(store, WORK[0])
    content = bytearray(path.read_bytes())
    content[min(place, len(content) - 1)] ^= 1
    path.write_bytes(content)
    assert held(seen(tmp_path, WORK[0])) == set()
    assert "checksum" in capsys.readouterr().err


@pytest.mark.parametrize("lost", [None, 0, 1, 2, 3])
def test_lost_lines_of_the_journal_are_found_again_in_the_shards(tmp_path, lost):
    _, results = filled(tmp_path, WORK[:3])
    path = tmp_path / journal.NAME
    lines = path.read_bytes().splitlines(keepends=True)
    assert len(lines) == 4  # the keys of the one task, then three shards
    path.write_bytes(b"".join(line for i, line in enumerate(lines) if lost not in (None, i)))
    for store in (reopened(tmp_path), Store(tmp_path)):
        for batch, result in zip(WORK[:3], results, strict=True):
            assert_holds(store, batch, result)


def repeated_lines(folder, repeats):
    """Write every line of a journal so many times, as joined journals may hold it."""
    path = folder / journal.NAME
    lines = path.read_bytes().splitlines(keepends=True)
    path.write_bytes(b"".join(line for line in lines for _ in range(repeats)))


COMPANIES = [
    dataclasses.replace(BATCH, tasks=tasks) for tasks in (BATCH.tasks[:1], BATCH.tasks[1:])
]


@pytest.mark.parametrize("repeats", [2, 3])
def test_a_line_told_twice_hands_no_problem_the_numbers_of_another(tmp_path, repeats):
    filled(tmp_path, COMPANIES[:1])
    repeated_lines(tmp_path, repeats)  # once the keys were numbered by their place in the journal
    store = reopened(tmp_path)
    store.add([(COMPANIES[1], random_result(COMPANIES[1], 1))])
    for again in (store, Store(tmp_path), reopened(tmp_path)):
        for seed, batch in enumerate(COMPANIES):
            assert_holds(again, batch, random_result(batch, seed))


def test_two_joined_journals_are_one_store(tmp_path):
    folders = tmp_path / "one", tmp_path / "two"
    for folder, work in zip(folders, ([BATCH, WORK[5]], [WORK[5], BATCH, WORK[2]]), strict=True):
        filled(folder, work)
    joined = b"".join((folder / journal.NAME).read_bytes() for folder in folders)
    for path in folders[1].glob("*.nc"):
        path.replace(folders[0] / path.name)
    (folders[0] / journal.NAME).write_bytes(joined)
    store = reopened(folders[0])
    assert held(store) == {*records(BATCH), *records(WORK[5]), *records(WORK[2])}
    store.read(sorted(held(store)), SAMPLES)


def test_a_journal_that_is_wrong_about_a_sound_shard_is_mended(tmp_path, capsys):
    store, results = filled(tmp_path, COMPANIES)
    entries = [entry for entry, _ in journal.entries(tmp_path)]
    entries.sort(key=lambda entry: "part" not in entry)
    tables = [entry["chunks"] for entry in entries if "shard" in entry]
    swapped = iter(tables[::-1])
    for entry in entries:
        if "shard" in entry:
            entry["chunks"] = next(swapped)
    (tmp_path / journal.NAME).write_bytes(journal.lines_of(entries))
    store = reopened(tmp_path)
    with pytest.raises(DamagedShard):
        store.read(records(COMPANIES[1]), SAMPLES)
    assert "every shard is read anew" in capsys.readouterr().err
    for again in (store, Store(tmp_path)):
        for batch, result in zip(COMPANIES, results, strict=True):
            assert_holds(again, batch, result)
    assert len(list(tmp_path.glob("*.nc"))) == 2  # none is set aside


def test_a_part_whose_keys_do_not_match_its_checksum_is_not_taken_up(tmp_path):
    filled(tmp_path, [BATCH])
    entries = [entry for entry, _ in journal.entries(tmp_path)]
    entries[0]["keys"] = entries[0]["keys"][32:] + entries[0]["keys"][:32]  # two tasks exchanged
    (tmp_path / journal.NAME).write_bytes(journal.lines_of(entries))
    assert held(Store(tmp_path)) == set()
    assert_holds(reopened(tmp_path), BATCH, random_result(BATCH, 0))


def test_mending_a_sound_store_changes_nothing(tmp_path):
    filled(tmp_path, WORK[:3])
    before = {path: path.read_bytes() for path in tmp_path.iterdir()}
    reopened(tmp_path)
    assert {path: path.read_bytes() for path in tmp_path.iterdir()} == before


def test_leftovers_of_a_dead_writer_are_removed(tmp_path):
    filled(tmp_path, WORK[:1])
    (tmp_path / ".0123.nc.4711.tmp").touch()
    reopened(tmp_path)
    assert list(tmp_path.glob(".*")) == []
