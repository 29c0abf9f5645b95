"""Durable store of finished chunks: immutable shards and a journal that says what they hold.

A shard is built in memory, written aside, flushed, renamed, its folder flushed; then a line is
added to the journal. Records are found by (key of the task, block), so that widening a grid,
another batch size or another study reuses what is there. One process writes, the one that
holds the lock of the folder; any number may read.
"""

import contextlib
import os
import socket
import sys
from pathlib import Path

import numpy as np

from workflow import journal
from workflow.durable import clear_leftovers, write_durably
from workflow.plan import Record
from workflow.shard import KEY_BYTES, Chunk, Contents, Finished, chunk_of, decode, digest, encode
from workflow.simulate.tasks import SCALARS

CACHED_SHARDS = 4
KEY_LENGTH = 2 * KEY_BYTES


def store_folder(result: Path) -> Path:
    """Return the folder of finished batches beside a result file; studies share it."""
    return result.parent / "store"


class DamagedShard(Exception):
    """A shard did not hold what the journal says; it is set aside, its records are missing."""


class Store:
    """The shards of a results folder, indexed from the journal alone."""

    def __init__(self, folder: Path) -> None:
        """Index what the journal of ``folder`` tells; change nothing."""
        self.folder = folder
        self.sizes: dict[str, int] = {}  # name of each shard -> bytes
        self.parts: dict[str, tuple[int, int]] = {}  # checksum of keys -> number, tasks of a part
        self.rows: dict[str, list[tuple[int, int]]] = {}  # key -> parts it is in, row in each
        # (part, block) -> shard, record of row 0, records from a row to the next
        self.place: dict[tuple[int, int], tuple[str, int, int]] = {}
        self.failed: dict[str, str] = {}  # key of each task that failed for good -> why
        self.recent: dict[str, Contents] = {}
        for entry, _ in journal.entries(folder):
            self._replay(entry)

    def prepare(self) -> None:
        """Mend what a crash or a disk left behind; only for the holder of the folder's lock.

        Shards that are missing or damaged are set aside and named, finished shards that the
        journal does not know are entered.
        """
        clear_leftovers(self.folder / "*.nc")
        journal.end_torn_line(self.folder)
        found = {path.stem: path.stat().st_size for path in self.folder.glob("*.nc")}
        for name, size in list(self.sizes.items()):
            if name not in found:
                self._set_aside(name, "missing")
            elif found[name] != size:
                self._set_aside(name, f"{found[name]} bytes instead of {size}")
        for name in sorted(found.keys() - self.sizes.keys()):
            if self._path(name).is_file():
                with contextlib.suppress(DamagedShard):
                    self._enter(name, found[name], self._load(name).chunks)

    def __contains__(self, record: Record) -> bool:
        """Return whether a record is stored durably."""
        key, block = record
        return any((part, block) in self.place for part, _ in self.rows.get(key, ()))

    def add(self, finished: Finished) -> None:
        """Store finished batches durably in one shard. Raises UserError if the disk refuses."""
        content = encode(finished)
        name = digest(content)
        write_durably(self._path(name), content)
        used = sum(result.seconds for _, result in finished)
        predicted = sum(batch.seconds for batch, _ in finished)
        times = {"used": round(used, 3), "predicted": round(predicted, 3)}
        self._enter(name, len(content), [chunk_of(batch) for batch, _ in finished], times)

    def begin(self, study: str, versions: str, processor: str) -> None:
        """Note durably that a run of a study begins, and with what it will compute."""
        process = {"pid": os.getpid(), "host": socket.gethostname()}
        self._write([{"run": study, **process, "versions": versions, "processor": processor}])

    def record_failure(self, key: str, why: str) -> None:
        """Note durably that a task failed for good."""
        self._write([{"failed": key, "why": why}])

    def forget_failures(self, keys: set[str]) -> None:
        """Let failed tasks be tried again."""
        self._write([{"retry": key} for key in sorted(keys & self.failed.keys())])

    def read(self, records: list[Record], samples: int) -> tuple[np.ndarray, np.ndarray]:
        """Return (scalars, curves) of the records, shapes (records, 5) and (records, samples).

        Raises DamagedShard, once the shard is set aside.
        """
        scalars = np.empty((len(records), len(SCALARS)))
        curves = np.empty((len(records), samples))
        wanted: dict[str, list[tuple[int, int]]] = {}
        for row, record in enumerate(records):
            shard, place = self._find(record)
            wanted.setdefault(shard, []).append((row, place))
        for shard, pairs in wanted.items():
            rows, places = np.array(pairs).T
            contents = self._contents(shard)
            scalars[rows] = contents.scalars[places]
            curves[rows] = contents.curves[places, :samples]
        return scalars, curves

    def _path(self, name: str) -> Path:
        return self.folder / f"{name}.nc"

    def _find(self, record: Record) -> tuple[str, int]:
        key, block = record
        for part, row in self.rows[key]:
            if (part, block) in self.place:
                shard, base, step = self.place[part, block]
                return shard, base + row * step
        raise KeyError(record)

    def _contents(self, name: str) -> Contents:
        if name not in self.recent:
            while len(self.recent) >= CACHED_SHARDS:
                del self.recent[next(iter(self.recent))]
            self.recent[name] = self._load(name)
        return self.recent[name]

    def _load(self, name: str) -> Contents:
        try:
            content = self._path(name).read_bytes()
            if digest(content) != name:
                raise ValueError("its content does not match the checksum in its name")
            return decode(content)
        except (OSError, ValueError) as error:
            self._set_aside(name, str(error))
            raise DamagedShard(name) from error

    def _set_aside(self, name: str, why: str) -> None:
        path = self._path(name)
        print(f"warning: {path} is damaged ({why}): set aside", file=sys.stderr)
        with contextlib.suppress(OSError):
            path.replace(path.with_suffix(".damaged"))
        if name in self.sizes:
            self._write([{"dropped": name}])

    def _enter(self, name: str, size: int, chunks: list[Chunk], times: dict | None = None) -> None:
        """Enter a durable shard into the journal, after the parts it is the first to have."""
        entries: list[journal.Entry] = []
        table, count = [], 0
        for chunk in chunks:
            keys = "".join(chunk.keys)
            part = digest(keys.encode())
            if part not in self.parts and all(entry["part"] != part for entry in entries):
                entries.append({"part": part, "keys": keys})
            table.append([part, chunk.first_block, chunk.blocks])
            count += len(chunk.keys) * chunk.blocks
        shard = {"shard": name, "bytes": size, "records": count, "chunks": table, **(times or {})}
        self._write([*entries, shard])

    def _write(self, entries: list[journal.Entry]) -> None:
        journal.append(self.folder, entries)
        for entry in entries:
            self._replay(entry)

    def _replay(self, entry: journal.Entry) -> None:
        """Take one entry of the journal into the index."""
        if "part" in entry:
            keys, number = entry["keys"], len(self.parts)
            names = [keys[i : i + KEY_LENGTH] for i in range(0, len(keys), KEY_LENGTH)]
            self.parts[entry["part"]] = number, len(names)
            for row, key in enumerate(names):
                self.rows.setdefault(key, []).append((number, row))
        elif "shard" in entry:
            self._place(entry["shard"], entry["bytes"], entry["chunks"])
        elif "failed" in entry:
            self.failed[entry["failed"]] = entry["why"]
        elif "retry" in entry:
            self.failed.pop(entry["retry"], None)
        elif "dropped" in entry:
            self.sizes.pop(entry["dropped"], None)
            gone = [where for where, found in self.place.items() if found[0] == entry["dropped"]]
            for where in gone:
                del self.place[where]

    def _place(self, name: str, size: int, chunks: list[tuple[str, int, int]]) -> None:
        if any(part not in self.parts for part, _, _ in chunks):
            return  # the line of a part is spoilt: the shard itself tells its keys
        self.sizes[name] = size
        base = 0
        for part, first, blocks in chunks:
            number, tasks = self.parts[part]
            for row in range(blocks):
                self.place[number, first + row] = name, base + row, blocks
            base += tasks * blocks
