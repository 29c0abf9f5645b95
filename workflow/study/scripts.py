"""Load the Python scripts of a study: figure.py, and measure.py of a measured study."""

import ast
import contextlib
import importlib
import importlib.util
import re
import sys
from pathlib import Path
from types import ModuleType

from ..ground import UserError

BUILT_IN_STUDIES = Path(__file__).resolve().parents[2] / "studies"
FORMER_PACKAGES = ("kernels", "workflow", "studies")  # now subpackages of elastomer_friction
announced_scripts: set[Path] = set()


def load_script(script: Path) -> ModuleType:
    """Load or reload a script and return its module; ``from .other import …`` reads its folder.

    The folder is treated as a package. A note names a script that is not part of this program,
    and its owner, before it runs. Raises UserError if the file does not exist.
    """
    if not script.is_file():
        raise UserError(f"{script}: not found")
    script = script.resolve()
    _check_names(script)
    folder = script.parent
    if BUILT_IN_STUDIES not in script.parents and script not in announced_scripts:
        announced_scripts.add(script)
        owner = f"user {script.stat().st_uid}"
        with contextlib.suppress(KeyError):
            owner = script.owner()
        print(f"note: running {script}, owned by {owner}", file=sys.stderr)
    package = "study" + re.sub(r"\W", "_", str(folder))
    for name in [n for n in sys.modules if n == package or n.startswith(f"{package}.")]:
        del sys.modules[name]
    parent = ModuleType(package)
    parent.__path__ = [str(folder)]
    sys.modules[package] = parent
    importlib.invalidate_caches()
    return importlib.import_module(f"{package}.{script.stem}")


def _check_names(script: Path) -> None:
    """Raise UserError for a script that imports the packages by their former names."""
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
            if top in FORMER_PACKAGES and not _is_foreign(top):
                raise UserError(
                    f"{script}, line {node.lineno}: imports {name}; import "
                    f"elastomer_friction.{name} instead"
                )


def _is_foreign(name: str) -> bool:
    """Return whether another installed program provides a package of this name."""
    spec = importlib.util.find_spec(name)
    if spec is None or spec.origin is None:
        return False
    return BUILT_IN_STUDIES.parent not in Path(spec.origin).resolve().parents
