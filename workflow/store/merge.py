"""Join two stores: what another one holds is taken over, shard by shard, as it is."""

import contextlib
from functools import partial
from pathlib import Path

import numpy as np

from ..ground import UserError
from ..system import hold, read_whole, sizes_in, unreadable, write_durably
from . import journal
from .shard import Contents, NoShard, decode, digest, shard_sizes
from .store import DamagedShard, Store


def merge_into(source: Path, target: Path, *, no_lock: bool = False) -> list[str]:
    """Take over into the store ``target`` what ``source`` holds; return what to print.

    The source is left as it is: what is damaged there is named and left out, and so is what failed
    there, which the next run tries again. Raises UserError for a target in use, and where a disk
    refuses.
    """
    if target.exists() and source.samefile(target):
        raise UserError(f"{source}: cannot be joined with itself")
    for _ in journal.entries(source):
        pass  # a journal of another version is refused
    with hold(target, without=no_lock):
        into = Store(target)
        into.prepare()
        into.begin("merge")
        said, taken, records, differing = [], 0, 0, 0
        paths = {name: source / f"{name}.nc" for name in sorted(shard_sizes(sizes_in(source)))}
        other = {n: path for n, path in paths.items() if not _is_there(into, n, read_whole(path))}
        tried = unreadable([*other.values()])
        for name, path in other.items():
            content = read_whole(path)
            try:
                contents = decode(name, content, tried.get(path, ""))
            except (NoShard, ValueError) as error:
                said.append(f"left out    {name}.nc: {error}")
                continue
            shared, unlike = _compared(into, contents)
            differing += unlike
            if fresh := len(contents.records) - shared:
                into.retry(partial(write_durably, into.folder / f"{name}.nc", content))
                into.enter(name, len(content), contents.batches, contents.makers)
                taken, records = taken + 1, records + fresh
    if differing:
        said.append(f"differing   {differing} records are in both, but not to the bit")
    return [*said, f"taken over  {taken} of {len(paths)} shards, {records} records that are new"]


def _is_there(into: Store, name: str, content: bytes) -> bool:
    """Return whether a store holds a shard, sound and byte for byte."""
    there = name in into.index.sizes and content == read_whole(into.folder / f"{name}.nc")
    return there and digest(content) == name


def _compared(into: Store, contents: Contents) -> tuple[int, int]:
    """Return how many records of a shard a store holds, and how many of these with other bits."""
    while True:
        rows = [row for row, record in enumerate(contents.records) if record in into]
        theirs = contents.scalars[rows], contents.curves[rows]
        with contextlib.suppress(DamagedShard):  # what was damaged is no longer there
            ours = into.read([contents.records[row] for row in rows], contents.curves.shape[1])
            unlike = [
                (a.view("i8") != b.view("i8")).any(axis=1)
                for a, b in zip(ours, theirs, strict=True)
            ]
            return len(rows), int(np.sum(unlike[0] | unlike[1]))
