"""``python -m workflow``: see workflow/cli/commands.py.

Python looks for modules in the working folder first. It is left out, here and in the processes
that this one starts, unless the program itself lies there: what lies in a folder that one works
in, perhaps another user's, is data.
"""

import os
import sys
from pathlib import Path

SAFE = sys.flags.safe_path or Path.cwd() == Path(__file__).resolve().parents[1]
if __name__ == "__main__" and not SAFE:
    sys.path.remove(str(Path.cwd()))
    os.environ["PYTHONSAFEPATH"] = "1"

try:
    from workflow.ours import stranger

    if __name__ == "__main__" and (said := stranger()):
        print(f"error: {said}", file=sys.stderr)
        sys.exit(2)
    from workflow.system import THREADS, forgive_streams

    forgive_streams()
    os.environ.update(THREADS)  # before numpy: what is computed here is what a worker computes

    from workflow.cli import main  # the streams come first
except KeyboardInterrupt:  # importing takes seconds
    print("aborted before anything was begun", file=sys.stderr)
    sys.exit(130)

if __name__ == "__main__":
    sys.exit(main())
