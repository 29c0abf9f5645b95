"""Verification of a store: every journal line, every shard and every key. It changes nothing."""

from collections import defaultdict
from pathlib import Path

from ..ground import UserError
from ..system import LOCK, digest_of, read_whole, sizes_in
from . import journal
from .index import Index, Rows, shard_files
from .netcdf_shard import NETCDF_SUFFIX
from .shard import SHARD_SUFFIX, Contents, ForeignFile, decode, shard_path, shard_sizes


def holds_a_store(folder: Path) -> bool:
    """Return whether a folder holds a store, that is, a journal or any shards."""
    sizes = sizes_in(folder)
    return (folder / journal.NAME).is_file() or any(
        shard_sizes(sizes, suffix) for suffix in (SHARD_SUFFIX, NETCDF_SUFFIX)
    )


class Verification:
    """Result of verifying a store: counts, faults and notes."""

    def __init__(self, folder: Path) -> None:
        """Verify the store in ``folder``. Raises UserError if it cannot be read."""
        self.folder, self.index = folder, Index(shard_files(folder))
        self.faults: list[str] = []  # losses, damage and contradictions
        self.notes: list[str] = []  # unusual but allowed states
        self.journal_lines, self.records = 0, 0  # numbers
        self.keys: set[str] = set()  # keys of the problems in valid shards
        self._read_journal()
        self.entered: dict[str, list[tuple[str, int, Rows]]] = defaultdict(list)  # by shard
        for (part, block), rows in self.index.rows.items():
            self.entered[rows.shard].append((part, block, rows))
        files = sizes_in(folder)
        shards = sorted(shard_sizes(files))
        self.shards = len(shards)
        self.undamaged = sum(self._is_undamaged(name) for name in shards)
        listed = sorted({folder.parent / name for name in self.index.results.values()})
        self.results = [path for path in listed if path.is_file()]
        edited = [path for path in self.results if digest_of(path) not in self.index.results]
        self.faults += [f"{path}: was changed or replaced since a run wrote it" for path in edited]
        self._check_file_names(files, shards)

    def lines(self) -> list[str]:
        """Return the lines of the report."""
        makers = sorted(self.index.makers.values())
        return [
            f"store       {self.folder}",
            f"journal     {self.journal_lines} lines",
            f"shards      {self.undamaged} of {self.shards} sound",
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
            pass  # only raises UserError for an unreadable journal or another format
        for number, line in enumerate(journal.lines(self.folder), 1):
            self.journal_lines = number
            entry = journal.entry_in(line)
            if entry is None:
                self.faults.append(f"{journal.NAME}, line {number}: spoilt")
                continue
            try:
                self.index.replay(entry)
            except (TypeError, ValueError) as error:
                self.faults.append(f"{journal.NAME}, line {number}: invalid ({error!r})")
        if not self.journal_lines:
            self.notes.append("the journal is missing or empty")

    def _check_file_names(self, files: dict[str, int], shards: list[str]) -> None:
        """Compare the files of the folder with the journal. shards : names of the .npz shards."""
        old = shard_sizes(files, NETCDF_SUFFIX)
        for name in sorted(self.index.sizes.keys() - set(shards) - old.keys()):
            self.faults.append(f"{name}{SHARD_SUFFIX}: missing, but listed in the journal")
        if old:
            self.notes.append(f"{len(old)} netCDF shards: the next run converts those of 0.3.0")
        known = {f"{name}{SHARD_SUFFIX}" for name in shards}
        known |= {f"{name}{NETCDF_SUFFIX}" for name in old}
        unknown = sorted(files.keys() - known - {journal.NAME, LOCK})
        self.notes += [f"{name}: not part of the store" for name in unknown]

    def _is_undamaged(self, name: str) -> bool:
        """Return whether a shard is valid and agrees with the journal; record faults and notes."""
        path = shard_path(self.folder, name)
        try:
            contents = decode(name, read_whole(path))
        except (UserError, ValueError) as error:
            self.faults.append(f"{path.name}: damaged ({error})")
            return False
        except ForeignFile as error:
            self.notes.append(f"{path.name}: {error}")
            return False
        self.records += len(contents.records)
        self.keys.update(key for key, _ in contents.records)
        contradiction = self._contradiction(name, contents)
        if contradiction:
            self.faults.append(f"{path.name}: {contradiction}")
        return not contradiction

    def _contradiction(self, name: str, contents: Contents) -> str:
        """Describe how a shard differs from its journal entry; return "" if it does not."""
        if name not in self.index.sizes:
            self.notes.append(
                f"{name}{SHARD_SUFFIX}: not listed in the journal; the next run enters it"
            )
            return ""
        if self.index.sizes[name] != self.index.files[name]:
            return f"is not of the {self.index.sizes[name]} bytes that the journal lists"
        for part, block, (_, first, step) in self.entered[name]:
            for number, key in enumerate(self.index.parts[part]):
                row = first + number * step
                if contents.records[row : row + 1] != [(key, block)]:
                    return f"does not hold block {block} of {key} where the journal lists it"
        makers = {self.index.makers[maker] for maker in self.index.makers_of_shard[name]}
        if makers != set(contents.makers):
            return "was computed by other makers than the journal lists"
        return ""
