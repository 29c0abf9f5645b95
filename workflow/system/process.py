"""Properties of this process: stop requests, peak memory, threads and allocator settings."""

import contextlib
import ctypes
import mmap
import resource
import signal
import sys
import time
from functools import cache
from pathlib import Path
from types import FrameType


class Interrupt:
    """Signal handlers that record a stop request; a second request raises KeyboardInterrupt."""

    BOUNCE_SECONDS = 1.0  # signals within this time count as one request

    def __init__(self) -> None:
        self.requested = 0.0  # time of the stop request, s; 0: none

    def __enter__(self) -> "Interrupt":
        ignored = signal.getsignal(signal.SIGHUP) == signal.SIG_IGN  # by nohup
        hangup = () if ignored else (signal.SIGHUP,)
        numbers = (signal.SIGINT, signal.SIGTERM, *hangup)
        self.previous = {number: signal.signal(number, self._handle) for number in numbers}
        return self

    def __exit__(self, *_: object) -> None:
        for number, handler in self.previous.items():
            signal.signal(number, handler)

    def __call__(self) -> bool:
        """Return whether a stop was requested."""
        return self.requested > 0.0

    def _handle(self, number: int, frame: FrameType | None) -> None:
        now = time.monotonic()
        if self.requested and now - self.requested > self.BOUNCE_SECONDS:
            raise KeyboardInterrupt
        if not self.requested:
            self.requested = now
            print("stopping: running batches are finished and stored", file=sys.stderr)


def peak_bytes() -> int:
    """Return the peak resident memory of this process so far, in bytes."""
    # Preferred to getrusage, which includes the memory of the process before exec.
    with contextlib.suppress(OSError):
        for line in Path("/proc/self/status").read_text(encoding="ascii").splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) * 1024
    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit


def require_memory(size: int) -> None:
    """Raise MemoryError unless ``size`` bytes are free, without which a library may crash."""
    try:
        mmap.mmap(-1, size).close()
    except OSError as error:
        raise MemoryError(str(error)) from error


# Libraries must not start threads, so that workers share the cores and sums keep their order.
THREADS = {f"{library}_NUM_THREADS": "1" for library in ("OMP", "MKL", "OPENBLAS", "NUMBA")}
# Options of mallopt (GNU C library): (number of the option, value in bytes).
TRIM_THRESHOLD = -1, 2**28
MMAP_THRESHOLD = -3, 2**25


@cache
def keep_memory() -> bool:
    """Keep the memory of freed arrays in this process; return whether the C library supports it.

    Kernels allocate the same large arrays repeatedly. Without this setting, page faults add 10 % to
    the time of the kernels, and 40 % in workers, where dask lets the allocator return free memory
    above 64 KiB to the system.
    """
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None)
    return mallopt is not None and all(
        mallopt(*option) for option in (TRIM_THRESHOLD, MMAP_THRESHOLD)
    )
