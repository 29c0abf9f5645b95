"""A look at a run every second: whether to stop, and whether there is anyone to wait for."""

import contextlib
import math
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from ..ground import UserError
from .progress import duration

BEAT_SECONDS = 1.0  # between looks
LONGEST_BEAT = 5.0  # that counts: a process that was stopped itself has not been waiting
QUIET_SECONDS = 4.0  # after a stop, a scheduler that does not answer is not waited for longer
NO_WORKER, NO_ANSWER = "worker", "answer of the scheduler"  # what may be lacking
TRACEBACK = "Traceback (most recent call last):"
# Without workers, or answers, before that is said; then twice as long each time.
SILENCE_SECONDS = {NO_WORKER: 10.0, NO_ANSWER: 30.0}

Listener = Callable[[int, int], None]  # is told (worker threads, items in flight)


def say(line: str) -> None:
    """Tell the user."""
    print(line, file=sys.stderr)


@dataclass
class Watch:
    """What a stream of work asks while it goes on."""

    stop: Callable[[], bool] = lambda: False  # whether to take up no more work
    patience: float = math.inf  # s to wait without workers, or for answers
    listeners: list[Listener] = field(default_factory=list)
    logs: str = ""  # folder of the logs of the jobs, where workers are jobs
    old_logs: set[Path] = field(default_factory=set)  # of runs before this one
    lacking: str = ""
    waited: float = 0.0  # s that something has been lacking
    next_line: float = 0.0
    looked: float = 0.0

    def __call__(self) -> bool:
        """Return whether no more work is to be taken up."""
        return self.stop()

    def follow(self, folder: str) -> None:
        """Look from now on for what jobs say in a folder, where they say why they end."""
        self.logs, self.old_logs = folder, set(Path(folder).glob("*"))

    @contextlib.contextmanager
    def telling(self, listener: Listener) -> Iterator[None]:
        """Tell ``listener`` at every look, within this block, how many workers there are."""
        self.listeners.append(listener)
        try:
            yield
        finally:
            self.listeners.remove(listener)

    def look(self, threads: int, in_flight: int, lack: str = "") -> None:
        """Note how many worker threads there are, and what work waits for: workers, or ``lack``.

        Raises UserError when patience ends.
        """
        for listener in self.listeners:
            listener(threads, in_flight)
        lack = lack or ("" if threads else NO_WORKER)
        now = time.monotonic()
        passed, self.looked = min(now - self.looked, LONGEST_BEAT), now
        if lack != self.lacking:
            self.waited = self.waited if lack and self.lacking else 0.0
            self.lacking = lack
            self.next_line = max(SILENCE_SECONDS.get(lack, 0.0), self.waited)
        elif lack:
            self.waited += passed
            self._wait()

    def _wait(self) -> None:
        if self.waited > self.patience:
            said = f"no {self.lacking} for {duration(self.waited)}: given up; run again to resume"
            raise UserError(said)
        if self.waited >= self.next_line:
            until = f", at most {duration(self.patience)}" if self.patience < math.inf else ""
            why = f" (logs of the jobs: {self.logs}{self._last_error()})" if self.logs else ""
            say(f"no {self.lacking} for {duration(self.waited)}{why}: waiting{until}")
            self.next_line = 2.0 * max(self.waited, self.next_line)

    def _last_error(self) -> str:
        """Return the error of the newest log of this run that holds a traceback, or nothing.

        A log that cannot be read, or is taken away meanwhile, ends no run.
        """
        with contextlib.suppress(OSError):
            logs = {path for path in Path(self.logs).glob("*") if path.is_file()} - self.old_logs
            for path in sorted(logs, key=lambda path: path.stat().st_mtime, reverse=True):
                if error := _error_in(path.read_text(errors="replace")):
                    return f"; {path.name}: {error}"
        return ""


def _error_in(log: str) -> str:
    """Return the line that follows the frames of the last traceback of a log, or nothing."""
    _, found, rest = log.rpartition(TRACEBACK)
    after = (line for line in rest.splitlines()[1:] if found and not line.startswith(" "))
    return next(after, "").strip()
