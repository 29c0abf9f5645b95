"""Cache of machine code: a private folder per version of the sources, with a file per kernel.

The folder is named by a hash of all sources, because numba does not notice edits in called
functions. Files have checksums: a damaged file or a full disk causes a compilation, not an error.
While one process compiles a kernel, others wait. A wheel may contain machine code for x86-64-v3.
"""

import atexit
import contextlib
import errno
import fcntl
import hashlib
import os
import pickle
import shutil
import stat
import sys
import tempfile
import time
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import IO, Any

import numba
from llvmlite.binding import get_host_cpu_features
from numba.core import event
from numba.core.caching import CompileResultCacheImpl, NullCache
from numba.core.serialize import dumps

CACHE_NAME = "elastomer-friction"
COMPILER = f"numba{numba.__version__}cp{sys.version_info.major}{sys.version_info.minor}"
V3 = "x86-64-v3"
V3_FEATURES = {"avx2", "bmi", "bmi2", "f16c", "fma", "lzcnt", "movbe", "popcnt", "sse4.2", "xsave"}
WAITING_EVENT = f"{CACHE_NAME}:waiting"  # numba event: waiting for another process to compile
CODE_SETTINGS = (  # of numba, which change the machine code
    *("OPT", "BOUNDSCHECK", "DEBUGINFO_DEFAULT", "LOOP_VECTORIZE", "SLP_VECTORIZE"),
    *("DISABLE_INTEL_SVML", "LLVM_REFPRUNE_PASS", "DEBUG_NRT"),
)
LOCK_SECONDS, LOCK_POLL_SECONDS = 120.0, 0.05  # maximum wait and polling interval


def source_hash() -> str:
    """Return a short hash (hexadecimal) of all source files of kernels."""
    package = Path(__file__).parents[1]
    digest = hashlib.sha256()
    for source in sorted(package.rglob("*.py")):
        digest.update(source.relative_to(package).as_posix().encode() + source.read_bytes())
    return digest.hexdigest()[:16]


def cache_folder() -> str:
    """Return a cache folder that no other user can write to, so that no foreign code is run.

    It is below NUMBA_CACHE_DIR, XDG_CACHE_HOME or the directory of temporary files. If that place
    is unsafe or read-only, return a temporary folder that is removed at the end of this process.
    """
    shared = Path(tempfile.gettempdir(), f"{CACHE_NAME}-{os.getuid()}")
    base = os.environ.get("NUMBA_CACHE_DIR") or os.environ.get("XDG_CACHE_HOME") or shared
    try:
        return str(_safe_folder(Path(base)))
    except OSError as error:
        place = "/tmp" if os.access("/tmp", os.W_OK) else None  # another user may own TMPDIR
        private = tempfile.mkdtemp(prefix=f"{CACHE_NAME}-", dir=place)
        atexit.register(shutil.rmtree, private, ignore_errors=True)
        os.environ["NUMBA_CACHE_DIR"] = private  # for child processes too
        line = f"machine code is kept for this run alone: {error.filename}: {error.strerror}\n"
        with contextlib.suppress(OSError, ValueError, AttributeError):  # no stderr
            sys.stderr.write(line)
        return str(_safe_folder(Path(private)))


def _safe_folder(base: Path) -> Path:
    """Return the cache folder in ``base``, created if needed. Raises OSError if it is unsafe."""
    base.mkdir(mode=0o700, parents=True, exist_ok=True)
    parent = Path(base, CACHE_NAME).resolve()
    parent.mkdir(mode=0o700, exist_ok=True)
    for folder in (parent, *parent.parents):  # the group may have write access (umask 002)
        status = folder.stat()
        if status.st_uid not in (0, os.getuid()):  # owners can rename entries even if sticky
            raise PermissionError(errno.EPERM, "belongs to another user", str(folder))
        if status.st_mode & stat.S_IWOTH and not status.st_mode & stat.S_ISVTX:
            raise PermissionError(errno.EPERM, "can be written to by anyone", str(folder))
    if parent.stat().st_mode & 0o077:  # others may have put files there
        shutil.rmtree(parent)
        parent.mkdir(mode=0o700)
    folder = parent / source_hash()
    folder.mkdir(mode=0o700, exist_ok=True)
    with tempfile.TemporaryFile(dir=folder):
        return folder


def select_processor() -> None:
    """Compile for x86-64-v3 if a wheel contains such machine code and this processor supports it.

    Child processes inherit the environment variables, and remove them on an unsuitable processor.
    """
    fits = {name for name, present in get_host_cpu_features().items() if present} >= V3_FEATURES
    requested = os.environ.get("NUMBA_CPU_NAME")
    if requested is None and fits and (SHIPPED / COMPILER).is_dir():
        os.environ |= {"NUMBA_CPU_NAME": V3, "NUMBA_CPU_FEATURES": ""}
    elif requested == V3 and not fits:
        del os.environ["NUMBA_CPU_NAME"], os.environ["NUMBA_CPU_FEATURES"]
    numba.config.reload_config()


CACHE_FOLDER = cache_folder()
SHIPPED = Path(__file__).with_name("shipped") / source_hash()  # machine code of a wheel
select_processor()


class KernelCache(NullCache, CompileResultCacheImpl):
    """Cache of the machine code of one function on disk; numba serializes the code."""

    def __init__(self, function: Callable) -> None:
        self.function = function
        self.file: IO[bytes] | None = None  # locked while this process compiles

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Return the compiled function for a signature, or lock its file and return None."""
        target_context.refresh()
        name = self._file_name(sig, target_context.codegen())
        self.path = Path(CACHE_FOLDER, name)
        for path in (SHIPPED / name, self.path):
            if overload := self._load(path, target_context):
                return overload
        self.file = _open_locked(self.path)
        overload = self._load(self.path, target_context)  # another process may have saved it
        if overload and self.file:
            self.file.close()
        return overload

    def save_overload(self, sig: Any, cres: Any) -> None:
        """Store a compiled function; warn if that fails."""
        try:
            content = dumps(self.reduce(cres))
            with self.file or self.path.open("ab") as file:
                file.truncate(0)
                file.write(hashlib.sha256(content).digest() + content)
        except Exception as error:
            warnings.warn(f"machine code is not cached: {error}", RuntimeWarning, stacklevel=2)

    def _file_name(self, sig: Any, codegen: Any) -> str:
        source = Path(self.function.__code__.co_filename).read_bytes()
        settings = [str(getattr(numba.config, name, "")) for name in CODE_SETTINGS]
        key = repr((sig, codegen.magic_tuple(), self.function.__qualname__, settings)).encode()
        name = f"{self.function.__module__}.{self.function.__name__}".rpartition("kernels.")[2]
        return f"{COMPILER}/{name}-{hashlib.sha256(key + source).hexdigest()[:20]}.bin"

    def _load(self, path: Path, target_context: Any) -> Any:
        with contextlib.suppress(OSError):
            stored = path.read_bytes()
            if hashlib.sha256(stored[32:]).digest() == stored[:32]:
                return self.rebuild(target_context, pickle.loads(stored[32:]))
        return None


def _open_locked(path: Path) -> IO[bytes] | None:
    """Open a file and lock it until it is closed; return None if it cannot be locked."""
    end = time.monotonic() + LOCK_SECONDS
    with contextlib.suppress(OSError):
        path.parent.mkdir(exist_ok=True)
        file = path.open("ab")
        while time.monotonic() < end:
            with contextlib.suppress(BlockingIOError):
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                return file
            with event.trigger_event(WAITING_EVENT):
                time.sleep(LOCK_POLL_SECONDS)
        file.close()
    return None
