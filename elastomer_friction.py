"""Console command ``elastomer-friction``: the same as ``python -m workflow``, by a name of its own.

The packages of the program have common names. Where Python finds another package by one of them,
this module still runs, and says in one line what to do.
"""

import os
import sys
from importlib.util import find_spec
from pathlib import Path

REMEDY = (
    "rename the other, take it out of PYTHONPATH, or install into an environment of its own "
    "(python3 -m venv)"
)


def stranger() -> str:
    """Return the line that says which package workflow Python finds; "" where it is ours."""
    found = find_spec("workflow")
    where = Path(found.origin).resolve() if found and found.origin else "no place"
    ours = Path(__file__).resolve().parent / "workflow"
    if where == ours / "__init__.py":
        return ""
    return f"Python finds the package workflow at {where}, not ours at {ours}: {REMEDY}"


def main() -> int:
    """Run one command; return the exit status."""
    said = stranger()
    if not said:
        from workflow import ours

        said = ours.stranger()
    if said:
        print(f"error: {said}", file=sys.stderr)
        return 2
    os.environ["PYTHONSAFEPATH"] = "1"  # as in workflow/__main__.py, for processes that are started
    from workflow.__main__ import main as run

    return run()
