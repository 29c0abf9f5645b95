"""Nodes of the graph of a run: tasks, and the tasks whose results they need."""

from collections.abc import Collection, Iterator
from dataclasses import dataclass, field
from typing import Any


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

    def leaves(self) -> Iterator["Node"]:
        """Yield this node, or the nodes that replace it."""
        if self.instead is None:
            yield self
        else:
            for node in self.instead:
                yield from node.leaves()

    def needs(self) -> list["Node"]:
        """Return the nodes that it waits for, failed ones replaced."""
        return [leaf for node in self.inputs for leaf in node.leaves()]

    def ready(self) -> bool:
        """Return whether each node that it waits for is done or submitted."""
        return all(node.done or node.result is not None for node in self.needs())

    def prepare(self) -> bool:
        """Set ``item`` and ``given`` before it is submitted; return whether it is needed."""
        self.given = self.needs()
        return True

    def finish(self) -> None:
        """Note that its value was yielded; let go of what it waited for."""
        self.done, self.inputs, self.given = True, [], []
