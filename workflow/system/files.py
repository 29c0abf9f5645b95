"""Files that survive a crash: written whole or not at all, and flushed to the disk."""

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

from workflow.errors import UserError


@contextlib.contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Yield a hidden name beside ``path`` to write to; then flush it, rename it, flush the folder.

    Readers see the old file until the new one is whole. Raises UserError where the disk refuses,
    once nothing of the new file is left; HDF5 reports a full disk as RuntimeError.
    """
    aside = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        yield aside
        with aside.open("rb+") as file:
            os.fsync(file.fileno())
        aside.replace(path)
        _flush_folder(path.parent)
    except (OSError, RuntimeError) as error:
        with contextlib.suppress(OSError):
            aside.unlink()
        raise UserError(f"{path}: cannot be written: {_reason(error)}") from error


def write_durably(path: Path, content: bytes) -> None:
    """Write a file whole or not at all. Raises UserError where the disk refuses."""
    with replacing(path) as aside:
        aside.write_bytes(content)


def append_durably(path: Path, content: bytes) -> None:
    """Append to a file and flush it. A crash may leave part of ``content`` at its end."""
    try:
        with path.open("ab") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        _flush_folder(path.parent)
    except OSError as error:
        raise UserError(f"{path}: cannot be written: {_reason(error)}") from error


def make_folder(folder: Path) -> None:
    """Make a folder with its parents. Raises UserError where that is refused."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise UserError(f"{folder}: cannot be made: {_reason(error)}") from error


def clear_leftovers(path: Path) -> None:
    """Remove what dead writers of ``path`` (a pattern) left aside; for the holder of the lock."""
    for aside in path.parent.glob(f".{path.name}.*.tmp"):
        with contextlib.suppress(OSError):
            aside.unlink()


def _flush_folder(folder: Path) -> None:
    """Make the names in a folder durable."""
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def _reason(error: OSError | RuntimeError) -> str:
    return getattr(error, "strerror", None) or str(error)
