"""Progress of a round: its report, and the rates and times of what is finished."""

from ..plan import Missing
from ..simulate import Batch, BatchResult
from ..system import Reporter
from .failures import Failures
from .graph import FitNode, Graph
from .measured_rates import MeasuredRates, Remaining
from .status import Status
from .summary import Summary


class Progress:
    """Count of the finished marches and fits of a round."""

    def __init__(
        self, summary: Summary, status: Status, rates: MeasuredRates, failures: Failures
    ) -> None:
        self.summary, self.status, self.rates, self.failures = summary, status, rates, failures

    def begin(self, pieces: list[Missing], graph: Graph) -> Reporter:
        """Begin a round, and return the reporter of its progress."""
        self.remaining = Remaining(pieces, self.rates)
        self.open_fits = len(graph.fits)
        self.fit_seconds = sum(fit.seconds() for fit in graph.fits)  # predicted
        self.reporter = Reporter("computing" if pieces else "fitting", self._left())
        return self.reporter

    def computed(self, batch: Batch, done: BatchResult) -> None:
        """Count a finished batch."""
        self.summary.count(batch, done)
        self.rates.enter(batch, done.seconds)
        self.remaining.finish(batch)
        self.status.rate = self.remaining.rate()
        self.reporter.advance(done.seconds, self._left())

    def fitted(self, fit: FitNode, seconds: float) -> None:
        """Count a finished fit. seconds : its core time."""
        self.summary.phases["fits"] += seconds
        self.open_fits -= 1
        self.fit_seconds -= fit.seconds()
        self.reporter.advance(seconds, self._left())

    def report_workers(self, threads: int) -> None:
        """Report the number of workers; a lack of workers is reported by the watch."""
        if threads:
            self.reporter.beat(threads, self.failures.fresh)

    def _left(self) -> float:
        """Return the remaining core-seconds."""
        fits = max(self.fit_seconds, 0.0) if self.open_fits else 0.0
        return self.remaining.seconds() + fits
