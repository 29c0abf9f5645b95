"""Files that survive a crash: written whole or not at all, and flushed to the disk."""

import contextlib
import errno
import hashlib
import os
from collections.abc import Iterator
from pathlib import Path

from ..ground import UserError, open_plain, read_plain

# What fsync says of a folder where the file system does not offer it.
_REFUSALS = "EINVAL ENOTSUP EOPNOTSUPP ENOSYS EBADF EACCES EPERM EISDIR ENOTTY"
MOST_BYTES = 2**32  # of a file that is read as a whole: a shard has some 2**24
NOT_OFFERED = frozenset(getattr(errno, name) for name in _REFUSALS.split())


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
    """Write a file whole or not at all. Raises UserError where the disk refuses."""
    with replacing(path) as aside:
        aside.write_bytes(content)


def append_durably(path: Path, content: bytes) -> None:
    """Append whole lines to a file and flush it; begin on a line of their own.

    A crash may leave part of ``content`` at the end. Raises UserError where the disk refuses,
    once what was appended is taken back, as far as the disk lets us.
    """
    with refused(path, "cannot be written:"), open_plain(path, "ab") as file:
        size = file.seek(0, os.SEEK_END)
        try:
            left = memoryview(content if _ends_a_line(path, size) else b"\n" + content)
            while left:  # a disk that is nearly full takes a part at first
                left = left[file.write(left) :]
            os.fsync(file.fileno())
            flush_folder(path.parent)
        except OSError:
            with contextlib.suppress(OSError):
                file.truncate(size)
            raise


def read_whole(path: Path) -> bytes:
    """Return the content of a file of at most MOST_BYTES.

    Raises UserError where the disk refuses it, or has none, and for what is larger or no file.
    """
    with refused(path, "cannot be read:"):
        return read_plain(path, MOST_BYTES)


def digest_of(path: Path) -> str:
    """Return the checksum (hexadecimal) of a file. Raises UserError as ``read_whole``."""
    with refused(path, "cannot be read:"), open_plain(path) as file:
        return hashlib.file_digest(file, "sha256").hexdigest()[:32]


def sizes_in(folder: Path) -> dict[str, int]:
    """Return name -> bytes of the files in a folder, which need not be there.

    Raises UserError where the disk refuses: no file that is there is left out.
    """
    found = {}
    with refused(folder, "cannot be read:"):
        try:
            paths = list(folder.iterdir())
        except FileNotFoundError:
            return {}
        for path in paths:
            with contextlib.suppress(FileNotFoundError):  # removed meanwhile
                found[path.name] = path.stat().st_size
    return found


def check_place(path: Path) -> None:
    """Raise UserError where a file could not be written in the end: try beside it, now."""
    with refused(path, "cannot be written:"):
        if path.is_symlink() or (path.exists() and not path.is_file()):
            raise OSError(errno.EINVAL, f"it is {'a link' if path.is_symlink() else 'no file'}")
        probe = path.with_name(f".{path.name}.{os.getpid()}.tmp")
        try:
            probe.touch(exist_ok=False)
        finally:
            _remove(probe)


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


def flush_folder(folder: Path) -> bool:
    """Make the names in a folder durable; return False where its file system offers no way."""
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    except OSError as error:
        if error.errno not in NOT_OFFERED:
            raise
        return False
    finally:
        os.close(descriptor)
    return True


def _ends_a_line(path: Path, size: int) -> bool:
    """Return whether what is appended begins a line: no crash has cut the last one short."""
    if not size:
        return True
    with path.open("rb") as file:
        file.seek(size - 1)
        return file.read(1) == b"\n"
