"""What a disk refuses for the time being is tried again, for as long as one has patience."""

import errno
import sys
import time
from collections.abc import Callable
from typing import TypeVar

from ..ground import UserError
from .progress import duration

# A file server that comes back, a table of open files or a disk that somebody clears.
_NAMES = "EIO ESTALE ETIMEDOUT EAGAIN EMFILE ENFILE ENOSPC EDQUOT"
PASSING = frozenset(getattr(errno, name) for name in _NAMES.split())
WAITS = (0.1, 10.0)  # s between two attempts, the first and the longest; doubled each time
SILENCE_SECONDS = 30.0  # after the first line about it; then twice as long each time
GRACE_SECONDS = 5.0  # to go on trying once the process is to stop
STEP_SECONDS = 0.2  # between two looks at whether the process is to stop

T = TypeVar("T")


class DiskRetry:
    """Tries again what the disk refuses by an error that may pass; says so at once."""

    def __init__(
        self,
        seconds: float = 0.0,
        stop: Callable[[], bool] = lambda: False,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        """``seconds`` to try for; ``stop`` tells that the process is to end soon."""
        self.seconds, self.stop, self.sleep = seconds, stop, sleep
        self.spent = False  # given up once: what follows is tried a single time

    def __call__(self, attempt: Callable[[], T]) -> T:
        """Return what ``attempt`` does, which raises UserError from what the disk refuses.

        Raises that UserError where the error cannot pass, and once patience is at an end.
        """
        began, wait, next_line = time.monotonic(), WAITS[0], 0.0
        limit = 0.0 if self.spent else self.seconds
        while True:
            try:
                found = attempt()
            except UserError as error:
                if not (passes(error) and limit):
                    raise
                waited = time.monotonic() - began
                if self.stop():
                    limit = min(limit, max(GRACE_SECONDS, waited))
                if waited >= limit:
                    self.spent = True
                    raise UserError(f"{error}; given up after {duration(waited)}") from error
                if waited >= next_line:
                    line = f"warning: {error}; tried again for {duration(limit)} at most"
                    print(line, file=sys.stderr)
                    next_line = max(SILENCE_SECONDS, 2.0 * next_line)
                self._pause(min(wait, limit - waited))
                wait = min(2.0 * wait, WAITS[1])
            else:
                self.spent = False
                return found

    def _pause(self, seconds: float) -> None:
        """Let time pass, but not long once the process is to stop."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0.0 and not (self.stop() and left > 1.0):
            self.sleep(min(left, STEP_SECONDS))


def passes(error: UserError) -> bool:
    """Return whether what the disk refused may be granted later.

    HDF5 does not say why it could not write (RuntimeError).
    """
    cause = error.__cause__
    return isinstance(cause, RuntimeError) or (
        isinstance(cause, OSError) and cause.errno in PASSING
    )
