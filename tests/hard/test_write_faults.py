"""Whatever befalls the files of a store, a record read back is what was written, or is missing.

Shards are cut and spoilt at every STRIDE-th byte, journals more densely;
WRITE_FAULT_STRIDE=1 tries every one.
"""

import contextlib
import errno
import os
import shutil
import subprocess
from collections import Counter
from pathlib import Path

import pytest

from tests.support.shards import SAMPLES, WORK, held, records, reopened
from tests.support.small import random_result
from workflow.errors import UserError
from workflow.store import journal
from workflow.store.store import DamagedShard, Store

STRIDE = int(os.environ.get("WRITE_FAULT_STRIDE", "997"))
SHARDS = (WORK[:2], WORK[2:3], WORK[3:4])  # batches of each shard
TRUTH = {
    record: random_result(batch, seed)
    for seed, batch in enumerate(WORK[:4])
    for record in records(batch)
}
TRIED: Counter = Counter()


class Crash(BaseException):
    """The end of the process, wherever it is."""


@pytest.fixture(scope="module", autouse=True)
def figures(request):
    """Print how many faults were tried."""
    yield
    tried = ", ".join(f"{kind} {number}" for kind, number in TRIED.items())
    with request.config.pluginmanager.getplugin("capturemanager").global_and_fixture_disabled():
        print(f"\nwrite faults tried: {tried}; {TRIED.total()} in all")


@pytest.fixture
def instant(monkeypatch):
    """Do not wait for the disk."""
    monkeypatch.setattr(os, "fsync", lambda _: None)


@pytest.fixture
def sound(tmp_path, instant):
    """Return the folder of a store with three sound shards."""
    folder = tmp_path / "sound"
    folder.mkdir()
    fill(Store(folder))
    return folder


def fill(store):
    """Store all shards, in order."""
    for work in SHARDS:
        store.add([(batch, TRUTH[records(batch)[0]]) for batch in work])


def checked(store):
    """Assert that every record of a store is true; return those that are there."""
    found = set()
    for record in held(store):
        with contextlib.suppress(DamagedShard, UserError):
            if record not in store:
                continue  # it went with the shard that was found damaged just before
            scalars, curves = store.read([record], SAMPLES)
            assert scalars.tobytes() == TRUTH[record].scalars.tobytes()
            assert curves.tobytes() == TRUTH[record].curves.tobytes()
            found.add(record)
    return found


def readable(folder, kind):
    """Check a store as a reader finds it, then as the next run does; return what that finds."""
    TRIED[kind] += 1
    untouched = folder.with_name("untouched")
    shutil.rmtree(untouched, ignore_errors=True)
    shutil.copytree(folder, untouched)
    checked(Store(untouched))
    mended = reopened(folder)
    found = checked(mended)
    assert checked(Store(folder)) == found  # and so does the one after
    return found


def copies(sound, path, contents):
    """Yield a copy of the store for each of the contents of one of its files."""
    for content in contents:
        folder = sound.with_name("spoilt")
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(sound, folder)
        (folder / path.name).write_bytes(content)
        yield folder


def prefixes(content, stride):
    """Return the content cut everywhere, where the stride is 1."""
    return [content[:length] for length in range(0, len(content), stride)]


def flips(content, stride):
    """Return the content with one byte spoilt, in one bit or in all, by turns."""
    found = []
    for place in range(0, len(content), stride):
        mask = 0xFF if place // stride % 2 else 1 << place % 8
        found.append(content[:place] + bytes([content[place] ^ mask]) + content[place + 1 :])
    return found


def first_shard(folder):
    """Return the shard that holds two batches, and its records."""
    store = Store(folder)
    inside = {record for batch in SHARDS[0] for record in records(batch)}
    name = store.index.find(next(iter(inside)))[0]
    return folder / f"{name}.nc", inside


@pytest.mark.parametrize("spoil", [prefixes, flips])
def test_spoilt_shard_is_missing_and_the_others_are_there(sound, spoil):
    shard, inside = first_shard(sound)
    for folder in copies(sound, shard, spoil(shard.read_bytes(), STRIDE)):
        assert readable(folder, f"shard {spoil.__name__}") == TRUTH.keys() - inside


