"""Which pages of reference there are, and how they are written."""

from collections.abc import Callable
from pathlib import Path

from .commands import commands_page
from .index import index_page
from .keys import keys_page
from .results import results_page

PAGES: dict[str, Callable[[], str]] = {
    "README.md": index_page,
    "commands.md": commands_page,
    "keys.md": keys_page,
    "results.md": results_page,
}
NOTE = "<!-- Written by `make docs` from the tables in the code; change the texts there. -->\n\n"


def write_pages(folder: Path) -> list[Path]:
    """Write every page to a folder, which is made if need be; return their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, page in PAGES.items():
        (folder / name).write_text(NOTE + page().rstrip() + "\n", encoding="utf-8")
    return [folder / name for name in PAGES]
