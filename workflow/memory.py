"""The most memory that this process has had."""

import contextlib
import resource
import sys
from pathlib import Path


def peak_bytes() -> int:
    """Return the largest resident size of this process so far."""
    # getrusage also counts what the process was before it was given this program.
    with contextlib.suppress(OSError):
        for line in Path("/proc/self/status").read_text(encoding="ascii").splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) * 1024
    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit
