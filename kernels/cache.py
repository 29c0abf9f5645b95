"""Machine code on disk: where it lies, that it is sound, that one process at a time makes it.

numba's disk cache does not notice an edit in a *called* function of another module, so the
cache folder carries a hash of all kernel sources: any edit opens a new folder. It lies on a
disk of the machine itself, and a file damaged there or a full disk cost a compilation, no more.
"""

import contextlib
import fcntl
import hashlib
import os
import pickle
import tempfile
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numba
from numba.core.caching import FunctionCache, IndexDataCacheFile


def source_hash() -> str:
    """Return a short hash (hexadecimal) over the source files of this package and its rooms."""
    package = Path(__file__).parent
    digest = hashlib.sha256()
    for source in sorted(package.rglob("*.py")):
        digest.update(source.relative_to(package).as_posix().encode())
        digest.update(source.read_bytes())
    return digest.hexdigest()[:16]


def _cache_folder() -> str:
    """Return a folder of our own, under XDG_CACHE_HOME or among the temporary files."""
    own = f"elastomer-friction-{os.getuid()}"
    base = os.environ.get("XDG_CACHE_HOME") or Path(tempfile.gettempdir(), own)
    folder = Path(base, "elastomer-friction", source_hash())
    try:
        Path(base).mkdir(mode=0o700, parents=True, exist_ok=True)
        folder.mkdir(parents=True, exist_ok=True)
        if Path(base).stat().st_uid == os.getuid():  # machine code of others is not to be run
            with tempfile.TemporaryFile(dir=folder):
                return str(folder)
    except OSError:  # read-only, as on some batch nodes
        pass
    return tempfile.mkdtemp(prefix="elastomer-friction-")


class _CheckedFile(IndexDataCacheFile):
    """Files of numba's cache whose machine code carries a checksum."""

    def _save_data(self, name: str, data: Any) -> None:
        content = self._dump(data)
        with self._open_for_write(self._data_path(name)) as file:
            file.write(hashlib.sha256(content).digest() + content)

    def _load_data(self, name: str) -> Any:
        content = Path(self._data_path(name)).read_bytes()
        if hashlib.sha256(content[32:]).digest() != content[:32]:
            raise EOFError(f"{name} is damaged")
        return pickle.loads(content[32:])


class CheckedCache(FunctionCache):
    """numba's cache on disk, for which a damaged file is one that is not there."""

    def __init__(self, function: Callable) -> None:
        numba.config.CACHE_DIR = FOLDER  # numba forgets it where a variable NUMBA_... changes
        super().__init__(function)
        stamp = self._impl.locator.get_source_stamp()
        self._cache_file = _CheckedFile(self._cache_path, self._impl.filename_base, stamp)

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Return the machine code for a signature, or None."""
        try:
            return super().load_overload(sig, target_context)
        except Exception:  # whatever unpickling a truncated file may raise
            with contextlib.suppress(OSError):
                Path(self._cache_file._index_path).unlink()
            return None

    def save_overload(self, sig: Any, data: Any) -> None:
        """Store machine code, if the disk takes it.

        numba reads the index, adds a line and writes it: two processes at once would lose a line,
        or give two versions of a kernel one name.
        """
        try:
            with _one_process("index"):
                super().save_overload(sig, data)
        except Exception as error:
            warnings.warn(f"machine code is not cached: {error}", RuntimeWarning, stacklevel=2)


FOLDER = os.environ.get("NUMBA_CACHE_DIR") or _cache_folder()


@contextlib.contextmanager
def compiling() -> Iterator[None]:
    """Let one process of a machine at a time compile: the others then find its machine code."""
    with _one_process("lock"):
        yield


@contextlib.contextmanager
def _one_process(name: str) -> Iterator[None]:
    """Wait until no other process of this machine holds the lock of a name."""
    with contextlib.ExitStack() as stack:
        with contextlib.suppress(OSError):  # no lock: each works for itself
            file = stack.enter_context(Path(FOLDER, name).open("w"))
            fcntl.flock(file, fcntl.LOCK_EX)
        yield
