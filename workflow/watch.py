"""A look at a run every second: whether to stop, and whether there is anyone to wait for."""

import math
import sys
import time
from collections.abc import Callable

from workflow.errors import UserError
from workflow.progress import duration

SILENCE_SECONDS = 10.0  # without workers, before that is said; then twice as long each time


class Watch:
    """What a stream of work asks while it goes on."""

    def __init__(
        self,
        stop: Callable[[], bool] = lambda: False,
        patience: float = math.inf,
        beat: Callable[[int, int], None] = lambda threads, in_flight: None,
    ) -> None:
        """``patience`` : seconds to wait without workers; ``beat`` is told (threads, in flight)."""
        self.stop, self.patience, self.beat = stop, patience, beat
        self.idle_since: float | None = None
        self.next_line = SILENCE_SECONDS

    def __call__(self) -> bool:
        """Return whether no more work is to be taken up."""
        return self.stop()

    def look(self, threads: int, in_flight: int) -> None:
        """Note how many worker threads there are. Raises UserError when patience ends."""
        self.beat(threads, in_flight)
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
