"""Ctrl-C and SIGTERM: the first stops taking up work, a later one aborts at once."""

import signal
import sys
import time
from types import FrameType


class Interrupt:
    """Whether the user or the batch system wants this process to stop."""

    BOUNCE_SECONDS = 1.0  # one key press or `timeout` may signal process and group

    def __init__(self) -> None:
        self.asked = 0.0

    def __enter__(self) -> "Interrupt":
        self.previous = {s: signal.signal(s, self._handle) for s in (signal.SIGINT, signal.SIGTERM)}
        return self

    def __exit__(self, *_: object) -> None:
        for number, handler in self.previous.items():
            signal.signal(number, handler)

    def __call__(self) -> bool:
        return self.asked > 0.0

    def _handle(self, number: int, frame: FrameType | None) -> None:
        now = time.monotonic()
        if self.asked and now - self.asked > self.BOUNCE_SECONDS:
            raise KeyboardInterrupt
        if not self.asked:
            self.asked = now
            print("stopping: running batches are finished and stored", file=sys.stderr)
