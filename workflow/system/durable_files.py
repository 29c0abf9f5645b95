"""Files that survive a crash: written completely or not at all, and flushed to the disk."""

import contextlib
import errno
import hashlib
import os
from collections.abc import Iterator
from pathlib import Path
from typing import IO

from ..ground import UserError, open_plain, read_plain

# Errors of fsync on a folder for which the file system does not support it.
_UNSUPPORTED = "EINVAL ENOTSUP EOPNOTSUPP ENOSYS EBADF EACCES EPERM EISDIR ENOTTY"
UNSUPPORTED_ERRORS = frozenset(getattr(errno, name) for name in _UNSUPPORTED.split())
MAX_FILE_BYTES = 2**32  # largest file that is read; a shard has about 2**24 bytes


@contextlib.contextmanager
def refused(path: Path, failure: str) -> Iterator[None]:
    """Turn disk errors into UserError, also the RuntimeError of HDF5 on a full disk.

    failure : the failed operation on ``path``, such as "cannot be written:".
    """
    try:
        yield
    except (OSError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise UserError(f"{path}: {failure} {reason}") from error


@contextlib.contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Yield a temporary path beside ``path`` to write to; then flush and rename it, durably.

    Readers see the old file until the new one is complete. If the disk refuses, the temporary file
    is removed and UserError is raised.
    """
    aside = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    with refused(path, "cannot be written:"):
        _remove(aside)
        try:
            yield aside
            with aside.open("rb+") as file:
                os.fsync(file.fileno())
                _rename(aside, path, file)
            flush_folder(path.parent)
        finally:
            _remove(aside)


def _rename(aside: Path, path: Path, file: IO[bytes]) -> None:
    """Rename ``aside`` to ``path``. file : ``aside``, open.

    NFS repeats a request whose answer is lost, and then reports that the renamed file is missing or
    exists already. The rename is complete if ``path`` has the content of the file.
    """
    try:
        aside.replace(path)
    except (FileNotFoundError, FileExistsError):
        same_size = path.is_file() and path.stat().st_size == os.fstat(file.fileno()).st_size
        if not same_size or digest_of(path) != _digest(file):
            raise


def write_durably(path: Path, content: bytes) -> None:
    """Write a file completely or not at all. Raises UserError if the disk refuses."""
    with replacing(path) as aside:
        aside.write_bytes(content)


def append_durably(path: Path, content: bytes) -> None:
    """Append lines to a file, starting on a new line, and flush it.

    A crash may leave part of ``content`` at the end. If the disk refuses, the file is truncated to
    its former size if possible, and UserError is raised.
    """
    with refused(path, "cannot be written:"), open_plain(path, "ab") as file:
        size = file.seek(0, os.SEEK_END)
        try:
            remaining = memoryview(content if _ends_a_line(path, size) else b"\n" + content)
            while remaining:  # a nearly full disk may write only a part
                remaining = remaining[file.write(remaining) :]
            os.fsync(file.fileno())
            flush_folder(path.parent)
        except OSError:
            with contextlib.suppress(OSError):
                file.truncate(size)
            raise


def read_whole(path: Path) -> bytes:
    """Return the content of a file of at most MAX_FILE_BYTES.

    Raises UserError if the disk refuses, or if the file is missing, too large or not regular.
    """
    with refused(path, "cannot be read:"):
        return read_plain(path, MAX_FILE_BYTES)


def digest_of(path: Path) -> str:
    """Return the hexadecimal checksum of a file. Raises UserError if it cannot be read."""
    with refused(path, "cannot be read:"), open_plain(path) as file:
        return _digest(file)


def _digest(file: IO[bytes]) -> str:
    """Return the hexadecimal checksum of an open file from its position on."""
    return hashlib.file_digest(file, "sha256").hexdigest()[:32]  # type: ignore[arg-type]


def sizes_in(folder: Path) -> dict[str, int]:
    """Return the files in a folder as name -> bytes; empty if the folder is missing.

    Raises UserError if the disk refuses, so that no existing file is omitted.
    """
    sizes = {}
    with refused(folder, "cannot be read:"):
        try:
            paths = list(folder.iterdir())
        except FileNotFoundError:
            return {}
        for path in paths:
            with contextlib.suppress(FileNotFoundError):  # the file was removed meanwhile
                sizes[path.name] = path.stat().st_size
    return sizes


def check_place(path: Path) -> None:
    """Raise UserError if ``path`` cannot be written; test this with a temporary file."""
    with refused(path, "cannot be written:"):
        if path.is_symlink() or (path.exists() and not path.is_file()):
            raise OSError(
                errno.EINVAL, f"it is {'a link' if path.is_symlink() else 'not a regular file'}"
            )
        probe = path.with_name(f".{path.name}.{os.getpid()}.tmp")
        try:
            probe.touch(exist_ok=False)
        finally:
            _remove(probe)


def make_folder(folder: Path) -> None:
    """Create a folder and its parents if missing. Raises UserError if the disk refuses."""
    with refused(folder, "cannot be made:"):
        folder.mkdir(parents=True, exist_ok=True)


def clear_leftovers(path: Path) -> None:
    """Remove temporary files of dead writers of ``path``, a pattern. The caller holds the lock."""
    for aside in path.parent.glob(f".{path.name}.*.tmp"):
        _remove(aside)


def _remove(path: Path) -> None:
    with contextlib.suppress(OSError):
        path.unlink()


def flush_folder(folder: Path) -> bool:
    """Flush the file names in a folder; return False if its file system does not support it."""
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    except OSError as error:
        if error.errno not in UNSUPPORTED_ERRORS:
            raise
        return False
    finally:
        os.close(descriptor)
    return True


def _ends_a_line(path: Path, size: int) -> bool:
    """Return whether a file is empty or ends with a newline; a crash may cut the last line."""
    if not size:
        return True
    with path.open("rb") as file:
        file.seek(size - 1)
        return file.read(1) == b"\n"
