"""Progress of long work on stderr: a bar on a terminal, otherwise lines for a log."""

import sys
import time

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

from ..ground import counted

MAX_LINE_SECONDS = 30.0  # longest time between two lines of a log
MAX_LINE_SHARE = 0.05  # largest progress between two lines, as a share of the work


class Reporter:
    """Progress of work with a predicted time."""

    def __init__(self, title: str, total: float) -> None:
        """Start at no progress. total : predicted core-seconds of all work."""
        self.title, self.total, self.done = title, max(total, 1e-9), 0.0
        self.workers = ""
        self.began = self.last_time = time.monotonic()
        self.last_share = 0.0
        self.bar: Progress | None = None
        if sys.stderr.isatty():
            columns = (
                TextColumn("{task.description}"),
                BarColumn(),
                TextColumn("{task.percentage:5.1f} %{task.fields[workers]}  left"),
                TimeRemainingColumn(),
            )
            self.bar = Progress(*columns, console=Console(stderr=True))
            self.task = self.bar.add_task(title, total=self.total, workers="")

    def __enter__(self) -> "Reporter":
        if self.bar:
            self.bar.start()
        return self

    def __exit__(self, *_: object) -> None:
        if self.bar:
            self.bar.stop()

    def advance(self, seconds: float, remaining: float | None = None) -> None:
        """Add ``seconds`` of finished work.

        remaining : new estimate of the remaining seconds; None keeps the total.
        """
        self.done += seconds
        if remaining is not None:
            self.total = max(self.done + remaining, 1e-9)
        self._show()

    def beat(self, workers: int, failed: int) -> None:
        """Record the numbers of workers and failures; may print a line even without progress."""
        self.workers = f", {counted(workers, 'worker')}" + (f", {failed} failed" if failed else "")
        self._show()

    def _show(self) -> None:
        if self.bar:
            self.bar.update(self.task, total=self.total, completed=self.done, workers=self.workers)
            return
        now, share = time.monotonic(), min(1.0, self.done / self.total)
        due = now - self.last_time >= MAX_LINE_SECONDS or share - self.last_share >= MAX_LINE_SHARE
        if due or (share >= 1.0 > self.last_share):
            left = f", {duration((now - self.began) * (1.0 / share - 1.0))} left" if share else ""
            print(f"{self.title}: {share:4.0%}{left}{self.workers}", file=sys.stderr)
            self.last_time, self.last_share = now, share


def duration(seconds: float) -> str:
    """Return a time as text in one unit, such as 12 s, 3.4 min, 5.6 h or 7.8 d."""
    for size, unit in ((86400.0, "d"), (3600.0, "h"), (60.0, "min")):
        if seconds >= 2.0 * size:
            return f"{seconds / size:.1f} {unit}"
    return f"{seconds:.0f} s"


def core_time(low: float, high: float) -> str:
    """Return an interval of CPU seconds as text, such as "about 35 to 50 core-minutes"."""
    sizes = ((86400.0, "days"), (3600.0, "hours"), (60.0, "minutes"), (1.0, "seconds"))
    size, unit = next((s for s in sizes if low * high >= (2.0 * s[0]) ** 2), sizes[-1])
    first, last = (f"{float(f'{seconds / size:.2g}'):g}" for seconds in (low, high))
    return f"about {first} to {last} core-{unit}"
