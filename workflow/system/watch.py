"""Watch over a run every second: requests to stop, and missing workers."""

import contextlib
import math
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from ..ground import UserError
from .progress import duration

BEAT_SECONDS = 1.0  # between two checks
MAX_BEAT_SECONDS = 5.0  # that count as waiting: this process may itself have been stopped
QUIET_SECONDS = 4.0  # to wait after a stop for a scheduler that does not answer
NO_WORKER, NO_ANSWER = "worker", "answer of the scheduler"  # what a run may lack
TRACEBACK = "Traceback (most recent call last):"
# Time without workers or answers before the first line; doubled each time.
FIRST_LINE_SECONDS = {NO_WORKER: 10.0, NO_ANSWER: 30.0}

Listener = Callable[[int, int], None]  # called with (worker threads, items in flight)


def say(line: str) -> None:
    """Print a line for the user."""
    print(line, file=sys.stderr)


@dataclass
class Watch:
    """State of a stream of work: stop requests, listeners and what it waits for."""

    stop: Callable[[], bool] = lambda: False  # whether to start no more work
    patience: float = math.inf  # s to wait without workers, or for answers
    listeners: list[Listener] = field(default_factory=list)
    logs: str = ""  # folder of the logs of jobs
    old_logs: set[Path] = field(default_factory=set)  # of runs before this one
    lacking: str = ""
    waited: float = 0.0  # s since something began to lack
    next_line: float = 0.0
    last_look: float = 0.0

    def __call__(self) -> bool:
        """Return whether to start no more work."""
        return self.stop()

    def follow(self, folder: str) -> None:
        """Read errors of jobs from their logs in a folder from now on."""
        self.logs, self.old_logs = folder, set(Path(folder).glob("*"))

    @contextlib.contextmanager
    def telling(self, listener: Listener) -> Iterator[None]:
        """Call ``listener`` at every look within this block."""
        self.listeners.append(listener)
        try:
            yield
        finally:
            self.listeners.remove(listener)

    def look(self, threads: int, in_flight: int, lack: str = "") -> None:
        """Record the number of worker threads, and what work waits for: workers, or ``lack``.

        Raises UserError when patience ends.
        """
        for listener in self.listeners:
            listener(threads, in_flight)
        lack = lack or ("" if threads else NO_WORKER)
        now = time.monotonic()
        passed, self.last_look = min(now - self.last_look, MAX_BEAT_SECONDS), now
        if lack != self.lacking:
            self.waited = self.waited if lack and self.lacking else 0.0
            self.lacking = lack
            self.next_line = max(FIRST_LINE_SECONDS.get(lack, 0.0), self.waited)
        elif lack:
            self.waited += passed
            self._wait()

    def _wait(self) -> None:
        if self.waited > self.patience:
            raise UserError(
                f"no {self.lacking} for {duration(self.waited)}: given up; run again to resume"
            )
        if self.waited >= self.next_line:
            until = f", at most {duration(self.patience)}" if self.patience < math.inf else ""
            why = f" (logs of the jobs: {self.logs}{self._last_error()})" if self.logs else ""
            say(f"no {self.lacking} for {duration(self.waited)}{why}: waiting{until}")
            self.next_line = 2.0 * max(self.waited, self.next_line)

    def _last_error(self) -> str:
        """Return the error in the newest log of this run with a traceback, or "".

        An unreadable or removed log is ignored.
        """
        with contextlib.suppress(OSError):
            logs = {path for path in Path(self.logs).glob("*") if path.is_file()} - self.old_logs
            for path in sorted(logs, key=lambda path: path.stat().st_mtime, reverse=True):
                if error := _error_in(path.read_text(errors="replace")):
                    return f"; {path.name}: {error}"
        return ""


def _error_in(log: str) -> str:
    """Return the line after the frames of the last traceback of a log, or ""."""
    _, marker, rest = log.rpartition(TRACEBACK)
    after = (line for line in rest.splitlines()[1:] if marker and not line.startswith(" "))
    return next(after, "").strip()
