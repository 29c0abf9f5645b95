"""The index of a store: the shard of each record, and the tasks that failed for good.

The index is built by replaying the journal in order. A record is identified by (key of its task,
block). Tasks that are stored together form a part. The journal lists the keys of a part once, and
then refers to them by checksum. It lists makers (versions and processors) in the same way. No entry
refers to a position in the journal, so that repeated lines, for instance of two concatenated
journals, change nothing.
"""

import contextlib
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from ..simulate import SCALARS, Record
from ..system import Maker, sizes_in
from .journal import Entry, entries
from .netcdf_shard import NETCDF_SUFFIX
from .shard import KEY_LENGTH, StoredBatch, digest, shard_sizes

MIN_RECORD_BYTES = 8 * len(SCALARS)


class Rows(NamedTuple):
    """Rows of a shard that hold one block of all tasks of a part."""

    shard: str  # name
    first: int  # row of the first task
    step: int  # number of rows from one task to the next


class Index:
    """Location of each record, from the entries of the journal."""

    def __init__(self, files: Mapping[str, int] | None = None) -> None:
        """Create an empty index. files : bytes of each shard in the folder, by name."""
        self.files = dict(files or {})
        self.sizes: dict[str, int] = {}  # name of each shard -> bytes
        self.failed: dict[str, str] = {}  # key of each task that failed for good -> reason
        self.parts: dict[str, list[str]] = {}  # checksum of a part -> keys of its tasks
        self.tasks: dict[str, list[tuple[str, int]]] = {}  # key -> [(part, position in part), ...]
        self.makers: dict[str, Maker] = {}  # checksum -> maker
        self.makers_of_shard: dict[str, list[str]] = {}  # shard name -> checksums of its makers
        self.results: dict[str, str] = {}  # digest of each result written by a run -> file name
        self.rows: dict[tuple[str, int], Rows] = {}  # (part, block) -> rows

    def __contains__(self, record: Record) -> bool:
        """Return whether a shard holds this record."""
        key, block = record
        return any((part, block) in self.rows for part, _ in self.tasks.get(key, ()))

    def find(self, record: Record) -> tuple[str, int]:
        """Return the shard of a record and its row there. Raises KeyError for a missing record."""
        key, block = record
        for part, number in self.tasks[key]:
            if (part, block) in self.rows:
                shard, first, step = self.rows[part, block]
                return shard, first + number * step
        raise KeyError(record)

    def makers_of(self, blocks: Mapping[str, int]) -> set[Maker]:
        """Return the makers of the stored records. blocks : number of blocks by key of the task."""
        part_blocks: dict[str, int] = {}
        for key, count in blocks.items():
            for part, _ in self.tasks.get(key, ()):
                part_blocks[part] = max(count, part_blocks.get(part, 0))
        shards = {
            rows.shard
            for (part, block), rows in self.rows.items()
            if block < part_blocks.get(part, 0)
        }
        return {self.makers[maker] for name in shards for maker in self.makers_of_shard[name]}

    def entries_of(
        self,
        name: str,
        size: int,
        batches: list[StoredBatch],
        makers: list[Maker],
        predicted: float,
    ) -> list[Entry]:
        """Return the entries of new makers and parts, followed by the entry of the shard."""
        new: dict[str, Entry] = {}
        checksums = [digest("\n".join(maker).encode()) for maker in makers]
        for checksum, maker in zip(checksums, makers, strict=True):
            if checksum not in self.makers:
                new[checksum] = {"maker": checksum, **maker._asdict()}
        table, count = [], 0
        for batch in batches:
            keys = "".join(batch.keys)
            part = digest(keys.encode())
            if part not in self.parts:
                new[part] = {"part": part, "keys": keys}
            table.append([part, batch.first_block, batch.blocks])
            count += len(batch.keys) * batch.blocks
        shard = {"shard": name, "bytes": size, "records": count, "predicted": predicted}
        return [*new.values(), shard | {"chunks": table, "by": checksums}]

    def replay(self, entry: Entry) -> None:
        """Apply one entry of the journal."""
        if "part" in entry:
            self._add_part(entry["part"], entry["keys"])
        elif "maker" in entry:
            self.makers[entry["maker"]] = Maker(entry["versions"], entry["processor"])
        elif "shard" in entry:
            self._add_shard(entry)
        elif "failed" in entry:
            self.failed[entry["failed"]] = entry["why"]
        elif "retry" in entry:
            self.failed.pop(entry["retry"], None)
        elif "result" in entry:
            self.results[entry["digest"]] = entry["result"]
        elif "dropped" in entry:
            self.sizes.pop(entry["dropped"], None)
            self.makers_of_shard.pop(entry["dropped"], None)
            self.rows = {k: rows for k, rows in self.rows.items() if rows.shard != entry["dropped"]}

    def _add_part(self, part: str, keys: str) -> None:
        if part in self.parts or not keys or part != digest(keys.encode()):
            return  # already known, empty, or its checksum is wrong
        names = [keys[i : i + KEY_LENGTH] for i in range(0, len(keys), KEY_LENGTH)]
        self.parts[part] = names
        for number, key in enumerate(names):
            self.tasks.setdefault(key, []).append((part, number))

    def _add_shard(self, entry: Entry) -> None:
        """Add a shard. Raises ValueError or TypeError for an entry that contradicts itself."""
        name, batches, makers = entry["shard"], entry["chunks"], entry.get("by", [])
        numbers = [number for _, *both in batches for number in both]
        if not all(isinstance(number, int) for number in [*numbers, entry["bytes"]]):
            raise TypeError("its numbers are not integers")
        if any(first_block < 0 or blocks < 1 for _, first_block, blocks in batches):
            raise ValueError("it has a batch without blocks")
        parts_known = all(part in self.parts for part, *_ in batches)
        if not (parts_known and self.makers.keys() >= set(makers)):
            return  # the line of a part or maker is damaged: ``Store.prepare`` reads the shard
        records = sum(len(self.parts[part]) * blocks for part, _, blocks in batches)
        if records != entry["records"] or records * MIN_RECORD_BYTES > entry["bytes"]:
            raise ValueError(
                f"{records} records, not {entry['records']}, in {entry['bytes']} bytes"
            )
        self.sizes[name], self.makers_of_shard[name] = entry["bytes"], makers
        if self.files.get(name) != entry["bytes"]:
            return  # missing, cut, or a false line, whose blocks the file need not hold
        first = 0
        for part, first_block, blocks in batches:
            for row in range(blocks):
                self.rows[part, first_block + row] = Rows(name, first + row, blocks)
            first += len(self.parts[part]) * blocks


def shard_files(folder: Path) -> dict[str, int]:
    """Return the bytes of the shards in a folder, by name. Raises UserError like ``sizes_in``."""
    sizes = sizes_in(folder)
    return shard_sizes(sizes, NETCDF_SUFFIX) | shard_sizes(sizes)


def indexed(folder: Path) -> Index:
    """Return the index of the journal of a folder. Raises UserError like ``journal.entries``."""
    listed = [entry for entry, _ in entries(folder)]
    index = Index(shard_files(folder))  # after the journal, so that a listed shard is there
    for entry in listed:
        with contextlib.suppress(TypeError, ValueError):  # skipped like a damaged line
            index.replay(entry)
    return index
