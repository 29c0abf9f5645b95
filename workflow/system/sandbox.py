"""Separate processes that read files of unknown origin within limits of CPU time and memory.

Readers trust the lengths stored in a file. Forged lengths can make them loop, allocate all memory
or crash without an exception. A module that reads such files runs as a program of its own: it gets
their paths on standard input, and ends by a signal where it exceeds a limit.
"""

import contextlib
import os
import resource
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from .durable_files import refused
from .packages import PROGRAM_ROOT

READY = b"ready\n"
KILLED = "the process that reads it was killed, as for lack of memory"
FATAL_SIGNALS: dict[int, str] = {
    signal.SIGPROF: "reading it does not end",
    signal.SIGKILL: KILLED,
    **dict.fromkeys((signal.SIGSEGV, signal.SIGABRT, signal.SIGBUS), "reading it ends the process"),
}


def read_apart(module: str, paths: list[Path]) -> tuple[bytes, str]:
    """Run a module that reads files; return its output, and why a signal ended it or "".

    Raises UserError if the process cannot be started, or fails itself.
    """
    with refused(paths[0], "cannot be checked:"):
        process = subprocess.run(
            [sys.executable, "-m", module],
            cwd=PROGRAM_ROOT,
            input=b"\0".join(os.fsencode(path.absolute()) for path in paths),
            capture_output=True,
            start_new_session=True,  # so that Ctrl-C reaches only this process
        )
        fault = FATAL_SIGNALS.get(-process.returncode, "")
        begun = process.stdout.startswith(READY) or fault == KILLED
        if not begun or (process.returncode and not fault):
            raise RuntimeError(
                f"its reader ended with {process.returncode}: {process.stderr[-200:]!r}"
            )
    return process.stdout.removeprefix(READY), fault


def requested_paths() -> list[Path]:
    """Signal ``read_apart`` that all imports are done; return the paths that it sends."""
    answer(READY)
    return [Path(os.fsdecode(name)) for name in sys.stdin.buffer.read().split(b"\0")]


def answer(content: bytes) -> None:
    """Send output to ``read_apart``."""
    sys.stdout.buffer.write(content)
    sys.stdout.flush()


def limit_memory(most: float = float("inf")) -> None:
    """Limit the memory of this process to ``most`` further bytes, or to those of the machine."""
    page = os.sysconf("SC_PAGE_SIZE")
    with contextlib.suppress(OSError, ValueError):
        used = page * int(Path("/proc/self/statm").read_text().split()[0])
        memory = int(min(used + most, page * os.sysconf("SC_PHYS_PAGES")))
        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    with contextlib.suppress(OSError, ValueError):
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def limit_cpu_time(seconds: float) -> None:
    """End this process by SIGPROF after ``seconds`` of CPU time; a new call restarts them."""
    signal.setitimer(signal.ITIMER_PROF, seconds)


@contextlib.contextmanager
def no_files() -> Iterator[None]:
    """Let the opening of any file fail."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (0, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))
