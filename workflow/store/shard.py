"""Shards: block means of many finished batches in one .npz file.

A shard lists its batches and the makers of its records. Its name is the checksum of its bytes.
Equal records give equal bytes, since members are stored uncompressed with a fixed time stamp.
Reading a shard takes memory in proportion to the size of its file, whatever its headers claim.
"""

import hashlib
import io
import json
import math
import re
import zipfile
from collections.abc import Mapping
from itertools import islice
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.lib import format as npy

from ..ground import lacks_memory
from ..simulate import SCALARS, Batch, BatchResult, Record
from ..system import Maker

SHARD_FORMAT_NAME = "elastomer-friction shard "
SHARD_FORMAT = SHARD_FORMAT_NAME + "4"
SHARD_SUFFIX = ".npz"
KEY_BYTES = 16
KEY_LENGTH = 2 * KEY_BYTES  # number of hexadecimal digits
MEMBER_DATE = 1980, 1, 1, 0, 0, 0  # earliest time stamp that a zip archive can hold
NPY_VERSION = 1, 0

SHARD_ARRAYS: dict[
    str, tuple[str, tuple[int | None, ...]]
] = {  # name -> (type, shape); None: any length
    "format": ("|u1", (None,)),  # text in UTF-8
    "makers": ("|u1", (None,)),  # JSON in UTF-8
    "batches": ("<i8", (None, 3)),  # a row per batch: number of keys, first block, number of blocks
    "keys": ("|u1", (None, KEY_BYTES)),  # a row per task
    "scalars": ("<f8", (None, len(SCALARS))),  # a row per record
    "curves": ("<f8", (None, None)),  # a row per record
}

Finished = list[tuple[Batch, BatchResult]]


class StoredBatch(NamedTuple):
    """Records of one batch in a shard, sorted by task, then by block."""

    keys: tuple[str, ...]  # keys of the tasks
    first_block: int
    blocks: int


class Contents(NamedTuple):
    """Content of a shard: the records of its batches in order."""

    batches: list[StoredBatch]
    makers: list[Maker]
    records: list[Record]  # record in each row of the arrays
    scalars: np.ndarray  # shape (records, len(SCALARS))
    curves: np.ndarray  # shape (records, curve_samples); NaN beyond the samples of a record


class ForeignFile(Exception):
    """An undamaged file of another program, or of another version of this one."""


def digest(content: bytes) -> str:
    """Return the hexadecimal checksum of the bytes of a shard."""
    return hashlib.sha256(content).hexdigest()[:32]


def stored_batch(batch: Batch) -> StoredBatch:
    """Return the keys and blocks of a batch."""
    return StoredBatch(tuple(task.key for task in batch.tasks), batch.first_block, batch.blocks)


def encode(finished: Finished) -> bytes:
    """Encode finished batches as the bytes of a shard."""
    curve_samples = max(result.curves.shape[2] for _, result in finished)
    scalars = [result.scalars.reshape(-1, len(SCALARS)) for _, result in finished]
    curves = []
    for _, result in finished:
        rows = result.curves.reshape(-1, result.curves.shape[2])
        missing = curve_samples - rows.shape[1]
        curves.append(np.pad(rows, ((0, 0), (0, missing)), constant_values=np.nan))
    batches = [stored_batch(batch) for batch, _ in finished]
    keys = bytes.fromhex("".join(key for batch in batches for key in batch.keys))
    return packed(
        {
            "makers": text_array(json.dumps(sorted({result.maker for _, result in finished}))),
            "batches": np.array([(len(b.keys), b.first_block, b.blocks) for b in batches]),
            "keys": np.frombuffer(keys, np.uint8).reshape(-1, KEY_BYTES),
            "scalars": np.concatenate(scalars),
            "curves": np.concatenate(curves),
        }
    )


def text_array(text: str) -> np.ndarray:
    """Return the UTF-8 bytes of a text as an array."""
    return np.frombuffer(text.encode(), np.uint8)


def packed(arrays: Mapping[str, np.ndarray]) -> bytes:
    """Return the bytes of a shard with these arrays and the array "format"."""
    arrays = {"format": text_array(SHARD_FORMAT), **arrays}
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name, (kind, _) in SHARD_ARRAYS.items():
            member = zipfile.ZipInfo(f"{name}.npy", MEMBER_DATE)
            with archive.open(member, "w", force_zip64=True) as file:
                values = arrays[name].astype(kind, order="C", casting="equiv", copy=False)
                npy.write_array(file, values, NPY_VERSION, allow_pickle=False)
    return buffer.getvalue()


