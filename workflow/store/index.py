"""The index of a store: which shard holds which record, and which tasks failed for good.

It follows from the entries of the journal alone, one after the other. Records are found by
(key of the task, block). The keys of tasks that stay together, a part, are told once and known by
their checksum, and so is what computed records, their maker: what a line means depends on nothing
but the line itself, so that lines told twice, as by two joined journals, change nothing.
"""

import contextlib
from collections.abc import Mapping
from pathlib import Path

from ..simulate import SCALARS, Record
from ..system import Maker
from .journal import Entry, entries
from .shard import KEY_LENGTH, StoredBatch, digest

LEAST_BYTES = 8 * len(SCALARS)  # of a record


class Index:
    """Where records are, as the journal tells it."""

    def __init__(self) -> None:
        self.sizes: dict[str, int] = {}  # name of each shard -> bytes
        self.failed: dict[str, str] = {}  # key of each task that failed for good -> why
        self.parts: dict[str, list[str]] = {}  # checksum of the keys of a part -> they themselves
        self.rows: dict[str, list[tuple[str, int]]] = {}  # key -> parts it is in, row in each
        self.makers: dict[str, Maker] = {}  # by checksum
        self.made: dict[str, list[str]] = {}  # name of each shard -> its makers
        self.results: dict[str, str] = {}  # digest of each result that a run wrote -> file name
        # (part, block) -> shard, position of row 0 there, positions from a row to the next
        self.found: dict[tuple[str, int], tuple[str, int, int]] = {}

    def __contains__(self, record: Record) -> bool:
        """Return whether a shard holds a record."""
        key, block = record
        return any((part, block) in self.found for part, _ in self.rows.get(key, ()))

    def find(self, record: Record) -> tuple[str, int]:
        """Return (shard, position in it) of a record. Raises KeyError where none holds it."""
        key, block = record
        for part, row in self.rows[key]:
            if (part, block) in self.found:
                shard, first, step = self.found[part, block]
                return shard, first + row * step
        raise KeyError(record)

    def makers_of(self, blocks: Mapping[str, int]) -> set[Maker]:
        """Return what computed the records that there are of so many blocks of each task."""
        most: dict[str, int] = {}  # blocks of each part
        for key, count in blocks.items():
            for part, _ in self.rows.get(key, ()):
                most[part] = max(count, most.get(part, 0))
        there = self.found.items()
        shards = {found[0] for (part, block), found in there if block < most.get(part, 0)}
        return {self.makers[maker] for name in shards for maker in self.made[name]}

    def entries_of(
        self,
        name: str,
        size: int,
        batches: list[StoredBatch],
        makers: list[Maker],
        predicted: float,
    ) -> list[Entry]:
        """Return what the journal is to say of a shard, after what it is the first to have."""
        first: dict[str, Entry] = {}
        by = [digest("\n".join(maker).encode()) for maker in makers]
        for known, maker in zip(by, makers, strict=True):
            if known not in self.makers:
                first[known] = {"maker": known, **maker._asdict()}
        table, count = [], 0
        for batch in batches:
            keys = "".join(batch.keys)
            part = digest(keys.encode())
            if part not in self.parts:
                first[part] = {"part": part, "keys": keys}
            table.append([part, batch.first_block, batch.blocks])
            count += len(batch.keys) * batch.blocks
        shard = {"shard": name, "bytes": size, "records": count, "predicted": predicted}
        return [*first.values(), shard | {"chunks": table, "by": by}]

    def replay(self, entry: Entry) -> None:
        """Take one entry of the journal into the index."""
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
            self.made.pop(entry["dropped"], None)
            gone = [where for where, found in self.found.items() if found[0] == entry["dropped"]]
            for where in gone:
                del self.found[where]

    def _add_part(self, part: str, keys: str) -> None:
        if part in self.parts or part != digest(keys.encode()):
            return  # told before, or not what it says it is
        names = [keys[i : i + KEY_LENGTH] for i in range(0, len(keys), KEY_LENGTH)]
        self.parts[part] = names
        for row, key in enumerate(names):
            self.rows.setdefault(key, []).append((part, row))

    def _add_shard(self, entry: Entry) -> None:
        """Take in what a line tells of a shard. Raises ValueError, or TypeError, for nonsense."""
        name, batches, by = entry["shard"], entry["chunks"], entry.get("by", [])
        if any(first_block < 0 or blocks < 1 for _, first_block, blocks in batches):
            raise ValueError("no such blocks")
        if any(part not in self.parts for part, *_ in batches) or not self.makers.keys() >= set(by):
            return  # the line of a part or a maker is spoilt: the shard itself tells them
        records = sum(len(self.parts[part]) * blocks for part, _, blocks in batches)
        if records != entry["records"] or records * LEAST_BYTES > entry["bytes"]:
            raise ValueError(
                f"{records} records, not {entry['records']}, in {entry['bytes']} bytes"
            )
        self.sizes[name], self.made[name] = entry["bytes"], by
        first = 0
        for part, first_block, blocks in batches:
            for row in range(blocks):
                self.found[part, first_block + row] = name, first + row, blocks
            first += len(self.parts[part]) * blocks


def indexed(folder: Path) -> Index:
    """Return what the journal of a folder tells. Raises UserError as ``journal.entries``."""
    index = Index()
    for entry, _ in entries(folder):
        with contextlib.suppress(TypeError, ValueError):  # as a line that is spoilt
            index.replay(entry)
    return index
