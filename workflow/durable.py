"""Files that survive a crash: written whole or not at all, and flushed to the disk."""

import contextlib
import os
from pathlib import Path

from workflow.errors import UserError


def aside_of(path: Path) -> Path:
    """Return the hidden name under which this process writes ``path`` before renaming it."""
    return path.with_name(f".{path.name}.{os.getpid()}.tmp")


def write_durably(path: Path, content: bytes) -> None:
    """Write a file whole or not at all: aside, flushed, renamed, the folder flushed."""
    aside = aside_of(path)
    try:
        with aside.open("wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        aside.replace(path)
        flush_folder(path.parent)
    except OSError as error:
        with contextlib.suppress(OSError):
            aside.unlink()
        raise UserError(f"{path}: cannot be written: {error.strerror}") from error


def append_durably(path: Path, content: bytes) -> None:
    """Append to a file and flush it. A crash may leave part of ``content`` at its end."""
    try:
        with path.open("ab") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        flush_folder(path.parent)
    except OSError as error:
        raise UserError(f"{path}: cannot be written: {error.strerror}") from error


def flush_folder(folder: Path) -> None:
    """Make the names in a folder durable."""
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def clear_leftovers(path: Path) -> None:
    """Remove what dead writers of ``path`` (a pattern) left aside; for the holder of the lock."""
    for aside in path.parent.glob(f".{path.name}.*.tmp"):
        with contextlib.suppress(OSError):
            aside.unlink()
