"""Finished batches on their way into the store: many to a shard, none kept back for long."""

import time
from collections.abc import Callable

from ..ground import UserError
from ..simulate import Batch, BatchResult
from .shard import Finished
from .store import Store

SHARE_OF_RUN = 1e-3  # of a run's time that a crash of the driver may cost
LONGEST_SECONDS = 120.0
MOST_BYTES = 2**24


class WriteBuffer:
    """Gathers finished batches and stores them together; stores what is left at the end.

    A shard is written every few batch lengths at first, then every thousandth of the time the
    run has taken: some thousand shards for a run of days, whatever the number of workers.
    """

    def __init__(
        self, store: Store, batch_seconds: float, now: Callable[[], float] = time.monotonic
    ) -> None:
        """``now`` : tells the time (s)."""
        self.store, self.least, self.now = store, 2.0 * batch_seconds, now
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
                raise  # or what ends the run anyway says why

    def add(self, batch: Batch, result: BatchResult) -> None:
        """Take a finished batch; it is durable after the next flush."""
        self.waiting.append((batch, result))
        self.bytes += result.scalars.nbytes + result.curves.nbytes
        self.flush_when_due()

    def flush_when_due(self) -> None:
        """Store what waits if it has waited long enough or is much."""
        now = self.now()
        due = min(max(self.least, SHARE_OF_RUN * (now - self.began)), LONGEST_SECONDS)
        if self.bytes >= MOST_BYTES or now - self.stored >= due:
            self.flush()

    def flush(self) -> None:
        """Store whatever waits. Raises UserError when the disk refuses it; then it waits on."""
        self.stored = self.now()
        if self.waiting:
            self.store.add(self.waiting)
            self.waiting, self.bytes = [], 0
