"""Check a store: every line of its journal, every shard, every key in it. Changes nothing."""

from collections import defaultdict
from pathlib import Path

from ..ground import UserError
from ..system import LOCK, digest_of, read_whole, sizes_in, unreadable
from . import journal
from .index import Index
from .shard import Contents, NoShard, decode, shard_sizes


def holds_a_store(folder: Path) -> bool:
    """Return whether there is a store in a folder: a journal, or shards without one."""
    return (folder / journal.NAME).is_file() or bool(shard_sizes(sizes_in(folder)))


class Verified:
    """What was found in a store."""

    def __init__(self, folder: Path) -> None:
        """Check the store in ``folder``. Raises UserError where the disk refuses to read it."""
        self.folder, self.index = folder, Index()
        self.faults: list[str] = []  # what is lost, spoilt or contradicts the rest
        self.notes: list[str] = []  # what may be as it is, but is worth a line
        self.lines_of_journal, self.records = 0, 0
        self.keys: set[str] = set()  # of the problems that sound shards hold
        self._read_journal()
        # Of a shard: position of row 0, from row to row, block, keys of rows.
        self.told: dict[str, list[tuple[int, int, int, list[str]]]] = defaultdict(list)
        for (part, block), (name, first, step) in self.index.found.items():
            self.told[name].append((first, step, block, self.index.parts[part]))
        sizes = sizes_in(folder)
        shards = shard_sizes(sizes)
        self.shards = len(shards)
        self.unreadable = unreadable([folder / f"{name}.nc" for name in sorted(shards)])
        self.sound = sum(self._is_sound(name) for name in sorted(shards))
        told = sorted({folder.parent / name for name in self.index.results.values()})
        self.results = [path for path in told if path.is_file()]
        edited = [path for path in self.results if digest_of(path) not in self.index.results]
        self.faults += [f"{path}: was changed or replaced since a run wrote it" for path in edited]
        missing = sorted(self.index.sizes.keys() - shards.keys())
        self.faults += [f"{name}.nc: missing, but told by the journal" for name in missing]
        ours = {f"{name}.nc" for name in shards} | {journal.NAME, LOCK}
        self.notes += [f"{name}: no part of the store" for name in sorted(sizes.keys() - ours)]

    def lines(self) -> list[str]:
        """Return what was found, line by line."""
        makers = sorted(self.index.makers.values())
        return [
            f"store       {self.folder}",
            f"journal     {self.lines_of_journal} lines",
            f"shards      {self.sound} of {self.shards} sound",
            f"records     {self.records} of {len(self.keys)} problems",
            *(f"computed    with {maker.versions}, on {maker.processor}" for maker in makers),
            f"failed      {len(self.index.failed)} problems",
            f"results     {len(self.results)}",
            *(f"note        {note}" for note in self.notes),
            *(f"fault       {fault}" for fault in self.faults),
            f"verified    {len(self.faults) or 'no'} faults",
        ]

    def _read_journal(self) -> None:
        for _ in journal.entries(self.folder):
            pass  # a journal of another version, or none that can be read, is refused
        for number, line in enumerate(journal.lines(self.folder), 1):
            self.lines_of_journal = number
            entry = journal.entry_in(line)
            if entry is None:
                self.faults.append(f"{journal.NAME}, line {number}: spoilt")
                continue
            try:
                self.index.replay(entry)
            except (TypeError, ValueError) as error:
                self.faults.append(f"{journal.NAME}, line {number}: not understood ({error!r})")
        if not self.lines_of_journal:
            self.notes.append("there is no journal, or it is empty")

    def _is_sound(self, name: str) -> bool:
        """Return whether a shard holds what it says and what the journal tells; note what not."""
        found = f"{name}.nc"
        path = self.folder / found
        try:
            contents = decode(name, read_whole(path), self.unreadable.get(path, ""))
        except (UserError, ValueError) as error:
            self.faults.append(f"{found}: damaged ({error})")
            return False
        except NoShard as error:
            self.notes.append(f"{found}: {error}")
            return False
        self.records += len(contents.records)
        self.keys.update(key for key, _ in contents.records)
        wrong = self._contradiction(name, contents)
        if wrong:
            self.faults.append(f"{found}: {wrong}")
        return not wrong

    def _contradiction(self, name: str, contents: Contents) -> str:
        """Return in what a shard is not what the journal tells of it, or nothing."""
        if name not in self.index.sizes:
            self.notes.append(f"{name}.nc: not told by the journal; the next run enters it")
            return ""
        for first, step, block, keys in self.told[name]:
            for row, key in enumerate(keys):
                at = first + row * step
                if contents.records[at : at + 1] != [(key, block)]:
                    return f"does not hold block {block} of {key} where the journal tells"
        if {self.index.makers[maker] for maker in self.index.made[name]} != set(contents.makers):
            return "was computed with something else than the journal tells"
        return ""
