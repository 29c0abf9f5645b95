"""``python -m workflow``: see workflow/cli.py."""

import sys

from workflow.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
