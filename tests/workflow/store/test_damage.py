"""Damaged shards are set aside, the others are read, and lost journal lines are restored."""

import contextlib

import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.store import journal, shard
from elastomer_friction.workflow.store.store import DamagedShard, Store
from elastomer_friction.workflow.store.verify import Verification
from tests.support.faults import DAMAGE, flipped
from tests.support.shards import (
    SAMPLES,
    WORK,
    assert_holds,
    contents,
    filled,
    held,
    records,
    reopened,
    shard_of,
)
from tests.support.small import random_result


def one_bit(content):
    """Flip one bit in the middle of the stored numbers."""
    return flipped(content, content.index(random_result(WORK[0], 0).curves[0, 0, :4].tobytes()) + 9)


SPOILT = {**DAMAGE, "a flipped bit": one_bit}


def opened(folder, batch):
    """Return the store of a folder after any damage to a batch has been found."""
    store = reopened(folder)
    if records(batch)[0] in store:  # damage that keeps the length is found by reading
        with contextlib.suppress(DamagedShard):
            store.read(records(batch), SAMPLES)
    return store


@pytest.mark.parametrize("name", SPOILT)
def test_damaged_shard_is_set_aside_the_others_are_read_and_it_can_be_computed_again(
    tmp_path, capsys, name
):
    store, results = filled(tmp_path, WORK[:3])
    damaged = shard_of(store, WORK[0])
    content = SPOILT[name](damaged.read_bytes())
    damaged.write_bytes(content)
    again = opened(tmp_path, WORK[0])
    assert held(again) == held(Store(tmp_path)) == {*records(WORK[1]), *records(WORK[2])}
    assert_holds(again, WORK[1], results[1])
    assert_holds(again, WORK[2], results[2])
    assert not damaged.exists()
    assert damaged.with_suffix(".damaged").read_bytes() == content
    warning = capsys.readouterr().err
    assert warning.startswith(f"warning: {damaged} is damaged")
    assert warning.count("\n") == 1
    again.add([(WORK[0], results[0])])
    assert_holds(Store(tmp_path), WORK[0], results[0])


@pytest.mark.parametrize(("length", "why"), [(0, "missing)"), (100, "its content does not match ")])
def test_a_shard_that_vanished_or_was_cut_is_named_when_the_store_is_opened(
    tmp_path, capsys, length, why
):
    store, _ = filled(tmp_path, WORK[:2])
    path = shard_of(store, WORK[0])
    content = path.read_bytes()[:length]
    path.write_bytes(content) if content else path.unlink()
    assert held(reopened(tmp_path)) == set(records(WORK[1]))
    assert f"{path} is damaged ({why}" in capsys.readouterr().err


def test_a_shard_that_vanishes_while_the_store_is_open_can_be_computed_again(tmp_path, capsys):
    store, _ = filled(tmp_path, WORK[:2])
    shard_of(store, WORK[0]).unlink()
    with pytest.raises(DamagedShard):
        store.read(records(WORK[0]), SAMPLES)
    assert "is damaged (missing)" in capsys.readouterr().err
    for again in (store, Store(tmp_path)):
        assert held(again) == set(records(WORK[1]))
        assert len(again.index.sizes) == len(again.index.makers_of_shard) == 1
    assert Verification(tmp_path).faults == []


def test_a_shard_that_the_disk_refuses_to_read_is_left_where_it_is(tmp_path):
    store, _ = filled(tmp_path, WORK[:1])
    path = shard_of(store, WORK[0])
    path.unlink()
    path.mkdir()  # reading it fails with EISDIR
    with pytest.raises(UserError, match="cannot be read"):
        store.read(records(WORK[0]), SAMPLES)
    assert path.is_dir()
    assert held(store) == set(records(WORK[0]))


@pytest.mark.parametrize("journaled", [True, False])
@pytest.mark.parametrize("renamed", [True, False])  # other versions may use other names
def test_shard_of_another_format_is_named_and_left_as_it_is(
    tmp_path, capsys, monkeypatch, journaled, renamed
):
    with monkeypatch.context() as earlier:
        earlier.setattr(shard, "SHARD_FORMAT", "elastomer-friction shard 99")
        store, _ = filled(tmp_path, WORK[:1])
    path = shard_of(store, WORK[0])
    if renamed:
        path = path.replace(path.with_stem("0" * 32))
    content = path.read_bytes()
    if renamed or not journaled:
        (tmp_path / journal.NAME).unlink()
    assert held(opened(tmp_path, WORK[0])) == set()
    assert path.read_bytes() == content
    assert not list(tmp_path.glob("*.damaged"))
    note = f"note: {path}: has another format (elastomer-friction shard 99, not "
    assert note in capsys.readouterr().err


def test_a_sound_file_of_another_program_is_left_as_it_is(tmp_path, capsys):
    content = DAMAGE["of another program"](b"")
    path = tmp_path / f"{shard.digest(content)}.npz"
    for file in (path, tmp_path / "notes.npz"):
        file.write_bytes(content)
    assert held(reopened(tmp_path)) == set()
    assert path.read_bytes() == (tmp_path / "notes.npz").read_bytes() == content
    assert "is not a shard of this program" in capsys.readouterr().err


def test_a_journal_of_another_format_is_refused_and_left_as_it_is(tmp_path):
    filled(tmp_path, WORK[:1])
    journal.append(tmp_path, [{"format": "elastomer-friction journal 99"}])
    before = contents(tmp_path)
    with pytest.raises(UserError) as error:
        Store(tmp_path)
    assert str(error.value).startswith(
        f"{tmp_path / journal.NAME}: has another format (elastomer-friction journal 99, not "
        "elastomer-friction journal 2) and is not changed"
    )
    assert contents(tmp_path) == before


def test_mending_a_sound_store_changes_nothing(tmp_path):
    filled(tmp_path, WORK[:3])
    before = contents(tmp_path)
    reopened(tmp_path)
    assert contents(tmp_path) == before


def test_leftovers_of_a_dead_writer_are_removed(tmp_path):
    filled(tmp_path, WORK[:1])
    for suffix in (".npz", ".nc"):
        (tmp_path / f".0123{suffix}.4711.tmp").touch()
    reopened(tmp_path)
    assert list(tmp_path.glob(".*")) == []
