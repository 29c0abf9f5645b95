"""Console command ``elastomer-friction``: the same as ``python -m workflow``, by a name of its own.

The packages of the program have common names. Where Python finds another package by one of them,
this module still runs, and says in one line what to do.
"""

import os
import runpy
import sys
from pathlib import Path

OURS = Path(__file__).resolve().parent / "workflow" / "ours.py"


def main() -> int:
    """Run one command; return the exit status."""
    said = runpy.run_path(str(OURS))["stranger"](("workflow", "kernels", "studies"))
    if said:
        print(f"error: {said}", file=sys.stderr)
        return 2
    os.environ["PYTHONSAFEPATH"] = "1"  # as in workflow/__main__.py, for processes that are started
    from workflow.__main__ import main as run

    return run()
