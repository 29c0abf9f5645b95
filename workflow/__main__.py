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

from workflow.system import forgive_streams  # noqa: E402, the path comes first

forgive_streams()

from workflow.cli import main  # noqa: E402, the streams come first

if __name__ == "__main__":
    sys.exit(main())
