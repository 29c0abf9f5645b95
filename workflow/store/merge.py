"""Merging of one store into another, shard by shard."""

import contextlib
from functools import partial
from pathlib import Path

import numpy as np

from ..ground import UserError
from ..system import hold, read_whole, sizes_in, unreadable, write_durably
from . import journal
from .netcdf_shard import NETCDF_SUFFIX, converted
from .shard import Contents, ForeignFile, decode, digest, shard_path, shard_sizes
from .store import DamagedShard, Store


def merge_into(source: Path, target: Path, *, no_lock: bool = False) -> list[str]:
    """Copy the records of the store ``source`` into the store ``target``; return lines to print.

    The source is not changed. Its damaged shards are reported and not copied. Its failed tasks are
    not copied either, so that the next run retries them. Raises UserError if the target is in use,
    or if a disk refuses.
    """
    if target.exists() and source.samefile(target):
        raise UserError(f"{source}: cannot be merged with itself")
    for _ in journal.entries(source):
        pass  # only raises UserError for a journal of another format
    with hold(target, without=no_lock):
        into = Store(target)
        into.prepare()
        into.begin("merge")
        lines, shards, records, differing = [], 0, 0, 0
        sizes = sizes_in(source)
        old = [source / f"{name}{NETCDF_SUFFIX}" for name in shard_sizes(sizes, NETCDF_SUFFIX)]
        faults = unreadable(old)
        paths = sorted([*old, *(shard_path(source, name) for name in shard_sizes(sizes))])
        for path in paths:
            name, content = path.stem, read_whole(path)
            try:
                if path.suffix == NETCDF_SUFFIX:
                    content = converted(name, content, faults.get(path, ""))
                    name = digest(content)
                if _holds(into, name, content):
                    continue
                contents = decode(name, content)
            except (ForeignFile, ValueError) as error:
                lines.append(f"left out    {path.name}: {error}")
                continue
            shared, unequal = _compared(into, contents)
            differing += unequal
            if new := len(contents.records) - shared:
                into.retry(partial(write_durably, shard_path(into.folder, name), content))
                into.enter(name, len(content), contents.batches, contents.makers)
                shards, records = shards + 1, records + new
    if differing:
        lines.append(f"differing   {differing} records are in both stores, with different bits")
    return [*lines, f"merged      {shards} of {len(paths)} shards, {records} new records"]


def _holds(store: Store, name: str, content: bytes) -> bool:
    """Return whether a store holds an undamaged shard of this name with the same bytes."""
    known = name in store.index.sizes and content == read_whole(shard_path(store.folder, name))
    return known and digest(content) == name


def _compared(store: Store, contents: Contents) -> tuple[int, int]:
    """Return the number of records in both the shard and the store, and the number that differ."""
    while True:
        rows = [row for row, record in enumerate(contents.records) if record in store]
        theirs = contents.scalars[rows], contents.curves[rows]
        with contextlib.suppress(DamagedShard):  # the store has repaired it: compare again
            ours = store.read([contents.records[row] for row in rows], contents.curves.shape[1])
            unequal = [
                (a.view("i8") != b.view("i8")).any(axis=1)
                for a, b in zip(ours, theirs, strict=True)
            ]
            return len(rows), int(np.sum(unequal[0] | unequal[1]))