@pytest.mark.parametrize("spoil", [prefixes, flips])
def test_spoilt_journal_loses_nothing(sound, spoil):
    path = sound / journal.NAME
    for folder in copies(sound, path, spoil(path.read_bytes(), 1 + STRIDE // 256)):
        assert readable(folder, f"journal {spoil.__name__}") == TRUTH.keys()


def test_shard_that_the_journal_does_not_know_is_whole_or_missing(sound):
    shard, inside = first_shard(sound)
    (sound / journal.NAME).unlink()
    for folder in copies(sound, shard, prefixes(shard.read_bytes(), STRIDE)):
        assert readable(folder, "unknown shard prefixes") == TRUTH.keys() - inside


def test_journal_without_shards_is_empty(sound):
    for shard in sound.glob("*.nc"):
        shard.unlink()
    assert readable(sound, "shards gone") == set()


class Faults:
    """Lets the nth call that changes a folder fail; counts the calls."""

    def __init__(self, nth, error, share):
        self.nth, self.error, self.share = nth, error, share
        self.calls = 0

    def due(self):
        """Count a call; return whether it is to fail."""
        self.calls += 1
        return self.calls == self.nth

    def before(self, function):
        """Return the function, failing in its turn."""

        def call(*args, **named):
            if self.due():
                raise self.error
            return function(*args, **named)

        return call

    def opened(self, function):
        """Return Path.open, whose files for writing fail in their turn, half-way."""

        def call(path, mode="r", *args, **named):
            if mode == "rb":
                return function(path, mode, *args, **named)
            if self.due():
                raise self.error
            return Torn(function(path, mode, *args, **named), self)

        return call


class Torn:
    """A file of which the write that fails leaves a part."""

    def __init__(self, file, faults):
        self.file, self.faults = file, faults

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.file.close()

    def __getattr__(self, name):
        return getattr(self.file, name)

    def write(self, content):
        """Write all, or a share and fail."""
        if self.faults.due():
            self.file.write(content[: int(self.faults.share * len(content))])
            self.file.flush()
            raise self.faults.error
        return self.file.write(content)


FULL = OSError(errno.ENOSPC, "No space left on device")
BROKEN = OSError(errno.EIO, "Input/output error")


@pytest.mark.parametrize(
    ("error", "share"),
    [(FULL, 0.0), (FULL, 0.5), (FULL, 1.0), (BROKEN, 0.9), (Crash(), 0.5), (Crash(), 1.0)],
)
def test_call_that_fails_loses_at_most_what_was_not_yet_stored(
    tmp_path, instant, monkeypatch, error, share
):
    for nth in range(1, 1000):
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
        assert readable(folder, f"{type(error).__name__} in a call") >= promised
        fill(reopened(folder))  # the next run goes on
        assert checked(Store(folder)) == TRUTH.keys()
    assert nth > 3 * len(SHARDS) * 3  # calls per file, shards, files changed at least


@pytest.fixture
def small_disk(tmp_path):
    """Return a function that mounts a folder of so many bytes."""
    mounted = []

    def mount(size):
        folder = tmp_path / f"disk{len(mounted)}"
        folder.mkdir()
        words = ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(folder)]
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        if done.returncode:
            pytest.skip(f"needs the right to mount: {done.stderr.strip()}")
        mounted.append(folder)
        return folder

    if shutil.which("mount") is None:
        pytest.skip("needs mount")
    yield mount
    for folder in mounted:
        subprocess.run(["umount", str(folder)], check=True)


def test_full_disk_keeps_what_was_stored(small_disk, sound):
    needed = sum(-(-path.stat().st_size // 4096) * 4096 for path in sound.iterdir())
    disk = small_disk(2 * needed)
    refused = 0
    for pages in range(0, needed // 4096 + 2):
        for path in disk.iterdir():
            shutil.rmtree(path) if path.is_dir() else path.unlink()
        free = shutil.disk_usage(disk).free
        (disk / "ballast").write_bytes(bytes(free - pages * 4096))
        folder = disk / "store"
        folder.mkdir()
        store = Store(folder)
        with contextlib.suppress(UserError):
            fill(store)
        TRIED["full disk"] += 1
        refused += held(store) < TRUTH.keys()
        stored = checked(Store(folder))
        assert stored >= held(store)
        assert not list(folder.glob(".*"))
        (disk / "ballast").unlink()
        fill(reopened(folder))
        assert checked(Store(folder)) == TRUTH.keys()
    assert refused > 3


def test_read_only_folder_is_read_and_left_as_it_is(small_disk, sound):
    disk = small_disk(2**22)
    folder = disk / "store"
    shutil.copytree(sound, folder)
    subprocess.run(["mount", "-o", "remount,ro", str(disk)], check=True)
    TRIED["read-only folder"] += 1
    store = Store(folder)
    assert checked(store) == TRUTH.keys()
    assert checked(reopened(folder)) == TRUTH.keys()
    with pytest.raises(UserError, match="cannot be written: Read-only file system"):
        store.add([(WORK[4], random_result(WORK[4]))])
    assert held(store) == TRUTH.keys()
