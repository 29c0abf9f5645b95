"""Files that survive a crash, and a lock for the folder they are in.

A file is written whole or not at all and flushed to the disk. One process writes per folder of
results: it holds a lock of the operating system that dies with its holder.
"""

import contextlib
import fcntl
import json
import os
import socket
import sys
from collections.abc import Iterator
from datetime import datetime
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


NAME = "lock"


@contextlib.contextmanager
def hold(folder: Path) -> Iterator[None]:
    """Hold the lock of a folder, made if need be. Raises UserError naming who has it."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        file = (folder / NAME).open("a+")
    except OSError as error:
        raise UserError(f"{folder}: cannot be used for results: {error.strerror}") from error
    with file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise UserError(f"{folder}: in use by {_words(folder)}; one run at a time") from None
        except OSError as error:  # a file system without locks
            print(
                f"warning: {folder}: cannot be locked ({error.strerror}); "
                "see to it that no other run uses it",
                file=sys.stderr,
            )
        _sign(file)
        yield


def holder(folder: Path) -> str | None:
    """Return who holds the lock of a folder, in words, or None."""
    try:
        with (folder / NAME).open() as file:
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except BlockingIOError:
        return _words(folder)
    except OSError:
        pass
    return None


def _sign(file) -> None:
    """Write into the lock who holds it; a full disk may prevent that, but not the lock."""
    with contextlib.suppress(OSError):
        since = datetime.now().astimezone().isoformat(" ", "seconds")
        file.truncate(0)
        text = json.dumps({"pid": os.getpid(), "host": socket.gethostname(), "since": since})
        os.write(file.fileno(), text.encode())  # no buffer, which would fail again when closed


def _words(folder: Path) -> str:
    try:
        signed = json.loads((folder / NAME).read_text())
        return f"process {signed['pid']} on {signed['host']} since {signed['since']}"
    except (OSError, ValueError, KeyError, TypeError):
        return "an unknown process"
