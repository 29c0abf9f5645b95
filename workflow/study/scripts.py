"""Load the scripts of a study's folder: figure.py, and measure.py of a measured study."""

import importlib
import re
import sys
from pathlib import Path
from types import ModuleType

from workflow.errors import UserError


def load_script(script: Path) -> ModuleType:
    """Return the module of a script, loaded anew; ``from .other import …`` reaches its folder.

    The folder counts as a package of its own, wherever it lies. Raises UserError where there is
    no such file.
    """
    if not script.is_file():
        raise UserError(f"{script}: not found")
    folder = script.resolve().parent
    package = "study" + re.sub(r"\W", "_", str(folder))
    for name in [n for n in sys.modules if n == package or n.startswith(f"{package}.")]:
        del sys.modules[name]
    parent = ModuleType(package)
    parent.__path__ = [str(folder)]
    sys.modules[package] = parent
    importlib.invalidate_caches()
    return importlib.import_module(f"{package}.{script.stem}")
