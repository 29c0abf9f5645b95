"""A record read back from a damaged store is bitwise equal, or missing.

Shards and journals are cut and damaged at some bytes in `make test`, and at every byte in
`make test-all`. If any call fails or the process ends, all stored records are kept.
"""

import contextlib
import errno
import io
import os
import shutil
from pathlib import Path

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.store import journal
from elastomer_friction.workflow.store.store import Store
from tests.support.disks import make_read_only, mounted
from tests.support.faults import SHARDS, TRUTH, checked, copies, fill, flips, prefixes, readable
from tests.support.shards import WORK, held, records, reopened
from tests.support.small import random_result
from tests.support.sweeps import mostly_exhaustive, sweep


class Crash(BaseException):
    """The end of the process at any place."""


class Faults:
    """Failure of the nth call that changes a folder; a write fails after a share of its bytes."""

    def __init__(self, nth, error, share):
        self.nth, self.error, self.share, self.calls = nth, error, share, 0

    def count(self):
        """Count a call; raise if it is the one to fail."""
        self.calls += 1
        if self.calls == self.nth:
            raise self.error

    def before(self, function):
        """Return the function, failing if it is the nth call."""

        def call(*args, **named):
            self.count()
            return function(*args, **named)

        return call

    def opened(self, function):
        """Return Path.open with files whose nth call or write fails."""
        faults = self

        class Torn(io.FileIO):
            def write(self, content):
                try:
                    faults.count()
                except BaseException:
                    super().write(content[: int(faults.share * len(content))])
                    raise
                return super().write(content)

        def call(path, mode="r", *args, **named):
            if mode == "rb":
                return function(path, mode, *args, **named)
            self.count()
            return Torn(path, mode.replace("b", ""))

        return call


STRIDE = sweep("stride", 271, 1)


@pytest.fixture
def instant(monkeypatch):
    """Disable fsync."""
    monkeypatch.setattr(os, "fsync", lambda _: None)


@pytest.fixture
def sound(tmp_path, instant):
    """Return the folder of a store with three sound shards."""
    folder = tmp_path / "sound"
    folder.mkdir()
    fill(Store(folder))
    return folder


def first_shard(folder):
    """Return the shard that holds two batches, and its records."""
    store = Store(folder)
    inside = {record for batch in SHARDS[0] for record in records(batch)}
    name = store.index.find(next(iter(inside)))[0]
    return folder / f"{name}.npz", inside


@STRIDE
@pytest.mark.parametrize("spoil", [prefixes, flips])
def test_spoilt_shard_is_missing_and_the_others_are_there(sound, spoil, stride):
    shard, inside = first_shard(sound)
    for folder in copies(sound, shard, spoil(shard.read_bytes(), stride)):
        assert readable(folder) == TRUTH.keys() - inside


@STRIDE
@pytest.mark.parametrize("spoil", [prefixes, flips])
def test_spoilt_journal_loses_nothing(sound, spoil, stride):
    path = sound / journal.NAME
    for folder in copies(sound, path, spoil(path.read_bytes(), 1 + stride // 7)):
        assert readable(folder) == TRUTH.keys()


@sweep("trials", 12, 500)
def test_journal_in_another_order_repeated_or_run_together_loses_nothing(sound, trials):
    path, random = sound / journal.NAME, np.random.default_rng(7)
    lines = path.read_bytes().splitlines(keepends=True)
    contents = []
    for _ in range(trials):
        chosen = random.permutation(np.repeat(np.arange(len(lines)), random.integers(1, 4)))
        whole = [lines[i] for i in chosen]
        torn = set(random.integers(0, len(whole), random.integers(0, 3)).tolist())
        contents.append(b"".join(x[:-1] if i in torn else x for i, x in enumerate(whole)))
    for folder in copies(sound, path, contents):
        assert readable(folder) == TRUTH.keys()


@STRIDE
def test_shard_that_the_journal_does_not_know_is_whole_or_missing(sound, stride):
    shard, inside = first_shard(sound)
    (sound / journal.NAME).unlink()
    for folder in copies(sound, shard, prefixes(shard.read_bytes(), stride)):
        assert readable(folder) == TRUTH.keys() - inside


def test_full_disk_keeps_what_was_stored(tmp_path, sound):
    """The disk becomes full after any number of pages."""
    needed = sum(-(-path.stat().st_size // 4096) * 4096 for path in sound.iterdir())
    refused = 0
    with mounted(tmp_path / "disk", str(2 * needed)) as disk:
        folder, ballast = disk / "store", disk / "ballast"
        for pages in range(needed // 4096 + 2):
            shutil.rmtree(folder, ignore_errors=True)
            ballast.write_bytes(bytes(shutil.disk_usage(disk).free - pages * 4096))
            folder.mkdir()
            store = Store(folder)
            with contextlib.suppress(UserError):
                fill(store)
            refused += held(store) < TRUTH.keys()
            stored = checked(Store(folder))
            assert stored >= held(store)
            assert not list(folder.glob(".*"))
            ballast.unlink()
            fill(reopened(folder))
            assert checked(Store(folder)) == TRUTH.keys()
    assert refused > 3


def test_read_only_folder_is_read_and_left_as_it_is(tmp_path, sound):
    with mounted(tmp_path / "disk", "4m") as disk:
        folder = disk / "store"
        shutil.copytree(sound, folder)
        make_read_only(disk)
        store = Store(folder)
        assert checked(store) == TRUTH.keys()
        assert checked(reopened(folder)) == TRUTH.keys()
        with pytest.raises(UserError, match="cannot be written: Read-only file system"):
            store.add([(WORK[4], random_result(WORK[4]))])
        assert held(store) == TRUTH.keys()


FULL, BROKEN = OSError(errno.ENOSPC, "No space left"), OSError(errno.EIO, "Input/output error")
WHOLE = [(FULL, 0.0), (FULL, 0.5), (FULL, 1.0), (BROKEN, 0.9), (Crash(), 0.5), (Crash(), 1.0)]


@mostly_exhaustive(
    "error, share, every",
    [(FULL, 0.5, 5), (Crash(), 1.0, 5)],  # one call in five fails
    [(error, share, 1) for error, share in WHOLE],
)
def test_call_that_fails_loses_at_most_what_was_not_yet_stored(
    tmp_path, instant, monkeypatch, error, share, every
):
    for nth in range(1, 1000, every):
        folder = tmp_path / str(nth)
        folder.mkdir()
        store, faults = Store(folder), Faults(nth, error, share)
        with monkeypatch.context() as patch:
            patch.setattr(os, "fsync", faults.before(os.fsync))
            patch.setattr(os, "open", faults.before(os.open))
            patch.setattr(Path, "replace", faults.before(Path.replace))
            patch.setattr(Path, "open", faults.opened(Path.open))
            with contextlib.suppress(Crash, UserError):
                fill(store)
        if faults.calls < nth:
            break
        promised = held(store)
        assert promised < TRUTH.keys()
        assert checked(store) == promised
        assert readable(folder) >= promised
        fill(reopened(folder))  # the next run continues
        assert checked(Store(folder)) == TRUTH.keys()
    assert nth > 3 * len(SHARDS) * 3  # least number: calls per file x shards x files
