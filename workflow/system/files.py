"""Files that survive a crash: written whole or not at all, and flushed to the disk."""

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

from workflow.errors import UserError


@contextlib.contextmanager
def refused(path: Path, what: str) -> Iterator[None]:
    """Raise UserError where the disk refuses something; HDF5 says a full disk by RuntimeError.

    what : what cannot be done with ``path``, as "cannot be written:".
    """
    try:
        yield
    except (OSError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise UserError(f"{path}: {what} {reason}") from error


@contextlib.contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Yield a hidden name beside ``path`` to write to; then flush it, rename it, flush the folder.

    Readers see the old file until the new one is whole. Raises UserError where the disk refuses,
    once nothing of the new file is left.
    """
    aside = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    with refused(path, "cannot be written:"):
        try:
            yield aside
            with aside.open("rb+") as file:
                os.fsync(file.fileno())
            aside.replace(path)
            _flush_folder(path.parent)
        finally:
            _remove(aside)


def write_durably(path: Path, content: bytes) -> None:
    """Write a file whole or not at all. Raises UserError where the disk refuses."""
    with replacing(path) as aside:
        aside.write_bytes(content)


def append_durably(path: Path, content: bytes) -> None:
    """Append to a file and flush it. A crash may leave part of ``content`` at its end."""
    with refused(path, "cannot be written:"):
        with path.open("ab") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        _flush_folder(path.parent)


def make_folder(folder: Path) -> None:
    """Make a folder with its parents. Raises UserError where that is refused."""
    with refused(folder, "cannot be made:"):
        folder.mkdir(parents=True, exist_ok=True)


def clear_leftovers(path: Path) -> None:
    """Remove what dead writers of ``path`` (a pattern) left aside; for the holder of the lock."""
    for aside in path.parent.glob(f".{path.name}.*.tmp"):
        _remove(aside)


def _remove(path: Path) -> None:
    with contextlib.suppress(OSError):
        path.unlink()


def _flush_folder(folder: Path) -> None:
    """Make the names in a folder durable."""
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
