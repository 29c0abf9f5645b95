"""Join two stores: what another one holds is taken over, shard by shard, as it is."""

from functools import partial
from pathlib import Path

from ..errors import UserError
from ..system import hold, read_whole, sizes_in, write_durably
from . import journal
from .shard import Contents, NoShard, decode, shard_sizes
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
        names = sorted(shard_sizes(sizes_in(source)))
        for name in names:
            content = read_whole(source / f"{name}.nc")
            try:
                contents = decode(name, content)
            except (NoShard, ValueError) as error:
                said.append(f"left out    {name}.nc: {error}")
                continue
            known = [row for row, record in enumerate(contents.records) if record in into]
            differing += _differing(into, contents, known)
            fresh = len(contents.records) - len(known)
            if fresh:
                into.patience(partial(write_durably, into.folder / f"{name}.nc", content))
                into.enter(name, len(content), contents.batches, contents.makers)
                taken, records = taken + 1, records + fresh
    if differing:
        said.append(f"differing   {differing} records are in both, but not to the bit")
    return [*said, f"taken over  {taken} of {len(names)} shards, {records} records that are new"]


def _differing(into: Store, contents: Contents, rows: list[int]) -> int:
    """Return how many records of a shard, at some rows, a store holds with other bits."""
    width = contents.curves.shape[1]
    count = 0
    for row in rows:
        try:
            scalars, curves = into.read([contents.records[row]], width)
        except DamagedShard:
            continue  # the one to be kept then is that of the source
        ours = scalars.tobytes(), curves.tobytes()
        count += ours != (contents.scalars[row].tobytes(), contents.curves[row].tobytes())
    return count
