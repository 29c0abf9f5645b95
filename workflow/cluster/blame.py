"""Which workers are to blame: those on which items fail in a row that others compute.

A worker is known by its address. Where workers sit on several hosts, one that fails is taken
for its host: the others there share its disk and memory.
"""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field

from ..system import say
from .pool import Snapshot

IN_A_ROW = 3  # failures that others did not have, before a worker is left out
AGAIN_SECONDS = 30.0  # in which a worker that was lost may be started anew


@dataclass
class Blame:
    """The workers, snapshot after snapshot, and who of them is left out."""

    now: Snapshot = field(default_factory=lambda: Snapshot({}))
    failures: Counter[str] = field(default_factory=Counter)  # in a row, by place
    left_out: set[str] = field(default_factory=set)  # places
    lost: dict[str, float] = field(default_factory=dict)  # when (s), by address
    by_host: bool = False  # whether there are several hosts

    def note(self, snapshot: Snapshot, time: float) -> None:
        """Take note of a snapshot."""
        lost = self.lost | dict.fromkeys(self.now.threads.keys() - snapshot.threads, time)
        self.lost = {
            address: since
            for address, since in lost.items()
            if address not in snapshot.threads and time - since < AGAIN_SECONDS
        }
        self.now = snapshot
        self.by_host = len({address.rpartition(":")[0] for address in snapshot.threads}) > 1

    def fit(self, failed: Iterable[str] = ()) -> list[str]:
        """Return who takes up work, is not left out, and is elsewhere than where it failed."""
        return self._elsewhere(self.now.ready, failed)

    def awaited(self, failed: Iterable[str] = ()) -> bool:
        """Return whether ``fit`` has nobody, but may soon have somebody.

        Nobody is known as yet, or a worker that would be in it was lost just now: a nanny starts
        one anew within seconds.
        """
        lost = self._elsewhere(self.lost, failed)
        return not self.now.threads or (not self.fit(failed) and bool(lost))

    def to_be_given_up(self, failed: list[str]) -> bool:
        """Return whether an item failed at two places, or twice at the only one.

        A failure of which nobody knows where it was counts as a place of its own.
        """
        places = len({self.place(a) for a in failed if a}) + failed.count("")
        return places > 1 or (len(failed) > 1 and not self.fit(failed))

    def place(self, address: str) -> str:
        """Return where a worker is: its host, or on a single host its address."""
        return address.rpartition(":")[0] if self.by_host else address

    def succeeded(self, address: str, failed: Iterable[str]) -> None:
        """Note that a worker computed what workers at ``failed`` could not; leave out whom due."""
        place = self.place(address)
        self.failures.pop(place, None)
        for other in {self.place(other) for other in failed if other} - {place, *self.left_out}:
            self.failures[other] += 1
            if self.failures[other] >= IN_A_ROW:
                self.left_out.add(other)
                say(
                    f"worker {other}: {self.failures[other]} batches in a row failed there and "
                    "went well elsewhere; left out"
                )

    def _elsewhere(self, addresses: Iterable[str], failed: Iterable[str]) -> list[str]:
        avoided = self.left_out | {self.place(address) for address in failed}
        return [address for address in addresses if self.place(address) not in avoided]
