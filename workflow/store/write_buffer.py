"""Buffer that collects finished batches, so that a shard holds many of them."""

import time
from collections.abc import Callable

from ..ground import UserError
from ..simulate import Batch, BatchResult
from .shard import Finished
from .store import Store

MAX_LOST_SHARE = 1e-3  # share of a run's time that is lost if the driver crashes
MIN_WAIT_SECONDS, MAX_WAIT_SECONDS = 0.2, 120.0
MAX_BUFFER_BYTES = 2**24


class WriteBuffer:
    """Buffer that stores finished batches together, and the remaining ones at its exit.

    At first a shard is written every two batch lengths, later after every thousandth of the elapsed
    time, but at least every MAX_WAIT_SECONDS and whenever the buffer is full.
    """

    def __init__(
        self, store: Store, batch_seconds: float, now: Callable[[], float] = time.monotonic
    ) -> None:
        """Start the buffer. batch_seconds : predicted length of a batch. now : clock, s."""
        self.store, self.now = store, now
        self.min_seconds = max(2.0 * batch_seconds, MIN_WAIT_SECONDS)
        self.waiting: Finished = []
        self.bytes = 0
        self.began = self.stored = now()

    def __enter__(self) -> "WriteBuffer":
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        try:
            self.flush()
        except UserError:
            if kind is None or not issubclass(kind, UserError):
                raise  # otherwise the first error of the run explains its end

    def add(self, batch: Batch, result: BatchResult) -> None:
        """Add a finished batch, which is durable after the next flush."""
        self.waiting.append((batch, result))
        self.bytes += result.scalars.nbytes + result.curves.nbytes
        self.flush_when_due()

    def flush_when_due(self) -> None:
        """Store the waiting batches if they have waited long enough or are large."""
        now = self.now()
        due = min(max(self.min_seconds, MAX_LOST_SHARE * (now - self.began)), MAX_WAIT_SECONDS)
        if self.bytes >= MAX_BUFFER_BYTES or now - self.stored >= due:
            self.flush()

    def flush(self) -> None:
        """Store the waiting batches; if the disk refuses, keep them and raise UserError."""
        self.stored = self.now()
        if self.waiting:
            self.store.add(self.waiting)
            self.waiting, self.bytes = [], 0
