"""The clock of the work: CPU time of a thread, but for what loading machine code takes."""

import threading
import time

from numba.core import event

KIND = "numba:compiler_lock"  # held while a kernel is looked for in the cache, or compiled


class _Thread(threading.local):
    depth = 0  # kernels are compiled within one another
    began = 0.0
    lost = 0.0  # CPU seconds


class _Listener(event.Listener):
    def on_start(self, event: event.Event) -> None:
        """Note when the outermost begins."""
        if own.depth == 0:
            own.began = time.thread_time()
        own.depth += 1

    def on_end(self, event: event.Event) -> None:
        """Leave out what has passed since the outermost began."""
        own.depth -= 1
        if own.depth == 0:
            own.lost += time.thread_time() - own.began


own = _Thread()
event.register(KIND, _Listener())


def computing_seconds() -> float:
    """Return the CPU seconds of this thread that went into computing.

    The first realization of a process loads machine code, which tells nothing of the next ones.
    """
    return time.thread_time() - own.lost
