"""netCDF files of unknown origin, read by a process of its own first, which may die of them.

The HDF5 library believes what a file says of itself: lengths that were forged make it loop without
end, ask for all memory or crash, and no exception tells. A file that is read whole here, under a
limit of CPU time and of the machine's memory, can be read by us as well.
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
from .packages import ROOT

SECONDS, BYTES_PER_SECOND = 1.0, 1e7  # of CPU time, for a file and for each variable of it
ENDS: dict[int, str] = {  # signals by which a file ends its reader
    signal.SIGPROF: "reading it does not end",
    **dict.fromkeys((signal.SIGSEGV, signal.SIGABRT, signal.SIGBUS), "reading it ends the process"),
}
LONGEST = 1e4  # s, of what may be forged
BEGUN = "begun"


def unreadable(paths: list[Path]) -> dict[Path, str]:
    """Return path -> why, of those netCDF files that cannot be read whole, as far as is known.

    Raises UserError where no process can be started for it, or where one is ended from outside, as
    for want of memory.
    """
    found: dict[Path, str] = {}
    left = list(paths)
    while left:
        with refused(left[0], "cannot be tried:"):
            done = subprocess.run(
                [sys.executable, "-m", __name__],
                cwd=ROOT,
                input=b"\0".join(os.fsencode(path.absolute()) for path in left),
                capture_output=True,
                start_new_session=True,  # Ctrl-C is for us
            )
            begun, *said = done.stdout.decode().split("\n")[:-1] or [""]
            cause = ENDS.get(-done.returncode)
            if begun != BEGUN or (done.returncode and not cause):
                raise RuntimeError(
                    f"its reader ended with {done.returncode}: {done.stderr[-200:]!r}"
                )
        found |= {path: why for path, why in zip(left, said, strict=False) if why}
        left = left[len(said) :]
        if cause and left:
            found[left.pop(0)] = cause
    return found


def _why_not(content: bytes) -> str:
    """Read all of a netCDF file; return why that cannot be done, or nothing."""
    import netCDF4

    try:
        with netCDF4.Dataset("file.nc", memory=content) as file:
            groups: list[Any] = [file]
            for group in groups:
                groups += group.groups.values()
                for each in (group, *group.variables.values()):
                    for name in each.ncattrs():
                        each.getncattr(name)
                for variable in group.variables.values():
                    variable.set_auto_maskandscale(False)
                    _allow(8 * math.prod(variable.shape))
                    variable[...]
    except MemoryError:
        return "it tells of more than memory holds"
    except Exception as error:  # whatever it is, the file is named with it
        return " ".join(f"{error}".split()) or type(error).__name__
    return ""


def _main() -> None:
    """Print of every file that standard input names why it cannot be read, or an empty line."""
    import netCDF4  # noqa: F401 - before memory is short

    with contextlib.suppress(OSError, ValueError):
        memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    with contextlib.suppress(OSError, ValueError):
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    _say(BEGUN)
    for name in sys.stdin.buffer.read().split(b"\0"):
        why = ""
        with contextlib.suppress(UserError):  # of the disk: its reader will say so
            content = read_whole(Path(os.fsdecode(name)))
            _allow(len(content))
            why = _why_not(content)
        _say(why)


def _allow(size: int) -> None:
    """Let this process end by SIGPROF if it does not come here again in time, for so many bytes."""
    signal.setitimer(signal.ITIMER_PROF, SECONDS + min(size / BYTES_PER_SECOND, LONGEST))


def _say(text: str) -> None:
    sys.stdout.buffer.write(f"{text}\n".encode(errors="replace"))
    sys.stdout.flush()


if __name__ == "__main__":
    _main()
