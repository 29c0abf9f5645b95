"""Buffer of finished batches before they are stored, many to a shard."""

import time
from collections.abc import Callable

from ..ground import UserError
from ..simulate import Batch, BatchResult
from .shard import Finished
from .store import Store

MAX_LOST_SHARE = 1e-3  # of a run's time that a crash of the driver may cost
MAX_WAIT_SECONDS = 120.0
MAX_BUFFER_BYTES = 2**24


class WriteBuffer:
    """Collects finished batches and stores them together; stores the rest at the end.

    A shard is written every few batch lengths at first, then after every thousandth of the elapsed
    time of the run: some thousand shards for a run of days, whatever the number of workers.
    """

    def __init__(
        self, store: Store, batch_seconds: float, now: Callable[[], float] = time.monotonic
    ) -> None:
        """``now`` : the clock (s)."""
        self.store, self.min_seconds, self.now = store, 2.0 * batch_seconds, now
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
        """Take a finished batch; it is durable after the next flush."""
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
        """Store the waiting batches. Raises UserError if the disk refuses; then they stay."""
        self.stored = self.now()
        if self.waiting:
            self.store.add(self.waiting)
            self.waiting, self.bytes = [], 0
