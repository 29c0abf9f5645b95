"""Public names of a room, imported when they are first used.

A room's ``__init__`` names them once, in imports under TYPE_CHECKING, which editors and type
checkers read. Here they are read from there, so that importing a room loads nothing heavy: `plan`
and `status` stay quick, and kernels never meet xarray on a worker.
"""

import ast
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

from workflow.ours import stranger

if said := stranger():  # every room comes by here
    raise ImportError(said)


def public_names(package: str, file: str) -> tuple[list[str], Callable[[str], Any]]:
    """Return ``__all__`` and ``__getattr__`` of the package whose ``__init__`` is ``file``."""
    tree = ast.parse(Path(file).read_text(encoding="utf-8"))
    homes = {
        alias.asname or alias.name: str(statement.module)
        for block in tree.body
        if isinstance(block, ast.If)
        for statement in block.body
        if isinstance(statement, ast.ImportFrom)
        for alias in statement.names
    }

    def find(name: str) -> Any:
        if name not in homes:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        return getattr(import_module(homes[name]), name)

    return sorted(homes), find
