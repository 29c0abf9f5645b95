"""A look at a run every second: whether to stop, and whether there is anyone to wait for."""

import math
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from workflow.errors import UserError
from workflow.system import duration

SILENCE_SECONDS = 10.0  # without workers, before that is said; then twice as long each time

Listener = Callable[[int, int], None]  # is told (worker threads, items in flight)


@dataclass
class Watch:
    """What a stream of work asks while it goes on."""

    stop: Callable[[], bool] = lambda: False  # whether to take up no more work
    patience: float = math.inf  # s to wait without workers
    listeners: list[Listener] = field(default_factory=list)
    idle_since: float | None = None
    next_line: float = SILENCE_SECONDS

    def __call__(self) -> bool:
        """Return whether no more work is to be taken up."""
        return self.stop()

    @contextmanager
    def telling(self, listener: Listener) -> Iterator[None]:
        """Tell ``listener`` at every look, within this block, how many workers there are."""
        self.listeners.append(listener)
        try:
            yield
        finally:
            self.listeners.remove(listener)

    def look(self, threads: int, in_flight: int) -> None:
        """Note how many worker threads there are. Raises UserError when patience ends."""
        for listener in self.listeners:
            listener(threads, in_flight)
        now = time.monotonic()
        if threads:
            self.idle_since, self.next_line = None, SILENCE_SECONDS
            return
        self.idle_since = now if self.idle_since is None else self.idle_since
        waited = now - self.idle_since
        if waited > self.patience:
            raise UserError(f"no worker for {duration(waited)}: given up; run again to resume")
        if waited >= self.next_line:
            until = f", at most {duration(self.patience)}" if self.patience < math.inf else ""
            print(f"no worker for {duration(waited)}: waiting{until}", file=sys.stderr, flush=True)
            self.next_line *= 2.0
