"""Nodes of the graph of a run."""

from collections.abc import Collection
from dataclasses import dataclass, field
from typing import Any

from ..cluster import Call


@dataclass(eq=False)
class Node:
    """A call of the graph, its inputs, and its state."""

    name: str  # "march" or "fit", the name of its function
    item: Any  # argument of its function
    inputs: list["Node"] = field(default_factory=list)  # nodes that must be done before it
    given: list["Node"] = field(default_factory=list)  # inputs whose results are sent to it
    result: Any = None  # its future; None: not submitted, or lost
    done: bool = False  # its value was yielded
    instead: list["Node"] | None = None  # nodes that replace it after it failed
    failed: list[str] = field(default_factory=list)  # addresses at which it raised, or ""
    deaths: int = 0  # of its workers
    workers: Collection[str] = ()  # allowed workers; empty: all
    worker: str = ""  # address in the last snapshot

    def needs(self) -> list["Node"]:
        """Return its inputs, with the replacements of failed ones."""
        while any(node.instead is not None for node in self.inputs):
            replaced = ([n] if n.instead is None else n.instead for n in self.inputs)
            self.inputs = [node for nodes in replaced for node in nodes]
        return self.inputs

    def prepare(self) -> bool:
        """Set ``item`` and ``given`` before it is submitted; return whether it is needed."""
        self.given = self.needs()
        return True

    def call(self) -> Call:
        """Return the call of its function."""
        return Call(self.name, self.item, [node.result for node in self.given])

    def finish(self) -> None:
        """Mark the node as done, and release its inputs."""
        self.done, self.inputs, self.given = True, [], []
