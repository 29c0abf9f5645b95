"""Durable store of finished batches: immutable shards and a journal that says what they hold.

A shard is built in memory, written aside, flushed, renamed, its folder flushed; then a line is
added to the journal. Records are found by (key of the task, block), so that widening a grid,
another batch size or another study reuses what is there. One process writes, the holder of the
folder's lock; any number may read. Every read compares keys in the shard with those asked for.
"""

import contextlib
import sys
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

import numpy as np

from ..ground import UserError
from ..simulate import SCALARS, Record
from ..system import (
    DiskRetry,
    Maker,
    clear_leftovers,
    digest_of,
    make_folder,
    read_whole,
    sizes_in,
    unreadable,
    write_durably,
)
from . import journal, shard
from .index import indexed
from .journal import Entry

CACHED_SHARDS = 4


def store_folder(result: Path) -> Path:
    """Return the folder of finished batches beside a result file; studies share it."""
    return result.parent / "store"


def enter_result(result: Path) -> None:
    """Note durably in the store beside a result, made if need be, how a run has written it.

    It is one line, appended in one piece: who measures needs no lock of the folder for it.
    """
    folder = store_folder(result)
    make_folder(folder)
    first: list[Entry] = [] if journal.size(folder) else [{"format": journal.FORMAT}]
    journal.append(folder, [*first, {"result": result.name, "digest": digest_of(result)}])


def is_as_written(result: Path) -> bool | None:
    """Return whether a result is as a run has written it, by the store beside it.

    None where nothing is known of it: there is no store, or none that can be read or tells of it.
    """
    with contextlib.suppress(UserError):
        entries = journal.entries(store_folder(result))
        written = {entry["digest"] for entry, _ in entries if entry.get("result") == result.name}
        return digest_of(result) in written if written else None
    return None


class DamagedShard(Exception):
    """A shard did not hold what the journal says; journal or shard is mended, try again."""


