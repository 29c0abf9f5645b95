"""Files that survive a crash: written completely or not at all, and flushed to the disk."""

import contextlib
import errno
import hashlib
import os
from collections.abc import Iterator
from pathlib import Path

from ..ground import UserError, open_plain, read_plain

# Errors of fsync on a folder if the file system does not support it.
_UNSUPPORTED = "EINVAL ENOTSUP EOPNOTSUPP ENOSYS EBADF EACCES EPERM EISDIR ENOTTY"
UNSUPPORTED_ERRORS = frozenset(getattr(errno, name) for name in _UNSUPPORTED.split())
MAX_FILE_BYTES = 2**32  # a shard has some 2**24


@contextlib.contextmanager
def refused(path: Path, failure: str) -> Iterator[None]:
    """Turn an error of the disk into a UserError; HDF5 reports a full disk by RuntimeError.

    failure : the failed operation on ``path``, as "cannot be written:".
    """
    try:
        yield
    except (OSError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise UserError(f"{path}: {failure} {reason}") from error


@contextlib.contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Yield a hidden name beside ``path`` to write to; then flush it, rename it, flush the folder.

    Readers see the old file until the new one is complete. If the disk refuses, the new file is
    removed and UserError raised.
    """
    aside = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    with refused(path, "cannot be written:"):
        _remove(aside)
        try:
            yield aside
            with aside.open("rb+") as file:
                os.fsync(file.fileno())
            aside.replace(path)
            flush_folder(path.parent)
        finally:
            _remove(aside)


def write_durably(path: Path, content: bytes) -> None:
    """Write a file completely or not at all. Raises UserError if the disk refuses."""
    with replacing(path) as aside:
        aside.write_bytes(content)


def append_durably(path: Path, content: bytes) -> None:
    """Append lines to a file, which begin on a new line, and flush it.

    A crash may leave part of ``content`` at the end. If the disk refuses, the file is cut back to
    its former size, if the disk permits it, and UserError is raised.
    """
    with refused(path, "cannot be written:"), open_plain(path, "ab") as file:
        size = file.seek(0, os.SEEK_END)
        try:
            remaining = memoryview(content if _ends_a_line(path, size) else b"\n" + content)
            while remaining:  # a nearly full disk takes a part first
                remaining = remaining[file.write(remaining) :]
            os.fsync(file.fileno())
            flush_folder(path.parent)
        except OSError:
            with contextlib.suppress(OSError):
                file.truncate(size)
            raise


def read_whole(path: Path) -> bytes:
    """Return the content of a file of at most MAX_FILE_BYTES.

    Raises UserError if the disk refuses, and for a missing file, a larger one, or a device.
    """
    with refused(path, "cannot be read:"):
        return read_plain(path, MAX_FILE_BYTES)


def digest_of(path: Path) -> str:
    """Return the checksum (hexadecimal) of a file. Raises UserError as ``read_whole``."""
    with refused(path, "cannot be read:"), open_plain(path) as file:
        return hashlib.file_digest(file, "sha256").hexdigest()[:32]


def sizes_in(folder: Path) -> dict[str, int]:
    """Return name -> bytes of the files in a folder; empty if the folder is missing.

    Raises UserError if the disk refuses, so that no existing file is left out.
    """
    sizes = {}
    with refused(folder, "cannot be read:"):
        try:
            paths = list(folder.iterdir())
        except FileNotFoundError:
            return {}
        for path in paths:
            with contextlib.suppress(FileNotFoundError):  # removed meanwhile
                sizes[path.name] = path.stat().st_size
    return sizes


def check_place(path: Path) -> None:
    """Raise UserError if a file could not be written later: try with a temporary file now."""
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
    """Make a folder with its parents. Raises UserError if the disk refuses."""
    with refused(folder, "cannot be made:"):
        folder.mkdir(parents=True, exist_ok=True)


def clear_leftovers(path: Path) -> None:
    """Remove temporary files of dead writers of ``path`` (a pattern); for the lock's holder."""
    for aside in path.parent.glob(f".{path.name}.*.tmp"):
        _remove(aside)


def _remove(path: Path) -> None:
    with contextlib.suppress(OSError):
        path.unlink()


def flush_folder(folder: Path) -> bool:
    """Make the names in a folder durable; return False if its file system cannot."""
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
    """Return whether a file ends with a complete line; a crash may have cut the last one."""
    if not size:
        return True
    with path.open("rb") as file:
        file.seek(size - 1)
        return file.read(1) == b"\n"
