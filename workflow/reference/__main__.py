"""``python -m elastomer_friction.workflow.reference [FOLDER]``: write the reference pages."""

import sys
from pathlib import Path

from . import write_pages

if __name__ == "__main__":
    print(*write_pages(Path((sys.argv[1:] or ["docs/reference"])[0])), sep="\n")
