"""CPU time of computing, without that of compilation."""

import threading
import time

from numba.core import event


class _CompilerClock(event.Listener, threading.local):
    """CPU seconds of each thread for loading and compiling kernels."""

    depth = 0  # of nested compilations
    seconds = 0.0

    def on_start(self, event: event.Event) -> None:
        if self.depth == 0:
            self.seconds -= time.thread_time()
        self.depth += 1

    def on_end(self, event: event.Event) -> None:
        self.depth -= 1
        if self.depth == 0:
            self.seconds += time.thread_time()


_compiler_clock = _CompilerClock()
event.register("numba:compiler_lock", _compiler_clock)  # held to load or to compile a kernel


def computing_seconds() -> float:
    """Return the CPU seconds of this thread without those for loading and compiling kernels."""
    return time.thread_time() - _compiler_clock.seconds
