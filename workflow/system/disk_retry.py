"""Retries of disk operations after temporary errors, up to a time limit."""

import errno
import sys
import time
from collections.abc import Callable
from typing import TypeVar

from ..ground import UserError
from .progress import duration

# Errors of a restarting file server, of too many open files, or of a full disk.
_TEMPORARY = "EIO ESTALE ETIMEDOUT EAGAIN EMFILE ENFILE ENOSPC EDQUOT"
TEMPORARY_ERRORS = frozenset(getattr(errno, name) for name in _TEMPORARY.split())
FIRST_PAUSE_SECONDS, MAX_PAUSE_SECONDS = 0.1, 10.0  # between two attempts; doubled each time
FIRST_WARNING_SECONDS = 30.0  # time of the second warning; doubled for each further one
GRACE_SECONDS = 5.0  # time limit of the attempts after a stop request
POLL_SECONDS = 0.2  # between two checks for a stop request

T = TypeVar("T")


class DiskRetry:
    """Callable that retries a disk operation after temporary errors, and warns at the first."""

    def __init__(
        self,
        seconds: float = 0.0,
        stop: Callable[[], bool] = lambda: False,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        """Set the policy. seconds : time limit. stop : returns True after a stop request."""
        self.seconds, self.stop, self.sleep = seconds, stop, sleep
        self.exhausted = False  # after giving up; operations are then tried once, until one works

    def __call__(self, attempt: Callable[[], T]) -> T:
        """Return the result of ``attempt``, which raises UserError if the disk refuses.

        Raises that UserError at once if it is permanent, otherwise after the time limit.
        """
        began, wait, next_warning = time.monotonic(), FIRST_PAUSE_SECONDS, 0.0
        limit = 0.0 if self.exhausted else self.seconds
        while True:
            try:
                result = attempt()
            except UserError as error:
                if not (is_temporary(error) and limit):
                    raise
                waited = time.monotonic() - began
                if self.stop():
                    limit = min(limit, max(GRACE_SECONDS, waited))
                if waited >= limit:
                    self.exhausted = True
                    raise UserError(f"{error}; given up after {duration(waited)}") from error
                if waited >= next_warning:
                    line = f"warning: {error}; tried again for {duration(limit)} at most"
                    print(line, file=sys.stderr)
                    next_warning = max(FIRST_WARNING_SECONDS, 2.0 * next_warning)
                self._pause(min(wait, limit - waited))
                wait = min(2.0 * wait, MAX_PAUSE_SECONDS)
            else:
                self.exhausted = False
                return result

    def _pause(self, seconds: float) -> None:
        """Wait for ``seconds``, or for at most one second after a stop request."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0.0 and not (self.stop() and left > 1.0):
            self.sleep(min(left, POLL_SECONDS))


def is_temporary(error: UserError) -> bool:
    """Return whether a disk error may be temporary.

    A RuntimeError counts as temporary, since HDF5 raises it without a reason if it cannot write.
    """
    cause = error.__cause__
    return isinstance(cause, RuntimeError) or (
        isinstance(cause, OSError) and cause.errno in TEMPORARY_ERRORS
    )
