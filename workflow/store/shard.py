"""A shard: the block means of many finished batches as the bytes of one netCDF file.

It tells by itself what it holds, and what computed it. Bytes are built and read in memory, so that
HDF5 takes no lock and sees no full disk; the name of a shard is the checksum of its bytes.
"""

import hashlib
import json
import math
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
KEY_LENGTH = 2 * KEY_BYTES  # as text

ARRAYS = {  # name -> type, dims; "chunk" is a batch: the word of earlier stores
    "chunk": ("i8", "chunk", "extent"),
    "key": ("u1", "task", "byte"),
    "scalars": ("f8", "record", "value"),
    "curves": ("f8", "record", "sample"),
}
SIZES = {"extent": 3, "byte": KEY_BYTES, "value": len(SCALARS)}

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
    arrays: dict[str, np.ndarray] = {
        "chunk": table,
        "key": np.frombuffer(keys, np.uint8).reshape(-1, KEY_BYTES),
        "scalars": np.concatenate(scalars),
        "curves": np.concatenate(curves),
    }
    for name, (kind, *dims) in ARRAYS.items():
        for dim, size in zip(dims, arrays[name].shape, strict=True):
            if dim not in data.dimensions:
                data.createDimension(dim, size)
        data.createVariable(name, kind, dims, fill_value=False)[:] = arrays[name]
    return bytes(data.close())


def decode(name: str, content: bytes, unreadable: str = "") -> Contents:
    """Return what a shard of this name holds by its bytes.

    unreadable : why they cannot be read, where that was tried before: HDF5 opens them no more.
    Raises NoShard for what another program or version has written, and ValueError for damage and
    for what contradicts itself. No more is read than the bytes hold.
    """
    version = re.search(KIND.encode() + rb"[0-9]+", content)  # HDF5 must not read what is spoilt
    if version and version[0] != FORMAT.encode():
        raise NoShard(f"is of another version of the format ({version[0].decode()}, not {FORMAT})")
    if digest(content) != name:
        raise ValueError("its content does not match the checksum in its name")
    if not version:
        raise NoShard("is no shard of this program")
    try:
        if unreadable:
            raise OSError(unreadable)
        with netCDF4.Dataset("shard.nc", memory=content) as data:
            data.set_auto_maskandscale(False)
            _check_arrays(data, len(content))
            makers = [Maker(*map(_text, maker)) for maker in json.loads(data.makers)]
            table, keys = data["chunk"][:].tolist(), bytes(data["key"][:]).hex()
            scalars, curves = data["scalars"][:], data["curves"][:]
        _check_extents(table, len(keys) // KEY_LENGTH, len(scalars))
    except (OSError, RuntimeError, AttributeError, LookupError, TypeError, ValueError) as error:
        raise ValueError(f"it is not made as a shard is: {error}") from error
    names = (keys[i : i + KEY_LENGTH] for i in range(0, len(keys), KEY_LENGTH))
    batches = [StoredBatch(tuple(islice(names, tasks)), *blocks) for tasks, *blocks in table]
    records = [(key, b.first_block + i) for b in batches for key in b.keys for i in range(b.blocks)]
    return Contents(batches, makers, records, scalars, curves)


def _check_arrays(data: netCDF4.Dataset, size: int) -> None:
    """Raise ValueError for arrays of other types or shapes than a shard of so many bytes has."""
    held = 0
    for name, (kind, *dims) in ARRAYS.items():
        found = data[name]
        extents = dict(zip(found.dimensions, found.shape, strict=True))
        if found.datatype != np.dtype(kind) or extents != {
            d: SIZES.get(d, extents.get(d)) for d in dims
        }:
            raise ValueError(f"{name} is {found.datatype} of {extents}")
        held += math.prod(map(int, found.shape)) * found.datatype.itemsize
    if held > size:
        raise ValueError(f"it tells of {held} bytes, and has {size}")


def _check_extents(table: list[list[int]], tasks: int, records: int) -> None:
    """Raise ValueError where batches do not come to the tasks and records that there are."""
    least = all(many > 0 and first >= 0 and blocks > 0 for many, first, blocks in table)
    told = sum(row[0] for row in table), sum(many * blocks for many, _, blocks in table)
    if not least or told != (tasks, records):
        raise ValueError(f"it tells of (tasks, records) {told}, and has {(tasks, records)}")


def _text(value: object) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{value!r:.40} is no text")
    return value


def shard_sizes(sizes: dict[str, int]) -> dict[str, int]:
    """Return name of a shard -> bytes, of those files in a folder that are named as shards are."""
    found = ((re.fullmatch(r"([0-9a-f]{32})\.nc", name), size) for name, size in sizes.items())
    return {match[1]: size for match, size in found if match}
