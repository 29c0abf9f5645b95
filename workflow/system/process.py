"""This process: when it is to stop, how much memory it has had, how libraries in it behave."""

import contextlib
import ctypes
import resource
import signal
import sys
import time
from functools import cache
from pathlib import Path
from types import FrameType


class Interrupt:
    """Whether the user or the batch system wants this process to stop."""

    BOUNCE_SECONDS = 1.0  # one key press or `timeout` may signal process and group

    def __init__(self) -> None:
        self.asked = 0.0

    def __enter__(self) -> "Interrupt":
        hangup = () if signal.getsignal(signal.SIGHUP) == signal.SIG_IGN else (signal.SIGHUP,)
        numbers = (signal.SIGINT, signal.SIGTERM, *hangup)  # nohup leaves it ignored
        self.previous = {number: signal.signal(number, self._handle) for number in numbers}
        return self

    def __exit__(self, *_: object) -> None:
        for number, handler in self.previous.items():
            signal.signal(number, handler)

    def __call__(self) -> bool:
        """Return whether the process is to stop."""
        return self.asked > 0.0

    def _handle(self, number: int, frame: FrameType | None) -> None:
        now = time.monotonic()
        if self.asked and now - self.asked > self.BOUNCE_SECONDS:
            raise KeyboardInterrupt
        if not self.asked:
            self.asked = now
            print("stopping: running batches are finished and stored", file=sys.stderr)


def peak_bytes() -> int:
    """Return the largest resident size of this process so far."""
    # getrusage also counts what the process was before it was given this program.
    with contextlib.suppress(OSError):
        for line in Path("/proc/self/status").read_text(encoding="ascii").splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) * 1024
    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit


# Libraries must not start threads of their own: cores are shared out, and sums keep their order.
THREADS = {f"{library}_NUM_THREADS": "1" for library in ("OMP", "MKL", "OPENBLAS", "NUMBA")}
# Options of mallopt of the GNU C library, and how many bytes.
FREE_THAT_STAYS = -1, 2**28
LARGEST_THAT_STAYS = -3, 2**25


@cache
def keep_memory() -> bool:
    """Let this process keep the memory of arrays that it frees; return whether it does.

    Kernels allocate the same large arrays again and again. Without this setting page faults add a
    tenth to the time of the kernels, and two fifths in workers as dask sets them up: what is free
    over 64 KiB is given back. Where the C library has no such setting, everything stays as it is.
    """
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None)
    return mallopt is not None and all(
        mallopt(*option) for option in (FREE_THAT_STAYS, LARGEST_THAT_STAYS)
    )
