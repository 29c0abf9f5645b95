"""Durable store of finished batches: immutable netCDF shards, each written whole or not at all.

A shard is built in memory, written aside, flushed, renamed, and its folder flushed; its name is
the checksum of its content. Its records are found by (key of the task, block), so that widening
a grid, another batch size or another study reuses what is there.
"""

import contextlib
import hashlib
import os
import sys
from pathlib import Path

import netCDF4
import numpy as np

from workflow.batch import SCALARS, Batch, BatchResult
from workflow.errors import UserError
from workflow.plan import Record

FORMAT = "elastomer-friction shard 1"
KEY_BYTES = 16


class Store:
    """The shards of a results folder. One writing process; any number of readers."""

    def __init__(self, folder: Path) -> None:
        """Open (or create) the store and index its shards."""
        self.folder = folder
        self.place: dict[Record, tuple[Path, int, int]] = {}  # record -> shard, task, block
        try:
            folder.mkdir(parents=True, exist_ok=True)
            shards = sorted(folder.glob("*.nc"))
        except OSError as error:
            raise UserError(f"{folder}: cannot be used for results: {error.strerror}") from error
        for shard in shards:
            self._index(shard)

    def records(self) -> set[Record]:
        """Return all records stored."""
        return set(self.place)

    def add(self, batch: Batch, result: BatchResult) -> None:
        """Store a finished batch durably. Raises UserError when the disk refuses it."""
        keys = [task.key for task in batch.tasks]
        content = _shard_bytes(batch, result)
        shard = self.folder / f"{_digest(content)}.nc"
        write_durably(shard, content)
        self._place(shard, keys, batch.first_block, batch.blocks)

    def read(self, records: list[Record], samples: int) -> tuple[np.ndarray, np.ndarray]:
        """Return (scalars, curves) of the records, shapes (records, 5) and (records, samples)."""
        scalars = np.empty((len(records), len(SCALARS)))
        curves = np.full((len(records), samples), np.nan)
        wanted: dict[Path, list[int]] = {}
        for row, record in enumerate(records):
            wanted.setdefault(self.place[record][0], []).append(row)
        for shard, rows in wanted.items():
            with netCDF4.Dataset(shard) as data:
                data.set_auto_mask(False)
                all_scalars, all_curves = data["scalars"][:], data["curves"][:]
            for row in rows:
                _, task, block = self.place[records[row]]
                scalars[row] = all_scalars[task, block]
                curves[row] = all_curves[task, block]
        return scalars, curves

    def _index(self, shard: Path) -> None:
        try:
            if _digest(shard.read_bytes()) != shard.stem:
                raise OSError("its content does not match the checksum in its name")
            with netCDF4.Dataset(shard) as data:
                if data.getncattr("format") != FORMAT:
                    raise OSError("not a shard of this program")
                keys = [bytes(row).hex() for row in data["key"][:]]
                first, blocks = int(data.first_block), data.dimensions["block"].size
        except (OSError, RuntimeError, AttributeError, KeyError, IndexError) as error:
            aside = shard.with_suffix(".damaged")
            print(f"warning: {shard} is damaged ({error}): set aside", file=sys.stderr)
            with contextlib.suppress(OSError):
                shard.rename(aside)
            return
        self._place(shard, keys, first, blocks)

    def _place(self, shard: Path, keys: list[str], first: int, blocks: int) -> None:
        for task, key in enumerate(keys):
            for block in range(blocks):
                self.place[key, first + block] = (shard, task, block)


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:32]


def _shard_bytes(batch: Batch, result: BatchResult) -> bytes:
    data = netCDF4.Dataset("shard.nc", "w", memory=4096)
    data.setncatts({"format": FORMAT, "first_block": batch.first_block})
    tasks, blocks, samples = result.curves.shape
    sizes = {"task": tasks, "block": blocks, "value": len(SCALARS), "sample": samples}
    for name, size in {**sizes, "byte": KEY_BYTES}.items():
        data.createDimension(name, size)
    keys = np.array([list(bytes.fromhex(task.key)) for task in batch.tasks], dtype=np.uint8)
    for name, dims, values in (
        ("key", ("task", "byte"), keys),
        ("scalars", ("task", "block", "value"), result.scalars),
        ("curves", ("task", "block", "sample"), result.curves),
    ):
        data.createVariable(name, values.dtype, dims, fill_value=False)[:] = values
    return bytes(data.close())


def write_durably(path: Path, content: bytes) -> None:
    """Write a file whole or not at all: aside, flushed, renamed, the folder flushed."""
    aside = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        with aside.open("wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        aside.replace(path)
        folder = os.open(path.parent, os.O_RDONLY)
        try:
            os.fsync(folder)
        finally:
            os.close(folder)
    except OSError as error:
        with contextlib.suppress(OSError):
            aside.unlink()
        raise UserError(f"{path}: cannot be written: {error.strerror}") from error