class Store:
    """The shards of a results folder, indexed from the journal alone."""

    def __init__(self, folder: Path, retry: DiskRetry | None = None) -> None:
        """Index what the journal of ``folder`` tells; change nothing.

        patience : with a disk that refuses for the time being. Raises UserError where it refuses
        for good, and for a journal of another version of the format.
        """
        self.folder, self.retry = folder, retry or DiskRetry()
        self.index = self.retry(partial(indexed, folder))
        self.failed = self.index.failed  # key of each task that failed for good -> why
        self._contents = lru_cache(CACHED_SHARDS)(lambda name: self._load(name))

    def prepare(self) -> None:
        """Mend what a crash or a disk left behind; only for the holder of the folder's lock.

        Shards that are missing or damaged are set aside and named, finished shards that the
        journal does not know are entered. What is no shard of ours is named and left as it is.
        """
        clear_leftovers(self.folder / "*.nc")
        if not self.retry(partial(journal.size, self.folder)):
            self._write([{"format": journal.FORMAT}])
        found = shard.shard_sizes(self.retry(partial(sizes_in, self.folder)))
        known = dict(self.index.sizes)
        for name, size in known.items():
            if name not in found:
                self._set_aside(name, "missing")
            elif found[name] != size:
                self._set_aside(name, f"{found[name]} bytes instead of {size}")
        self._enter_unknown(
            [name for name in sorted(found.keys() - known.keys()) if self._path(name).is_file()]
        )

    def __contains__(self, record: Any) -> bool:
        """Return whether a record is stored durably."""
        return record in self.index

    def add(self, finished: shard.Finished) -> None:
        """Store finished batches durably in one shard. Raises UserError if the disk refuses."""
        content = shard.encode(finished)
        name = shard.digest(content)
        self.retry(partial(write_durably, self._path(name), content))
        predicted = round(sum(batch.seconds for batch, _ in finished), 3)
        makers = sorted({result.maker for _, result in finished})
        batches = [shard.stored_batch(batch) for batch, _ in finished]
        self.enter(name, len(content), batches, makers, predicted)

    def begin(self, what: str) -> None:
        """Note durably that a run begins: shards from here on may belong to another study."""
        self._write([{"run": what}])

    def wrote(self, result: Path) -> bool:
        """Return whether a result file is as a run has written it."""
        with contextlib.suppress(UserError):
            return digest_of(result) in self.index.results
        return False

    def record_failure(self, key: str, why: str) -> None:
        """Note durably that a task failed for good."""
        self._write([{"failed": key, "why": why}])

    def forget_failures(self, keys: set[str]) -> None:
        """Let failed tasks be tried again."""
        self._write([{"retry": key} for key in sorted(keys & self.failed.keys())])

    def read(self, records: list[Record], curve_samples: int) -> tuple[np.ndarray, np.ndarray]:
        """Return scalars (records, 6) and curves (records, curve_samples), filled up with NaN.

        Raises DamagedShard once the shard is set aside, or what the journal says of it is mended.
        """
        scalars = np.empty((len(records), len(SCALARS)))
        curves = np.full((len(records), curve_samples), np.nan)
        wanted: dict[str, list[tuple[int, int]]] = {}
        for row, record in enumerate(records):
            name, position = self.index.find(record)
            wanted.setdefault(name, []).append((row, position))
        for name, pairs in wanted.items():
            contents = self._contents(name)
            if any(contents.records[at : at + 1] != [records[row]] for row, at in pairs):
                self._enter_anew(name)
                raise DamagedShard(name)
            rows, positions = np.array(pairs).T
            scalars[rows] = contents.scalars[positions]
            found = contents.curves[positions, :curve_samples]
            curves[rows, : found.shape[1]] = found
        return scalars, curves

    def _path(self, name: str) -> Path:
        return self.folder / f"{name}.nc"

    def _load(self, name: str, tried: str = "") -> shard.Contents:
        """Return what a shard holds. Raises DamagedShard once one that is spoilt is set aside."""
        path = self._path(name)
        try:
            return shard.decode(name, self.retry(partial(read_whole, path)), tried)
        except UserError as error:
            if not isinstance(error.__cause__, FileNotFoundError):
                raise  # the disk refuses to read it: no fault of the shard
            self._set_aside(name, "missing")
        except ValueError as error:
            self._set_aside(name, str(error))
        except shard.NoShard as error:
            print(f"note: {path}: {error}; it is left as it is", file=sys.stderr)
            self._drop(name)
        raise DamagedShard(name)

    def _enter_anew(self, name: str) -> None:
        """Enter every shard by what it holds itself, as the journal was wrong about one."""
        path = self.folder / journal.NAME
        print(f"warning: {path} is wrong about {name}: every shard is read anew", file=sys.stderr)
        self._enter_unknown(list(self.index.sizes))

    def _enter_unknown(self, names: list[str]) -> None:
        """Enter shards by what they hold themselves, those that are sound.

        Nobody says where they are from: a process of its own reads them first.
        """
        tried = self.retry(partial(unreadable, [self._path(name) for name in names]))
        for name in names:
            with contextlib.suppress(DamagedShard):
                contents = self._load(name, tried.get(self._path(name), ""))
                self._drop(name)
                size = self._path(name).stat().st_size
                self.enter(name, size, contents.batches, contents.makers)

    def _set_aside(self, name: str, why: str) -> None:
        path = self._path(name)
        print(f"warning: {path} is damaged ({why}): set aside", file=sys.stderr)
        with contextlib.suppress(OSError):
            path.replace(path.with_suffix(".damaged"))
        self._drop(name)

    def _drop(self, name: str) -> None:
        if name in self.index.sizes:
            self._write([{"dropped": name}])

    def enter(
        self,
        name: str,
        size: int,
        batches: list[shard.StoredBatch],
        makers: list[Maker],
        predicted: float = 0.0,
    ) -> None:
        """Enter a durable shard, of batches of so many predicted seconds, into the journal."""
        self._write(self.index.entries_of(name, size, batches, makers, predicted))

    def _write(self, entries: list[Entry]) -> None:
        self.retry(partial(journal.append, self.folder, entries))
        for entry in entries:
            self.index.replay(entry)
