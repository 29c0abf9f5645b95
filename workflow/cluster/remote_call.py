"""Calls of named functions on workers, and what a pool of workers reports of them."""

from collections.abc import Collection, Mapping
from typing import Any, NamedTuple


class ResultLost(Exception):
    """Raised if a result could not be fetched from its worker, or if an input of it was lost."""


class WorkerDied(Exception):
    """Raised if ``deaths`` workers died, or retired from their job, during a call."""

    def __init__(self, deaths: int) -> None:
        super().__init__(f"{deaths} different workers died")
        self.deaths = deaths


class Call(NamedTuple):
    """A call of a function with an item and the results of other calls."""

    name: str  # name of the function, and the prefix of the key
    item: Any
    inputs: list[Any]  # futures of other calls


class Arrival(NamedTuple):
    """The outcome of a call: a value or an error."""

    key: str
    address: str = ""  # address of the worker; "": unknown
    value: Any = None
    error: Exception | None = None


class Snapshot(NamedTuple):
    """The scheduler's view of its workers."""

    threads: dict[str, int]  # number of threads of each worker, by address
    ready: Collection[str] = ()  # addresses that accept work; the others are short of memory
    running: Mapping[str, str] = {}  # key of a call on a worker -> address
