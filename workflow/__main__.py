"""``python -m workflow``: see workflow/cli/commands.py."""

import sys

from workflow.system import forgive_streams

forgive_streams()

from workflow.cli import main  # noqa: E402, the streams come first

if __name__ == "__main__":
    sys.exit(main())
