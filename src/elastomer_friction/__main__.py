"""``elastomer-friction``, ``python -m elastomer_friction``: see workflow/cli/command_line.py.

Python looks for modules in the working folder first. It is left out, here and in the processes
that this one starts, unless the program itself lies there: what lies in a folder that one works
in, perhaps another user's, is data.
"""

import gc
import os
import sys
from pathlib import Path


def main() -> int:
    """Run one command; return the exit status."""
    if not sys.flags.safe_path and Path.cwd() != Path(__file__).parents[1]:
        here = ("", str(Path.cwd()))
        sys.path[:] = [place for place in sys.path if place not in here]
        os.environ["PYTHONSAFEPATH"] = "1"
    # Looking for garbage takes a sixth of the time of importing, which makes none.
    gc.set_threshold(100_000, 20, 100)
    try:
        from elastomer_friction.workflow.system import THREADS, make_streams_tolerant

        make_streams_tolerant()
        os.environ.update(THREADS)  # before numpy: what is computed here is what a worker computes

        from elastomer_friction.workflow.cli import main as run  # the streams come first
    except KeyboardInterrupt:  # importing takes seconds
        print("aborted before the start", file=sys.stderr)
        return 130
    return run()


if __name__ == "__main__":
    sys.exit(main())
