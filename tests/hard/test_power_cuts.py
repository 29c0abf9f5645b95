"""Power cuts at each flush and rename of a store: what was not flushed is lost, torn or reordered.

A disk keeps the content of a file up to its last fsync, and the names in a folder up to that of the
folder. Of later changes each name, and each file as a whole, in part or with zeros, may or may not
have reached it, in any order.
"""

import os
from pathlib import Path

import numpy as np

from elastomer_friction.workflow.store.store import Store
from tests.support.faults import SHARDS, TRUTH, checked, fill, readable
from tests.support.shards import held, records, reopened
from tests.support.sweeps import sweep

FAILED = "f" * 32  # key of a task


class Disk:
    """States in which a power cut may leave a folder, beside the records promised by then."""

    def __init__(self, folder, monkeypatch):
        self.folder, self.promised = folder, set()
        self.flushed, self.names = {}, {}  # contents by number of the file, and numbers by name
        self.moments = []  # (promised, flushed contents, contents, names, flushed names)
        for owner, name in ((os, "fsync"), (Path, "replace"), (Path, "unlink")):
            monkeypatch.setattr(owner, name, self.noted(getattr(owner, name)))

    def noted(self, function):
        """Return the function, which notes the state of the disk before it and after it."""

        def call(*args, **named):
            self.note()
            result = function(*args, **named)
            if function.__name__ == "fsync":
                self.flush(os.fstat(args[0]).st_ino)
            self.note()
            return result

        return call

    def now(self):
        """Return the contents of the files by their numbers, and the numbers by name."""
        paths = [path for path in self.folder.iterdir() if path.is_file()]
        names = {path.name: path.stat().st_ino for path in paths}
        return {names[path.name]: path.read_bytes() for path in paths}, names

    def note(self):
        """Add the present state."""
        self.moments.append((set(self.promised), dict(self.flushed), *self.now(), dict(self.names)))

    def flush(self, number):
        """Take a file, or the names in the folder, as flushed."""
        contents, names = self.now()
        if number == self.folder.stat().st_ino:
            self.names = names
        else:
            self.flushed[number] = contents[number]


def torn(flushed, content, random):
    """Return what a power cut may leave of a file with some flushed content."""
    kept = int(random.integers(len(flushed), len(content) + 1)) if len(content) else 0
    rest = len(content) - kept
    return [flushed, content, content[:kept], content[:kept] + bytes(rest)][random.integers(4)]


def after_cut(moment, folder, random):
    """Write one of the possible states of the disk after a power cut."""
    _, flushed, contents, names, flushed_names = moment
    folder.mkdir()
    for name in names.keys() | flushed_names.keys():
        number = (names, flushed_names)[random.integers(2)].get(name)
        if number is not None:
            before = flushed.get(number, b"")
            content = torn(before, contents.get(number, before), random)
            (folder / name).write_bytes(content)


@sweep("states", 3, 60)
def test_a_power_cut_loses_no_promised_record_and_changes_none(tmp_path, monkeypatch, states):
    folder, random = tmp_path / "store", np.random.default_rng(5)
    folder.mkdir()
    with monkeypatch.context() as patch:
        disk = Disk(folder, patch)
        store = Store(folder)
        store.prepare()
        store.record_failure(FAILED, "a reason")  # in the journal alone
        disk.promised = {FAILED}
        for batches in SHARDS:
            store.add([(batch, TRUTH[records(batch)[0]]) for batch in batches])
            disk.promised = {FAILED, *held(store)}
        disk.note()
    assert len(disk.moments) > 10 * len(SHARDS)
    lost = 0
    for number, moment in enumerate(disk.moments):
        for state in range(states):
            cut = tmp_path / f"{number}-{state}"
            after_cut(moment, cut, random)
            stored = readable(cut)
            assert stored | Store(cut).failed.keys() >= moment[0]
            lost += stored < TRUTH.keys()
            fill(reopened(cut))
            assert checked(Store(cut)) == TRUTH.keys()
    assert lost