def decode(name: str, content: bytes) -> Contents:
    """Decode the bytes of the shard ``name``.

    Raises ForeignFile for a file of another program or version, and ValueError if the shard is
    damaged or inconsistent.
    """
    version = re.search(SHARD_FORMAT_NAME.encode() + rb"[0-9]+", content)
    if version and version[0] != SHARD_FORMAT.encode():
        raise ForeignFile(f"has another format ({version[0].decode()}, not {SHARD_FORMAT})")
    if digest(content) != name:
        raise ValueError("its content does not match the checksum in its name")
    if not version:
        raise ForeignFile("is not a shard of this program")
    try:
        arrays = _unpacked(content)
        makers = [Maker(*maker) for maker in json.loads(bytes(arrays["makers"]))]
        if not all(isinstance(text, str) for maker in makers for text in maker):
            raise ValueError("a maker is not text")
        table, keys = arrays["batches"].tolist(), bytes(arrays["keys"]).hex()
        scalars, curves = arrays["scalars"], arrays["curves"]
        _check_counts(table, len(keys) // KEY_LENGTH, len(scalars), len(curves))
    except Exception as error:  # a forged file can cause any exception in these calls
        if lacks_memory(error):
            raise  # the shard may be sound
        reason = " ".join(str(error).split())
        raise ValueError(f"it is not a valid shard: {reason:.200}") from error
    names = (keys[i : i + KEY_LENGTH] for i in range(0, len(keys), KEY_LENGTH))
    batches = [StoredBatch(tuple(islice(names, tasks)), *blocks) for tasks, *blocks in table]
    records = [(key, b.first_block + i) for b in batches for key in b.keys for i in range(b.blocks)]
    return Contents(batches, makers, records, scalars, curves)


def _unpacked(content: bytes) -> dict[str, np.ndarray]:
    """Return the arrays of a shard, which are read-only.

    Raises ValueError for other members, types or shapes.
    """
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        members = archive.infolist()
        names = [member.filename for member in members]
        if names != [f"{name}.npy" for name in SHARD_ARRAYS]:
            raise ValueError(f"its members are {', '.join(names):.200}")
        if any(member.compress_type != zipfile.ZIP_STORED for member in members):
            raise ValueError("it is compressed")
        return {name: _array(name, archive.read(f"{name}.npy")) for name in SHARD_ARRAYS}


def _array(name: str, content: bytes) -> np.ndarray:
    """Return a member of a shard as an array in the memory of ``content``, without allocation."""
    file = io.BytesIO(content)
    if (version := npy.read_magic(file)) != NPY_VERSION:
        raise ValueError(f"{name} has the npy version {version}")
    shape, fortran_order, dtype = npy.read_array_header_1_0(file)
    kind, lengths = SHARD_ARRAYS[name]
    fits = len(shape) == len(lengths) and all(
        length in (None, size) for length, size in zip(lengths, shape, strict=True)
    )
    if dtype != np.dtype(kind) or fortran_order or not fits:
        raise ValueError(f"{name} is {dtype} of shape {shape}")
    count, size = math.prod(shape), len(content) - file.tell()
    if count * dtype.itemsize != size:
        raise ValueError(f"{name} claims the shape {shape}, and has {size} bytes")
    return np.frombuffer(content, dtype, count, file.tell()).reshape(shape)


def _check_counts(table: list[list[int]], tasks: int, *records: int) -> None:
    """Raise ValueError unless the batches add up to the numbers of tasks and of records."""
    if any(keys <= 0 or first < 0 or blocks <= 0 for keys, first, blocks in table):
        raise ValueError("it has a batch without records")
    sums = sum(row[0] for row in table), sum(keys * blocks for keys, _, blocks in table)
    for rows in records:
        if sums != (tasks, rows):
            raise ValueError(f"its batches have (tasks, records) {sums}, its arrays {tasks, rows}")


def shard_sizes(sizes: Mapping[str, int], suffix: str = SHARD_SUFFIX) -> dict[str, int]:
    """Return the sizes of the shards among files. sizes : file name -> bytes."""
    return {
        name.removesuffix(suffix): size
        for name, size in sizes.items()
        if re.fullmatch(r"[0-9a-f]{32}" + re.escape(suffix), name)
    }


def shard_path(folder: Path, name: str) -> Path:
    """Return the path of a shard."""
    return folder / f"{name}{SHARD_SUFFIX}"
