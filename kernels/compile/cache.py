"""Machine code on disk: where it lies, that it is sound, that one process at a time makes it.

numba's disk cache does not notice an edit in a *called* function of another module, so the
cache folder carries a hash of all kernel sources: any edit opens a new folder. It lies on a
disk of the machine itself, and a file damaged there or a full disk cost a compilation, no more.

A wheel brings machine code for x86-64-v3 (`make wheel`). It is copied into a folder that is made,
and kernels are compiled for that kind of processor then: with the same bits, for want of any
instruction to reorder sums or to round otherwise.
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
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import IO, Any

import numba
from llvmlite.binding import get_host_cpu_features
from numba.core import event
from numba.core.caching import FunctionCache, IndexDataCacheFile

NAME = "elastomer-friction"
PACKAGE = Path(__file__).parents[1]
SHIPPED = Path(__file__).with_name("shipped")  # in a wheel alone
V3 = "x86-64-v3"
V3_HAS = {"avx2", "bmi", "bmi2", "f16c", "fma", "lzcnt", "movbe", "popcnt", "sse4.2", "xsave"}
WAITING_EVENT = f"{NAME}:waiting"  # kind of event: this process waits for one that compiles
OTHERS_WRITE = stat.S_IWGRP | stat.S_IWOTH
LOCK_SECONDS, POLL_SECONDS = 600.0, 0.05  # to wait for whoever compiles


def source_hash() -> str:
    """Return a short hash (hexadecimal) over all source files of kernels."""
    package = Path(__file__).parents[1]
    digest = hashlib.sha256()
    for source in sorted(package.rglob("*.py")):
        digest.update(source.relative_to(package).as_posix().encode())
        digest.update(source.read_bytes())
    return digest.hexdigest()[:16]


def _cache_folder() -> str:
    """Return a folder that nobody else can write to: machine code of others is not to be run.

    It lies under NUMBA_CACHE_DIR, XDG_CACHE_HOME or among the temporary files; where that is not
    safe or cannot be written to, in a private folder that ends with this process.
    """
    shared = Path(tempfile.gettempdir(), f"{NAME}-{os.getuid()}")
    base = os.environ.get("NUMBA_CACHE_DIR") or os.environ.get("XDG_CACHE_HOME") or shared
    try:
        return str(_own_folder(Path(base)))
    except OSError as error:  # read-only, as on some batch nodes, or open to others
        private = tempfile.mkdtemp(prefix=f"{NAME}-", dir=_place_for_a_while())
        atexit.register(shutil.rmtree, private, ignore_errors=True)
        os.environ["NUMBA_CACHE_DIR"] = private  # for the processes that this one starts
        if sys.stderr:
            reason = f"{error.filename}: {error.strerror}"
            with contextlib.suppress(OSError, ValueError):
                print(f"machine code is kept for this run alone: {reason}", file=sys.stderr)
        return str(_own_folder(Path(private)))


def _own_folder(base: Path) -> Path:
    """Return our folder in ``base``, made if need be. Raises OSError where it would not be safe."""
    base.mkdir(mode=0o700, parents=True, exist_ok=True)
    folder = Path(base, NAME).resolve()
    _check_parents(folder)
    with contextlib.suppress(FileExistsError):
        folder.mkdir(mode=0o700)
    found = folder.stat()
    if found.st_uid != os.getuid():
        raise PermissionError(errno.EPERM, "belongs to another user", str(folder))
    if found.st_mode & OTHERS_WRITE:  # who knows what lies in it
        shutil.rmtree(folder)
        folder.mkdir(mode=0o700)
    elif stat.S_IMODE(found.st_mode) != 0o700:
        folder.chmod(0o700)
    own = folder / source_hash()
    if SHIPPED.is_dir() and not own.exists():
        with tempfile.TemporaryDirectory(dir=folder) as aside, contextlib.suppress(FileExistsError):
            shutil.copytree(SHIPPED, Path(aside, own.name), copy_function=shutil.copyfile)
            Path(aside, own.name).rename(own)
    own.mkdir(mode=0o700, exist_ok=True)
    with tempfile.TemporaryFile(dir=own):
        return own


def _place_for_a_while() -> str | None:
    """Return where a private folder is safe; None for the usual place, where none is."""
    for place in (tempfile.gettempdir(), "/tmp", "/var/tmp"):
        with contextlib.suppress(OSError), tempfile.TemporaryDirectory(dir=place) as found:
            _check_parents(Path(found).resolve())
            return place
    return None


def _check_parents(path: Path) -> None:
    """Raise PermissionError where others can exchange what lies at a path.

    The group may write to folders of our own (umask 002, where the group is the user's alone).
    """
    for folder in path.parents:
        found = folder.stat()
        if found.st_uid not in (0, os.getuid()):  # who may rename what lies there, sticky or not
            raise PermissionError(errno.EPERM, "belongs to another user", str(folder))
        if found.st_mode & stat.S_IWOTH and not found.st_mode & stat.S_ISVTX:
            raise PermissionError(errno.EPERM, "can be written to by anyone", str(folder))


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
        numba.config.CACHE_DIR = CACHE_FOLDER  # numba forgets it where a variable NUMBA_... changes
        super().__init__(function)
        stamp = self._impl.locator.get_source_stamp()
        room = Path(function.__code__.co_filename).parent
        if room.is_relative_to(PACKAGE):  # the folder tells the sources, wherever they lie
            stamp = room.relative_to(PACKAGE).as_posix()
            self._cache_path = str(Path(CACHE_FOLDER, f"{stamp.replace('/', '.')}-{COMPILER}"))
        self._cache_file = _CheckedFile(self._cache_path, self._impl.filename_base, stamp)

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Return the machine code for a signature, or None.

        What is not found may be there once this process has its turn to compile.
        """
        found = self._load_sound(sig, target_context)
        if found is None and take_turn():
            found = self._load_sound(sig, target_context)
        return found

    def _load_sound(self, sig: Any, target_context: Any) -> Any:
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
            Path(self._cache_path).mkdir(exist_ok=True)
            with _one_process("index"):
                super().save_overload(sig, data)
        except Exception as error:
            warnings.warn(f"machine code is not cached: {error}", RuntimeWarning, stacklevel=2)


def serve_many() -> None:
    """Compile for x86-64-v3, where a wheel has brought such code and this processor runs it.

    numba forgets what it is told where a variable NUMBA_... changes, so that a variable says it.
    A job on another node may inherit that, and takes it back where it does not fit.
    """
    python = f"py{sys.version_info.major}{sys.version_info.minor}"
    fits = {name for name, has in get_host_cpu_features().items() if has} >= V3_HAS
    asked, brought = os.environ.get("NUMBA_CPU_NAME"), SHIPPED.glob(f"*-{COMPILER}/*.{python}.nbi")
    if asked is None and fits and any(brought):
        os.environ |= {"NUMBA_CPU_NAME": V3, "NUMBA_CPU_FEATURES": ""}
        numba.config.reload_config()
    elif asked == V3 and not fits:
        for name in ("NUMBA_CPU_NAME", "NUMBA_CPU_FEATURES"):
            os.environ.pop(name, None)
        numba.config.reload_config()


COMPILER = f"numba{numba.__version__}"
CACHE_FOLDER = _cache_folder()
serve_many()


_turns: list[contextlib.ExitStack] = []  # blocks of compile_in_turn that have no lock yet


@contextlib.contextmanager
def compile_in_turn() -> Iterator[None]:
    """Let one process of a machine at a time compile: the others then find its machine code.

    From the first kernel on that is not found, to the end of this block. Who finds all that it
    needs waits for nobody.
    """
    with contextlib.ExitStack() as turn:
        _turns.append(turn)
        try:
            yield
        finally:
            if turn in _turns:
                _turns.remove(turn)


def take_turn() -> bool:
    """Wait until no other process compiles; return whether this has been the time to do so."""
    if not _turns:
        return False
    _turns.pop().enter_context(_one_process("lock"))
    return True


@contextlib.contextmanager
def _one_process(name: str) -> Iterator[None]:
    """Wait until no other process of this machine holds the lock of a name, or it is stopped."""
    with contextlib.ExitStack() as stack:
        with contextlib.suppress(OSError):  # no lock: each works for itself
            file = stack.enter_context(Path(CACHE_FOLDER, name).open("a"))
            _lock(file)
        yield


def _lock(file: IO[str]) -> None:
    """Lock a file. Raises BlockingIOError where another process does not let go of it."""
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        with event.trigger_event(WAITING_EVENT):
            _wait(file)
    file.truncate(0)
    os.write(file.fileno(), str(os.getpid()).encode())


def _wait(file: IO[str]) -> None:
    """Lock a file that another process has locked, as soon as that lets go of it."""
    end = time.monotonic() + LOCK_SECONDS
    while True:
        if time.monotonic() > end or _is_stopped(file):
            raise BlockingIOError
        time.sleep(POLL_SECONDS)
        with contextlib.suppress(BlockingIOError):
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return


def _is_stopped(file: IO[str]) -> bool:
    """Return whether the process that has locked a file has been stopped (SIGSTOP)."""
    with contextlib.suppress(OSError, IndexError):  # no such process, or no /proc
        pid = Path(file.name).read_text(encoding="ascii")
        status = Path("/proc", pid, "stat").read_text(encoding="utf-8")
        return status.rpartition(")")[2].split()[0] in ("T", "t")
    return False
