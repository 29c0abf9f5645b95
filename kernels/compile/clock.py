"""CPU time of a thread without the time for compilation."""

import threading
import time

from numba.core import event


class _CompilerClock(event.Listener, threading.local):
    """CPU seconds that each thread spends on loading and compiling kernels."""

    depth, seconds = 0, 0.0  # depth: of nested compilations

    def on_start(self, event: event.Event) -> None:
        if self.depth == 0:
            self.seconds -= time.thread_time()
        self.depth += 1

    def on_end(self, event: event.Event) -> None:
        self.depth -= 1
        if self.depth == 0:
            self.seconds += time.thread_time()


_compiler_clock = _CompilerClock()
event.register("numba:compiler_lock", _compiler_clock)  # held while a kernel is loaded or compiled


def computing_seconds() -> float:
    """Return the CPU seconds of this thread, except for loading and compiling kernels."""
    return time.thread_time() - _compiler_clock.seconds
