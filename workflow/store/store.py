"""Durable store of finished batches: immutable shards and a journal of their contents.

A shard is built in memory, written to a temporary file, flushed and renamed, and its folder is
flushed. Then a line is appended to the journal. Records are identified by (key of the task, block),
so that a wider grid, another batch size or another study reuses them. Only the holder of the
folder's lock writes; any number of processes may read. Every read compares the requested records
with those in the shard.
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
    refused,
    sizes_in,
    unreadable,
    write_durably,
)
from . import journal, shard
from .index import indexed
from .journal import Entry
from .netcdf_shard import NETCDF_SUFFIX, converted

CACHED_SHARDS = 4


def store_folder(result: Path) -> Path:
    """Return the folder of the store beside a result file; studies in one folder share it."""
    return result.parent / "store"


def enter_result(result: Path) -> None:
    """Record the digest of a result file durably in the store of its folder, created if missing.

    The entry is appended by a single write, so that a measurement does not need the folder's lock.
    """
    folder = store_folder(result)
    make_folder(folder)
    first: list[Entry] = [] if journal.size(folder) else [{"format": journal.JOURNAL_FORMAT}]
    journal.append(folder, [*first, {"result": result.name, "digest": digest_of(result)}])


def is_as_written(result: Path) -> bool | None:
    """Return whether a result is unchanged since a run wrote it, by the store of its folder.

    Returns None if the store is missing, unreadable, or does not list the result.
    """
    with contextlib.suppress(UserError):
        entries = journal.entries(store_folder(result))
        written = {entry["digest"] for entry, _ in entries if entry.get("result") == result.name}
        return digest_of(result) in written if written else None
    return None


class DamagedShard(Exception):
    """Raised after a mismatch of a shard and the journal was repaired; the caller may try again."""


class Store:
    """The shards of a folder, indexed from its journal without reading them."""

    def __init__(self, folder: Path, retry: DiskRetry | None = None) -> None:
        """Read the journal of ``folder``; change nothing.

        retry : retry policy for temporary disk errors. Raises UserError for permanent disk errors,
        and for a journal of another format.
        """
        self.folder, self.retry = folder, retry or DiskRetry()
        self.index = self.retry(partial(indexed, folder))
        self.failed = self.index.failed  # key of each task that failed for good -> reason
        self._contents = lru_cache(CACHED_SHARDS)(lambda name: self._load(name))

    def prepare(self) -> None:
        """Repair the store after a crash or disk error. The caller must hold the folder's lock.

        Listed shards that are missing are reported and dropped. Shards that are unlisted, or
        listed with another size, are entered if valid. Damaged files are set aside. NetCDF shards
        of version 0.3.0 are converted. Foreign files are reported and not changed.
        """
        for suffix in (shard.SHARD_SUFFIX, NETCDF_SUFFIX):
            clear_leftovers(self.folder / f"*{suffix}")
        if not self.retry(partial(journal.size, self.folder)):
            self._write([{"format": journal.JOURNAL_FORMAT}])
        self._convert(shard.shard_sizes(self._sizes(), NETCDF_SUFFIX))
        sizes, known = shard.shard_sizes(self._sizes()), dict(self.index.sizes)
        for name in known:
            if name not in sizes:
                self._set_aside(self._path(name), "missing")
        unread = sorted(name for name, size in sizes.items() if known.get(name) != size)
        self._enter_shards([name for name in unread if self._path(name).is_file()])

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

    def begin(self, run: str) -> None:
        """Record durably that a run begins. Shards entered later may belong to another study."""
        self._write([{"run": run}])

    def wrote(self, result: Path) -> bool:
        """Return whether a result file is unchanged since a run wrote it."""
        with contextlib.suppress(UserError):
            return digest_of(result) in self.index.results
        return False

    def record_failure(self, key: str, reason: str) -> None:
        """Record durably that a task failed for good."""
        self._write([{"failed": key, "why": reason}])

    def forget_failures(self, keys: set[str]) -> None:
        """Forget the failures of these tasks, so that the run retries them."""
        self._write([{"retry": key} for key in sorted(keys & self.failed.keys())])

    def read(self, records: list[Record], curve_samples: int) -> tuple[np.ndarray, np.ndarray]:
        """Return scalars (records, len(SCALARS)) and curves (records, curve_samples).

        Short curves are padded with NaN. Raises DamagedShard after setting a damaged shard aside
        or repairing its journal entry.
        """
        scalars = np.empty((len(records), len(SCALARS)))
        curves = np.full((len(records), curve_samples), np.nan)
        requested: dict[str, list[tuple[int, int]]] = {}
        for row, record in enumerate(records):
            name, position = self.index.find(record)
            requested.setdefault(name, []).append((row, position))
        for name, pairs in requested.items():
            contents = self._contents(name)
            if any(contents.records[at : at + 1] != [records[row]] for row, at in pairs):
                self._reindex(name)
                raise DamagedShard(name)
            rows, positions = np.array(pairs).T
            scalars[rows] = contents.scalars[positions]
            stored = contents.curves[positions, :curve_samples]
            curves[rows, : stored.shape[1]] = stored
        return scalars, curves

    def _path(self, name: str) -> Path:
        return shard.shard_path(self.folder, name)

    def _sizes(self) -> dict[str, int]:
        return self.retry(partial(sizes_in, self.folder))

    def _load(self, name: str) -> shard.Contents:
        """Return the content of a shard. Raises DamagedShard after setting a damaged one aside."""
        path = self._path(name)
        try:
            return shard.decode(name, self.retry(partial(read_whole, path)))
        except UserError as error:
            if not isinstance(error.__cause__, FileNotFoundError):
                raise  # the disk failed; the shard itself may be undamaged
            self._set_aside(path, "missing")
        except ValueError as error:
            self._set_aside(path, str(error))
        except shard.ForeignFile as error:
            print(f"note: {path}: {error}; it is not changed", file=sys.stderr)
            self._drop(name)
        raise DamagedShard(name)

    def _reindex(self, name: str) -> None:
        """Read all shards and enter them again, as the journal was wrong about shard ``name``."""
        path = self.folder / journal.NAME
        print(
            f"warning: {path}: does not match shard {name}: all shards are read again",
            file=sys.stderr,
        )
        self._enter_shards(list(self.index.sizes))

    def _enter_shards(self, names: list[str]) -> None:
        """Read the shards ``names`` and enter those that are undamaged."""
        for name in names:
            with contextlib.suppress(DamagedShard):
                contents = self._load(name)
                self._drop(name)
                size = self._path(name).stat().st_size
                self.enter(name, size, contents.batches, contents.makers)

    def _convert(self, names: dict[str, int]) -> None:
        """Replace netCDF shards of version 0.3.0 by .npz shards. names : name -> bytes."""
        paths = [self.folder / f"{name}{NETCDF_SUFFIX}" for name in sorted(names)]
        faults = self.retry(partial(unreadable, paths))
        count = 0
        for path in paths:
            try:
                content = self.retry(partial(read_whole, path))
                content = converted(path.stem, content, faults.get(path, ""))
            except shard.ForeignFile as error:
                print(f"note: {path}: {error}; it is not changed", file=sys.stderr)
            except ValueError as error:
                self._set_aside(path, str(error))
            else:
                new = self._path(shard.digest(content))
                self.retry(partial(write_durably, new, content))
                self._drop(path.stem)
                with refused(path, "cannot be removed:"):
                    path.unlink()
                count += 1
        if count:
            print(
                f"note: {self.folder}: converted {count} shards of version 0.3.0 to .npz",
                file=sys.stderr,
            )

    def _set_aside(self, path: Path, reason: str) -> None:
        print(f"warning: {path} is damaged ({reason}): set aside", file=sys.stderr)
        with contextlib.suppress(OSError):
            path.replace(path.with_suffix(".damaged"))
        self._drop(path.stem)

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
        """Append a shard to the journal. predicted : predicted core-seconds of its batches."""
        self.index.files[name] = size
        self._write(self.index.entries_of(name, size, batches, makers, predicted))

    def _write(self, entries: list[Entry]) -> None:
        self.retry(partial(journal.append, self.folder, entries))
        for entry in entries:
            self.index.replay(entry)
