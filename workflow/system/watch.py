"""Supervision of a run once a second: stop requests, missing workers and missing answers."""

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
MAX_BEAT_SECONDS = 5.0  # longest time counted per check, as this process may have been suspended
QUIET_SECONDS = 4.0  # without an answer, after which the scheduler counts as silent
NO_WORKER, NO_ANSWER = "worker", "answer of the scheduler"  # what a run may lack
TRACEBACK = "Traceback (most recent call last):"
# Time without workers or answers before the first line is printed; doubled for each further line.
FIRST_LINE_SECONDS = {NO_WORKER: 10.0, NO_ANSWER: 30.0}

Listener = Callable[[int, int], None]  # called with (worker threads, items in flight)


def say(line: str) -> None:
    """Print a line for the user to stderr."""
    print(line, file=sys.stderr)


@dataclass
class Watch:
    """State of a stream of work: stop requests, listeners and what it waits for."""

    stop: Callable[[], bool] = lambda: False  # returns True after a stop request
    patience: float = math.inf  # longest wait for workers or answers, s
    listeners: list[Listener] = field(default_factory=list)
    logs: str = ""  # folder of the job logs
    old_logs: set[Path] = field(default_factory=set)  # logs of earlier runs
    lacking: str = ""  # what the work waits for; "": nothing
    waited: float = 0.0  # time waited so far, s
    next_line: float = 0.0  # waited time at which the next line is printed, s
    last_look: float = 0.0  # time of the last look, s

    def __call__(self) -> bool:
        """Return whether a stop was requested, so that no more work may start."""
        return self.stop()

    def follow(self, folder: str) -> None:
        """Report errors of jobs from their logs in ``folder``, ignoring the logs already there."""
        self.logs, self.old_logs = folder, set(Path(folder).glob("*"))

    @contextlib.contextmanager
    def telling(self, listener: Listener) -> Iterator[None]:
        """Call ``listener`` at each ``look`` within this block."""
        self.listeners.append(listener)
        try:
            yield
        finally:
            self.listeners.remove(listener)

    def look(self, threads: int, in_flight: int, lack: str = "") -> None:
        """Call the listeners; add up the time in which work waits for workers, or for ``lack``.

        Raises UserError if the wait exceeds ``patience``.
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
        """Return the error in the newest log of this run that has a traceback, or "".

        Returns "" also if a log cannot be read or is removed meanwhile.
        """
        with contextlib.suppress(OSError):
            logs = {path for path in Path(self.logs).glob("*") if path.is_file()} - self.old_logs
            for path in sorted(logs, key=lambda path: path.stat().st_mtime, reverse=True):
                if error := _error_in(path.read_text(errors="replace")):
                    return f"; {path.name}: {error}"
        return ""


def _error_in(log: str) -> str:
    """Return the error message after the last traceback in a log, or ""."""
    _, marker, rest = log.rpartition(TRACEBACK)
    after = (line for line in rest.splitlines()[1:] if marker and not line.startswith(" "))
    return next(after, "").strip()
