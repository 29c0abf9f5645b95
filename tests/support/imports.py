"""Which modules a file of ours imports from, by their whole names."""

import ast
from importlib.util import resolve_name
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def module_of(node: ast.ImportFrom, path: Path) -> str:
    """Return the whole name of the module from which a file imports."""
    inside = path.resolve().relative_to(ROOT).parent.parts
    package = ".".join(("elastomer_friction", *inside))
    return resolve_name("." * node.level + (node.module or ""), package)
