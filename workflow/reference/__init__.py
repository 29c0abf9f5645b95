"""Generated reference pages: keys, commands and the Python interface.

This room may import every other room; `make docs` writes the pages to docs/reference.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .pages import PAGES, write_pages

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
