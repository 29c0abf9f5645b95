"""Public names of a room, imported when they are first used.

A room's ``__init__`` names them once, in imports under TYPE_CHECKING, which editors and type
checkers read. Here they are read from there, so that importing a room loads nothing heavy: `plan`
and `status` stay quick, and kernels never meet xarray on a worker.
"""

import ast
from collections.abc import Callable
from importlib import import_module
from importlib.util import resolve_name
from pathlib import Path
from typing import Any

Lookup = Callable[[str], Any]


def public_names(package: str, file: str) -> tuple[list[str], Lookup, Callable[[], list[str]]]:
    """Return ``__all__``, ``__getattr__`` and ``__dir__`` of the package of an ``__init__``."""
    tree = ast.parse(Path(file).read_text(encoding="utf-8"))
    homes = {
        alias.asname or alias.name: ("." * statement.level + str(statement.module), alias.name)
        for block in tree.body
        if isinstance(block, ast.If)
        for statement in block.body
        if isinstance(statement, ast.ImportFrom)
        for alias in statement.names
    }

    def find(name: str) -> Any:
        if name not in homes:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        home, name_there = resolve_name(homes[name][0], package), homes[name][1]
        module = import_module(home)
        if not hasattr(module, name_there):  # a room of a package, not imported yet
            return import_module(f"{home}.{name_there}")
        return getattr(module, name_there)

    return sorted(homes), find, lambda: sorted(homes)
