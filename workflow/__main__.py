"""``python -m workflow``: see workflow/cli/commands.py."""

import sys

from workflow.cli import main

if __name__ == "__main__":
    sys.exit(main())
