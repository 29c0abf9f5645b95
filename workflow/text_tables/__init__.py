"""Reader of text tables: rows of numbers, and the names and units of their columns.

All commands and file keys share it. It depends on the errors of `ground` and on no part of a study.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .cells import split
    from .headers import MAX_TITLE_LINES, UNIT_MARK, UNREAD_NAME, Title, contains_unit
    from .numerals import NUMERAL_TEXT, is_numeral
    from .text_table import TextTable, read_text_table
    from .units import ZERO, Unit, unit_of

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
