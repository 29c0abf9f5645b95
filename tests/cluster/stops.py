"""Processes that are stopped (SIGSTOP) for a while, several of them at once."""

import random
import signal
import threading
from typing import NamedTuple

from tests.cluster.processes import kill

LONGEST = 60.0  # s


class Stop(NamedTuple):
    """A process that is stopped until a timer lets it go on."""

    pid: int
    timer: threading.Timer


class Stops:
    """Stops processes for random times.

    A time is LONGEST u³, u evenly random between 0 and 1: 15 s in the mean, and one in eight is
    longer than 40 s.
    """

    def __init__(self, source: random.Random) -> None:
        """``source`` : of the random times."""
        self.source = source
        self.times: list[float] = []  # s, of all stops
        self.at_once = 0  # stops at one time, at most
        self._open: list[Stop] = []

    def stop(self, pid: int) -> None:
        """Stop a process now; it goes on by itself when its time is over."""
        seconds = LONGEST * self.source.random() ** 3
        kill(pid, signal.SIGSTOP)
        timer = threading.Timer(seconds, kill, (pid, signal.SIGCONT))
        timer.daemon = True
        timer.start()
        self.times.append(seconds)
        self._open = [*(stop for stop in self._open if stop.timer.is_alive()), Stop(pid, timer)]
        self.at_once = max(self.at_once, len(self._open))

    def let_go(self) -> None:
        """Let all go on now."""
        for stop in self._open:
            stop.timer.cancel()
            kill(stop.pid, signal.SIGCONT)
        self._open = []

    def line(self) -> str:
        """Return in words what was stopped."""
        return (
            f"{len(self.times)} stops, {sum(self.times):.0f} s together, the longest "
            f"{max(self.times, default=0.0):.0f} s, up to {self.at_once} at once"
        )
