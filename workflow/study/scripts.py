"""Load the scripts of a study's folder: figure.py, and measure.py of a measured study."""

import ast
import contextlib
import importlib
import importlib.util
import re
import sys
from pathlib import Path
from types import ModuleType

from ..ground import UserError

OWN = Path(__file__).resolve().parents[2] / "studies"
MOVED = ("kernels", "workflow", "studies")  # once packages of their own
named: set[Path] = set()  # scripts that the user was told of


def load_script(script: Path) -> ModuleType:
    """Return the module of a script, loaded anew; ``from .other import …`` reaches its folder.

    The folder counts as a package of its own, wherever it lies. A script that is not part of
    this program is named, with its owner, before it runs. Raises UserError where there is no
    such file.
    """
    if not script.is_file():
        raise UserError(f"{script}: not found")
    script = script.resolve()
    _check_names(script)
    folder = script.parent
    if OWN not in script.parents and script not in named:
        named.add(script)
        owner = f"user {script.stat().st_uid}"
        with contextlib.suppress(KeyError):
            owner = script.owner()
        print(f"note: runs {script}, a file of {owner}", file=sys.stderr)
    package = "study" + re.sub(r"\W", "_", str(folder))
    for name in [n for n in sys.modules if n == package or n.startswith(f"{package}.")]:
        del sys.modules[name]
    parent = ModuleType(package)
    parent.__path__ = [str(folder)]
    sys.modules[package] = parent
    importlib.invalidate_caches()
    return importlib.import_module(f"{package}.{script.stem}")


def _check_names(script: Path) -> None:
    """Refuse a script that imports from where the program was before it had one name."""
    tree = ast.parse(script.read_bytes(), script.name)
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and not node.level:
            names = [str(node.module)]
        else:
            continue
        for name in names:
            top = name.partition(".")[0]
            if top in MOVED and not _of_others(top):
                raise UserError(
                    f"{script}, line {node.lineno}: imports {name}, which is now "
                    f"elastomer_friction.{name}"
                )


def _of_others(name: str) -> bool:
    """Return whether a package of that name is there that is not of this program."""
    found = importlib.util.find_spec(name)
    if found is None or found.origin is None:
        return False
    return OWN.parent not in Path(found.origin).resolve().parents
