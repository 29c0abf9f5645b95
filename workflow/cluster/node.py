"""Nodes of the graph of a run, and what a pool of workers reports of them."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple


class ResultLost(Exception):
    """Raised if a result could not be fetched from its worker, or if an input of it was lost."""


class WorkerDied(Exception):
    """Raised if ``deaths`` workers died, or retired from their job, while they ran a node."""

    def __init__(self, deaths: int) -> None:
        super().__init__(f"{deaths} different workers died")
        self.deaths = deaths


class Arrival(NamedTuple):
    """The outcome of a node: a value or an error."""

    key: str
    address: str = ""  # address of the worker; "": unknown
    value: Any = None
    error: Exception | None = None


class Snapshot(NamedTuple):
    """The scheduler's view of its workers."""

    threads: dict[str, int]  # number of threads of each worker, by address
    ready: Collection[str] = ()  # addresses that accept work; the others are short of memory
    running: Mapping[str, str] = {}  # key of a node on a worker -> address


@dataclass(eq=False)
class Node:
    """A task of the graph, its inputs, and its state."""

    name: str  # "march" or "fit", the prefix of its key
    item: Any  # argument of its function
    inputs: list["Node"] = field(default_factory=list)  # nodes that it waits for
    given: list["Node"] = field(default_factory=list)  # inputs whose results are sent to it
    result: Any = None  # its future, or in this process its value; None: not submitted, or lost
    done: bool = False  # its value was yielded
    instead: list["Node"] | None = None  # nodes that replace it after it failed
    failed: list[str] = field(default_factory=list)  # addresses at which it raised, or ""
    deaths: int = 0  # of its workers
    workers: Collection[str] = ()  # allowed workers; empty: all
    worker: str = ""  # address in the last snapshot

    def needs(self) -> list["Node"]:
        """Return the nodes that it waits for, failed ones replaced."""
        while any(node.instead is not None for node in self.inputs):
            replaced = ([n] if n.instead is None else n.instead for n in self.inputs)
            self.inputs = [node for nodes in replaced for node in nodes]
        return self.inputs

    def prepare(self) -> bool:
        """Set ``item`` and ``given`` before it is submitted; return whether it is needed."""
        self.given = self.needs()
        return True

    def finish(self) -> None:
        """Note that its value was yielded; let go of what it waited for."""
        self.done, self.inputs, self.given = True, [], []
