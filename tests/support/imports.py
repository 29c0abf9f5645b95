"""Absolute names of the modules that a file of the repository imports."""

import ast
from importlib.util import resolve_name
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def module_of(node: ast.ImportFrom, path: Path) -> str:
    """Return the absolute name of the module in an import statement of a file."""
    inside = path.resolve().relative_to(ROOT).parent.parts
    package = ".".join(("elastomer_friction", *inside))
    return resolve_name("." * node.level + (node.module or ""), package)
