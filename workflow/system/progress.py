"""Progress of long work: a bar with ETA in a terminal, plain lines in a log. On stderr."""

import sys
import time

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

from ..ground import counted

LINE_SECONDS = 30.0
LINE_SHARE = 0.05


class Reporter:
    """Follows work whose size is known as predicted seconds."""

    def __init__(self, what: str, total: float) -> None:
        """``total`` : predicted core-seconds of all work to come."""
        self.what, self.total, self.done = what, max(total, 1e-9), 0.0
        self.crew = ""
        self.began = self.last_time = time.monotonic()
        self.last_share = 0.0
        self.bar: Progress | None = None
        if sys.stderr.isatty():
            columns = (
                TextColumn("{task.description}"),
                BarColumn(),
                TextColumn("{task.percentage:5.1f} %{task.fields[crew]}  left"),
                TimeRemainingColumn(),
            )
            self.bar = Progress(*columns, console=Console(stderr=True))
            self.task = self.bar.add_task(what, total=self.total, crew="")

    def __enter__(self) -> "Reporter":
        if self.bar:
            self.bar.start()
        return self

    def __exit__(self, *_: object) -> None:
        if self.bar:
            self.bar.stop()

    def advance(self, seconds: float) -> None:
        """Count ``seconds`` of predicted work as done."""
        self.done += seconds
        self._show()

    def beat(self, workers: int, failed: int) -> None:
        """Note who works; say so from time to time even when nothing is finished."""
        self.crew = f", {counted(workers, 'worker')}" + (f", {failed} failed" if failed else "")
        self._show()

    def _show(self) -> None:
        if self.bar:
            self.bar.update(self.task, completed=self.done, crew=self.crew)
            return
        now, share = time.monotonic(), min(1.0, self.done / self.total)
        due = now - self.last_time >= LINE_SECONDS or share - self.last_share >= LINE_SHARE
        if due or (share >= 1.0 > self.last_share):
            left = f", {duration((now - self.began) * (1.0 / share - 1.0))} left" if share else ""
            print(f"{self.what}: {share:4.0%}{left}{self.crew}", file=sys.stderr)
            self.last_time, self.last_share = now, share


def duration(seconds: float) -> str:
    """Return a time in words of one unit: 12 s, 3.4 min, 5.6 h, 7.8 d."""
    for size, unit in ((86400.0, "d"), (3600.0, "h"), (60.0, "min")):
        if seconds >= 2.0 * size:
            return f"{seconds / size:.1f} {unit}"
    return f"{seconds:.0f} s"


def core_time(low: float, high: float) -> str:
    """Return an interval of CPU seconds in words: about 35 to 50 core-minutes."""
    sizes = ((86400.0, "days"), (3600.0, "hours"), (60.0, "minutes"), (1.0, "seconds"))
    size, unit = next((s for s in sizes if low * high >= (2.0 * s[0]) ** 2), sizes[-1])
    first, last = (f"{float(f'{seconds / size:.2g}'):g}" for seconds in (low, high))
    return f"about {first} to {last} core-{unit}"
