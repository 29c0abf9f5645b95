"""Lazy imports: the public names of a room are imported on first use.

The ``__init__`` of a room lists its public names once, in imports under TYPE_CHECKING, where
editors and type checkers find them. ``public_names`` reads the same list. Importing a room thus
loads nothing heavy: `plan` and `status` start quickly, and workers never import xarray.
"""

import ast
from collections.abc import Callable
from importlib import import_module
from importlib.util import resolve_name
from pathlib import Path
from typing import Any

Lookup = Callable[[str], Any]


def public_names(
    package: str, file: str, shown: tuple[str, ...] = ()
) -> tuple[list[str], Lookup, Callable[[], list[str]]]:
    """Return ``__all__``, ``__getattr__`` and ``__dir__`` of a package.

    file : its ``__init__``. shown : names for users, which ``__dir__`` lists; by default all.
    """
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
        if not hasattr(module, name_there):  # a submodule that is not imported yet
            return import_module(f"{home}.{name_there}")
        return getattr(module, name_there)

    return sorted(homes), find, lambda: sorted(shown or homes)
