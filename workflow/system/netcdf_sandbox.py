"""Sandbox for netCDF files of unknown origin, which are first read in a separate process.

The HDF5 library trusts the lengths stored in a file. Forged lengths can make it loop, allocate all
memory or crash without an exception. If the separate process reads a file completely within limits
of CPU time and memory, this process can read it too.
"""

import contextlib
import math
import os
import resource
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

from ..ground import UserError
from .durable_files import read_whole, refused
from .packages import PROGRAM_ROOT

MIN_READ_SECONDS, READ_BYTES_PER_SECOND = 1.0, 1e7  # CPU time for a file and for each variable
MAX_READ_SECONDS = 1e4  # cap on the CPU time in proportion to the size, which may be forged
FATAL_SIGNALS: dict[int, str] = {
    signal.SIGPROF: "reading it does not end",
    **dict.fromkeys((signal.SIGSEGV, signal.SIGABRT, signal.SIGBUS), "reading it ends the process"),
}
READY = "ready"


def unreadable(paths: list[Path]) -> dict[Path, str]:
    """Return the netCDF files that cannot be read completely, as path -> reason.

    Raises UserError if no process can be started, or if it is killed from outside, for instance
    for lack of memory.
    """
    reasons: dict[Path, str] = {}
    remaining = list(paths)
    while remaining:
        with refused(remaining[0], "cannot be checked:"):
            process = subprocess.run(
                [sys.executable, "-m", __name__],
                cwd=PROGRAM_ROOT,
                input=b"\0".join(os.fsencode(path.absolute()) for path in remaining),
                capture_output=True,
                start_new_session=True,  # so that Ctrl-C reaches only this process
            )
            ready, *answers = process.stdout.decode().split("\n")[:-1] or [""]
            cause = FATAL_SIGNALS.get(-process.returncode)
            if ready != READY or (process.returncode and not cause):
                raise RuntimeError(
                    f"its reader ended with {process.returncode}: {process.stderr[-200:]!r}"
                )
        answered = zip(remaining, answers, strict=False)
        reasons |= {path: reason for path, reason in answered if reason}
        remaining = remaining[len(answers) :]
        if cause and remaining:
            reasons[remaining.pop(0)] = cause
    return reasons


def _read_error(content: bytes) -> str:
    """Read a netCDF file completely; return the reason if this fails, otherwise ""."""
    import netCDF4

    try:
        with netCDF4.Dataset("file.nc", memory=content) as file:
            groups: list[Any] = [file]
            for group in groups:
                groups += group.groups.values()
                for owner in (group, *group.variables.values()):
                    for name in owner.ncattrs():
                        owner.getncattr(name)
                for variable in group.variables.values():
                    variable.set_auto_maskandscale(False)
                    _limit_cpu_time(8 * math.prod(variable.shape))
                    variable[...]
    except MemoryError:
        return "it claims more data than fits into memory"
    except Exception as error:  # a forged file can cause any exception
        return " ".join(f"{error}".split()) or type(error).__name__
    return ""


def _main() -> None:
    """Print a line for each file named on standard input: why it is unreadable, or nothing."""
    import netCDF4  # noqa: F401 - before memory is limited

    with contextlib.suppress(OSError, ValueError):
        memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    with contextlib.suppress(OSError, ValueError):
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    _answer(READY)
    for name in sys.stdin.buffer.read().split(b"\0"):
        reason = ""
        with contextlib.suppress(UserError):  # the caller meets and reports the same disk error
            content = read_whole(Path(os.fsdecode(name)))
            _limit_cpu_time(len(content))
            reason = _read_error(content)
        _answer(reason)


def _limit_cpu_time(size: int) -> None:
    """End this process by SIGPROF after the CPU time for ``size`` bytes; a new call restarts it."""
    seconds = MIN_READ_SECONDS + min(size / READ_BYTES_PER_SECOND, MAX_READ_SECONDS)
    signal.setitimer(signal.ITIMER_PROF, seconds)


def _answer(text: str) -> None:
    sys.stdout.buffer.write(f"{text}\n".encode(errors="replace"))
    sys.stdout.flush()


if __name__ == "__main__":
    _main()
