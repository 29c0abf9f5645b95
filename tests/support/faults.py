"""Damaged file contents, and checks that records in a store are correct or missing."""

import contextlib
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import netCDF4

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.simulate.tasks import Record
from elastomer_friction.workflow.store.store import DamagedShard, Store
from tests.support.shards import SAMPLES, WORK, held, records, reopened
from tests.support.small import random_result

Damage = Callable[[bytes], bytes]

SHARDS = (WORK[:2], WORK[2:3], WORK[3:4])  # batches of each shard
TRUTH = {
    record: random_result(batch, seed)
    for seed, batch in enumerate(WORK[:4])
    for record in records(batch)
}


def foreign(_: bytes) -> bytes:
    """Return a netCDF file of another program."""
    data = netCDF4.Dataset("foreign.nc", "w", memory=1024)
    data.createDimension("x", 3)
    return bytes(data.close())


DAMAGE: dict[str, Damage] = {
    "empty": lambda _: b"",
    "a tenth": lambda content: content[: len(content.rstrip(b"\0")) // 10],
    "half": lambda content: content[: len(content.rstrip(b"\0")) // 2],
    "all but the last bytes": lambda content: content.rstrip(b"\0")[:-100],
    "zeros": lambda content: bytes(len(content)),
    "text": lambda _: b"not netCDF at all\n",
    "of another program": foreign,
}


def flipped(content: bytes, place: int, mask: int = 1) -> bytes:
    """Return the content with some bits of one byte flipped."""
    return content[:place] + bytes([content[place] ^ mask]) + content[place + 1 :]


def prefixes(content: bytes, stride: int) -> list[bytes]:
    """Return the content cut at every ``stride``-th byte."""
    return [content[:length] for length in range(0, len(content), stride)]


def flips(content: bytes, stride: int) -> list[bytes]:
    """Return copies of the content with one byte in ``stride`` flipped: one bit, or all bits."""
    return [
        flipped(content, place, 0xFF if place // stride % 2 else 1 << place % 8)
        for place in range(0, len(content), stride)
    ]


def fill(store: Store) -> None:
    """Store all shards, in order."""
    for work in SHARDS:
        store.add([(batch, TRUTH[records(batch)[0]]) for batch in work])


def checked(store: Store) -> set[Record]:
    """Assert that every record in a store equals TRUTH; return the records that are present."""
    actual = set()
    for record in held(store):
        with contextlib.suppress(DamagedShard, UserError):
            if record not in store:
                continue  # dropped with a damaged shard
            scalars, curves = store.read([record], SAMPLES)
            assert scalars.tobytes() == TRUTH[record].scalars.tobytes()
            assert curves.tobytes() == TRUTH[record].curves.tobytes()
            actual.add(record)
    return actual


def readable(folder: Path) -> set[Record]:
    """Check a store as opened by a reader, and by a run that repairs it; return its records."""
    untouched = folder.with_name("untouched")
    shutil.rmtree(untouched, ignore_errors=True)
    shutil.copytree(folder, untouched)
    checked(Store(untouched))
    mended = reopened(folder)
    actual = checked(mended)
    assert checked(Store(folder)) == actual  # the next reader sees the same records
    return actual


def copies(sound: Path, path: Path, contents: list[bytes]) -> Iterator[Path]:
    """Yield a copy of a store for each of the contents of one of its files."""
    for content in contents:
        folder = sound.with_name("spoilt")
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(sound, folder)
        (folder / path.name).write_bytes(content)
        yield folder


def endless(content: bytes) -> bytes:
    """Return a netCDF file whose first object in the global heap leads to itself.

    The HDF5 library steps from object to object by their lengths, and this one is an endless loop.
    """
    at = content.index(b"GCOL") + 16 + 8  # after the header and the number of the object
    return content[:at] + (2**64 - 16).to_bytes(8, "little") + content[at + 8 :]
