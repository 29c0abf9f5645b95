"""Detection of sick workers: several items in a row fail there and succeed on other workers.

Workers are identified by address. If there are several hosts, failures are counted per host, since
the workers of a host share disk and memory.
"""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field

from ..cluster import Snapshot
from ..system import say

MAX_CONSECUTIVE_FAILURES = 3  # of items that succeed elsewhere; then the worker is excluded
RESTART_SECONDS = 30.0  # time within which a lost worker is expected to restart


@dataclass
class Blame:
    """Record of worker failures and losses over successive snapshots, by ``place``."""

    now: Snapshot = field(default_factory=lambda: Snapshot({}))  # latest snapshot
    failures: Counter[str] = field(default_factory=Counter)  # consecutive failures, by place
    excluded: set[str] = field(default_factory=set)  # excluded places
    lost: dict[str, float] = field(default_factory=dict)  # time of the loss (s), by address
    by_host: bool = False  # whether workers run on several hosts

    def note(self, snapshot: Snapshot, time: float) -> None:
        """Update the state from a snapshot."""
        lost = self.lost | dict.fromkeys(self.now.threads.keys() - snapshot.threads, time)
        self.lost = {
            address: since
            for address, since in lost.items()
            if address not in snapshot.threads and time - since < RESTART_SECONDS
        }
        self.now = snapshot
        self.by_host = len({address.rpartition(":")[0] for address in snapshot.threads}) > 1

    def fit(self, failed: Iterable[str] = ()) -> list[str]:
        """Return the ready workers outside the excluded places and those of ``failed``."""
        return self._elsewhere(self.now.ready, failed)

    def awaited(self, failed: Iterable[str] = ()) -> bool:
        """Return whether ``fit`` is empty but a suitable worker may soon connect.

        This holds before the first worker connects, and shortly after a suitable worker was lost,
        since its nanny restarts it within seconds.
        """
        lost = self._elsewhere(self.lost, failed)
        return not self.now.threads or (not self.fit(failed) and bool(lost))

    def to_be_given_up(self, failed: list[str]) -> bool:
        """Return whether an item failed at two places, or twice at the only place.

        A failure at an unknown address counts as a place of its own.
        """
        places = len({self.place(a) for a in failed if a}) + failed.count("")
        return places > 1 or (len(failed) > 1 and not self.fit(failed))

    def place(self, address: str) -> str:
        """Return the place of a worker: its host if there are several hosts, else its address."""
        return address.rpartition(":")[0] if self.by_host else address

    def succeeded(self, address: str, failed: Iterable[str]) -> None:
        """Record that a worker computed an item that failed at ``failed``; exclude sick workers."""
        place = self.place(address)
        self.failures.pop(place, None)
        for other in {self.place(other) for other in failed if other} - {place, *self.excluded}:
            self.failures[other] += 1
            if self.failures[other] >= MAX_CONSECUTIVE_FAILURES:
                self.excluded.add(other)
                say(
                    f"worker {other}: {self.failures[other]} consecutive batches failed there and "
                    "succeeded elsewhere; excluded"
                )

    def _elsewhere(self, addresses: Iterable[str], failed: Iterable[str]) -> list[str]:
        avoided = self.excluded | {self.place(address) for address in failed}
        return [address for address in addresses if self.place(address) not in avoided]
