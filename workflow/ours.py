"""Whether the packages that Python finds by our names are those of this program.

Their names are common; another package of such a name may come first in the path of imports.
The console command runs this file by its path, before anything of a package is imported.
"""

from collections.abc import Iterable
from importlib.util import find_spec
from pathlib import Path

HOME = Path(__file__).resolve().parents[1]  # the folder of kernels, workflow and studies
REMEDY = (
    "rename the other, take it out of PYTHONPATH, or install into an environment of its own "
    "(python3 -m venv)"
)


def stranger(names: Iterable[str] = ("kernels", "studies")) -> str:
    """Return the line that says which package is not ours and what to do; "" where all are."""
    for name in names:
        found = find_spec(name)
        where = Path(found.origin).resolve() if found and found.origin else "no place"
        ours = HOME / name
        if where != ours / "__init__.py":
            return f"Python finds the package {name} at {where}, not ours at {ours}: {REMEDY}"
    return ""
