"""What is in flight: each item computed once, or a second time where its worker fell silent."""

from collections.abc import Callable, Collection, Iterable
from dataclasses import dataclass, field
from typing import Any, cast

from distributed import Future
from distributed.scheduler import KilledWorker

from .crew import Crew

DEATHS = 3  # of workers that an item survives, as dask's

# What to do instead of an item that failed with an error, alone in the cluster or not.
Retry = Callable[[Any, Exception, bool], list[Any]]


def raise_error(item: Any, error: Exception, alone: bool) -> list[Any]:
    """Let an error on a worker end the stream; an item whose worker died gets another chance."""
    if isinstance(error, KilledWorker) and not alone:
        return [item]
    raise error


@dataclass
class Copy:
    """One future of an item."""

    future: Future
    workers: Collection[str] = ()  # who alone may have it; none: anybody
    address: str = ""  # of the worker that has it
    stuck: bool = False  # its result does not come


@dataclass(eq=False)
class Work:
    """An item on its way."""

    item: Any
    copies: dict[str, Copy] = field(default_factory=dict)  # by key
    failed: list[str] = field(default_factory=list)  # where it raised: addresses, or ""
    deaths: int = 0  # of workers that had it

    def fail(self, address: str, error: Exception) -> None:
        """Note that a copy raised at an address, or that its workers died."""
        if isinstance(error, KilledWorker):
            self.deaths = max(self.deaths, error.allowed_failures) + 1
        else:
            self.failed.append(address)

    def to_be_tried_again(self, crew: Crew) -> bool:
        """Return whether it has not failed at two places yet, nor twice at the only one.

        A failure of which nobody knows where it was counts as a place of its own.
        """
        places = len({crew.place(a) for a in self.failed if a}) + self.failed.count("")
        if places > 1 or self.deaths > DEATHS:
            return False
        return len(self.failed) < 2 or bool(crew.fit(self.failed))

    def lost(self, gone: Callable[[str], bool]) -> bool:
        """Return whether no copy of it, if there is any, may be expected from who is not gone."""
        copies = self.copies.values()
        return all(copy.stuck or (copy.address and gone(copy.address)) for copy in copies)

    def having(self) -> list[str]:
        """Return the addresses of workers that have it."""
        return [copy.address for copy in self.copies.values()]

    def workers(self, crew: Crew) -> list[str]:
        """Return who is to compute it now: where it did not fail, or else whoever is there."""
        return crew.fit(self.having() + self.failed) or crew.able(self.having())


class Flight:
    """All that is in flight, by the keys of its copies."""

    def __init__(self) -> None:
        self.works: dict[str, Work] = {}

    def __len__(self) -> int:
        """Return the number of copies."""
        return len(self.works)

    def add(self, work: Work, future: Future, workers: Collection[str] = ()) -> None:
        """Take up a copy of an item, which may be for some workers alone."""
        key = str(future.key)
        work.copies[key] = Copy(future, workers)
        self.works[key] = work

    def fall(self, key: str) -> Work | None:
        """Take out a copy that failed; return its item, if it was still waited for."""
        if work := self.works.pop(key, None):
            del work.copies[key]
        return work

    def drop(self, work: Work) -> list[Future]:
        """Wait for no copy of an item any more; return those that still run, or cannot be had."""
        for key in work.copies:
            del self.works[key]
        open_ones = [c for c in work.copies.values() if c.stuck or c.future.status == "pending"]
        return [copy.future for copy in open_ones]

    def note(self, crew: Crew) -> None:
        """Note from a roll call which worker has what."""
        for address, keys in crew.roll.busy.items():
            for copy in self._known(keys):
                copy.address = address

    def stick(self, keys: list[str]) -> None:
        """Note that the results of copies do not come."""
        for copy in self._known(keys):
            copy.stuck = True

    def stranded(self, crew: Crew) -> list[tuple[Future, KilledWorker]]:
        """Return copies for workers that are all gone: they would wait for ever."""
        found = []
        for copy in self._known(crew.roll.stranded):
            key, last = str(copy.future.key), cast(Any, copy)  # of whom an address is known
            if copy.workers:
                found.append((copy.future, KilledWorker(key, last, self.works[key].deaths)))
        return found

    def unbegun(self, crew: Crew) -> list[Work]:
        """Return items that no worker has yet."""
        begun = {key for keys in crew.roll.busy.values() for key in keys}
        return [
            work
            for work in dict.fromkeys(self.works.values())
            if all(c.future.status == "pending" for c in work.copies.values())
            and begun.isdisjoint(work.copies)
        ]

    def lost(self, crew: Crew) -> list[Work]:
        """Return items that only workers have of whom nothing is heard."""
        return [work for work in dict.fromkeys(self.works.values()) if work.lost(crew.quiet)]

    def second_copies(self, crew: Crew) -> list[tuple[Work, list[str]]]:
        """Return items that silent workers alone have, and who is to compute them as well."""
        lost = [w for w in dict.fromkeys(self.works.values()) if w.lost(crew.silent)]
        return [(work, workers) for work in lost if (workers := work.workers(crew))]

    def _known(self, keys: Iterable[str]) -> list[Copy]:
        return [self.works[key].copies[key] for key in keys if key in self.works]
