"""A shard: the block means of many finished batches as the bytes of one netCDF file.

It tells by itself what it holds, and what computed it. Bytes are built and read in memory, so that
HDF5 takes no lock and sees no full disk; the name of a shard is the checksum of its bytes.
"""

import hashlib
import json
import re
from itertools import islice
from typing import NamedTuple

import netCDF4
import numpy as np

from ..simulate import SCALARS, Batch, BatchResult, Record
from ..system import Maker

KIND = "elastomer-friction shard "
FORMAT = KIND + "3"
KEY_BYTES = 16

Finished = list[tuple[Batch, BatchResult]]


class StoredBatch(NamedTuple):
    """What a shard holds of a batch: records in the order (task, block)."""

    keys: tuple[str, ...]
    first_block: int
    blocks: int


class Contents(NamedTuple):
    """What a shard holds; records of its batches one after the other."""

    batches: list[StoredBatch]
    makers: list[Maker]  # what computed them
    records: list[Record]  # which each row holds
    scalars: np.ndarray  # shape (records, len(SCALARS))
    curves: np.ndarray  # shape (records, curve_samples); NaN beyond the samples of a record


class NoShard(Exception):
    """A file that is as it was written, but by another program, or another version of this one."""


def digest(content: bytes) -> str:
    """Return the checksum of a shard (hexadecimal)."""
    return hashlib.sha256(content).hexdigest()[:32]


def stored_batch(batch: Batch) -> StoredBatch:
    """Return what a shard holds of a batch."""
    return StoredBatch(tuple(task.key for task in batch.tasks), batch.first_block, batch.blocks)


def encode(finished: Finished) -> bytes:
    """Return the bytes of a shard holding finished batches."""
    curve_samples = max(result.curves.shape[2] for _, result in finished)
    scalars = [result.scalars.reshape(-1, len(SCALARS)) for _, result in finished]
    curves = []
    for _, result in finished:
        rows = result.curves.reshape(-1, result.curves.shape[2])
        missing = curve_samples - rows.shape[1]
        curves.append(np.pad(rows, ((0, 0), (0, missing)), constant_values=np.nan))
    stored = [stored_batch(batch) for batch, _ in finished]
    table = np.array([(len(s.keys), s.first_block, s.blocks) for s in stored], dtype=np.int64)
    keys = bytes.fromhex("".join(key for batch in stored for key in batch.keys))
    data = netCDF4.Dataset("shard.nc", "w", memory=4096)
    data.format = FORMAT
    data.makers = json.dumps(sorted({result.maker for _, result in finished}))
    for name, dims, values in (
        ("chunk", ("chunk", "extent"), table),  # of batches: the word of earlier stores
        ("key", ("task", "byte"), np.frombuffer(keys, np.uint8).reshape(-1, KEY_BYTES)),
        ("scalars", ("record", "value"), np.concatenate(scalars)),
        ("curves", ("record", "sample"), np.concatenate(curves)),
    ):
        for dim, size in zip(dims, values.shape, strict=True):
            if dim not in data.dimensions:
                data.createDimension(dim, size)
        data.createVariable(name, values.dtype, dims, fill_value=False)[:] = values
    return bytes(data.close())


def decode(name: str, content: bytes) -> Contents:
    """Return what a shard of this name holds by its bytes.

    Raises NoShard for what another program or version has written, ValueError for damage.
    """
    sound = digest(content) == name
    version = re.search(KIND.encode() + rb"[0-9]+", content)  # HDF5 must not read what is spoilt
    if version and version[0] != FORMAT.encode():
        raise NoShard(f"is of another version of the format ({version[0].decode()}, not {FORMAT})")
    if not sound:
        raise ValueError("its content does not match the checksum in its name")
    try:
        with netCDF4.Dataset("shard.nc", memory=content) as data:
            data.set_auto_mask(False)
            makers = [Maker(*maker) for maker in json.loads(data.makers)]
            table, keys = data["chunk"][:].tolist(), bytes(data["key"][:]).hex()
            scalars, curves = data["scalars"][:], data["curves"][:]
    except (OSError, RuntimeError, AttributeError, LookupError, TypeError, ValueError) as error:
        raise NoShard(f"is no shard of this program ({error})") from error
    width = 2 * KEY_BYTES
    names = (keys[i : i + width] for i in range(0, len(keys), width))
    batches = [StoredBatch(tuple(islice(names, tasks)), *blocks) for tasks, *blocks in table]
    records = [(key, b.first_block + i) for b in batches for key in b.keys for i in range(b.blocks)]
    return Contents(batches, makers, records, scalars, curves)


def shard_sizes(sizes: dict[str, int]) -> dict[str, int]:
    """Return name of a shard -> bytes, of those files in a folder that are named as shards are."""
    found = ((re.fullmatch(r"([0-9a-f]{32})\.nc", name), size) for name, size in sizes.items())
    return {match[1]: size for match, size in found if match}
