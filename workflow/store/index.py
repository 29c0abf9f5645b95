"""The index of a store: which shard holds which record, and which tasks failed for good.

It follows from the entries of the journal alone, one after the other. Records are found by
(key of the task, block). The keys of tasks that stay together, a part, are told once and known by
their checksum: what a line means depends on nothing but the line itself, so that lines told twice,
as by two joined journals, change nothing.
"""

from workflow.simulate import Record
from workflow.store.journal import Entry
from workflow.store.shard import KEY_BYTES, StoredBatch, digest

KEY_LENGTH = 2 * KEY_BYTES


class Index:
    """Where records are, as the journal tells it."""

    def __init__(self) -> None:
        self.sizes: dict[str, int] = {}  # name of each shard -> bytes
        self.failed: dict[str, str] = {}  # key of each task that failed for good -> why
        self.parts: dict[str, int] = {}  # checksum of the keys of a part -> number of its tasks
        self.rows: dict[str, list[tuple[str, int]]] = {}  # key -> parts it is in, row in each
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

    def entries_of(
        self, name: str, size: int, batches: list[StoredBatch], times: dict[str, float]
    ) -> list[Entry]:
        """Return what the journal is to say of a shard, after the parts it is the first to have."""
        entries: dict[str, Entry] = {}
        table, count = [], 0
        for batch in batches:
            keys = "".join(batch.keys)
            part = digest(keys.encode())
            if part not in self.parts:
                entries[part] = {"part": part, "keys": keys}
            table.append([part, batch.first_block, batch.blocks])
            count += len(batch.keys) * batch.blocks
        shard = {"shard": name, "bytes": size, "records": count, "chunks": table, **times}
        return [*entries.values(), shard]

    def replay(self, entry: Entry) -> None:
        """Take one entry of the journal into the index."""
        if "part" in entry:
            self._add_part(entry["part"], entry["keys"])
        elif "shard" in entry:
            self._add_shard(entry["shard"], entry["bytes"], entry["chunks"])
        elif "failed" in entry:
            self.failed[entry["failed"]] = entry["why"]
        elif "retry" in entry:
            self.failed.pop(entry["retry"], None)
        elif "dropped" in entry:
            self.sizes.pop(entry["dropped"], None)
            gone = [where for where, found in self.found.items() if found[0] == entry["dropped"]]
            for where in gone:
                del self.found[where]

    def _add_part(self, part: str, keys: str) -> None:
        if part in self.parts or part != digest(keys.encode()):
            return  # told before, or not what it says it is
        names = [keys[i : i + KEY_LENGTH] for i in range(0, len(keys), KEY_LENGTH)]
        self.parts[part] = len(names)
        for row, key in enumerate(names):
            self.rows.setdefault(key, []).append((part, row))

    def _add_shard(self, name: str, size: int, batches: list[tuple[str, int, int]]) -> None:
        if any(part not in self.parts for part, _, _ in batches):
            return  # the line of a part is spoilt: the shard itself tells its keys
        self.sizes[name] = size
        first = 0
        for part, first_block, blocks in batches:
            for row in range(blocks):
                self.found[part, first_block + row] = name, first + row, blocks
            first += self.parts[part] * blocks
