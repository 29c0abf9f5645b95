"""Reader of text tables: rows, column names and units, and the selection of columns by quantity.

All commands and file keys share it. It depends on the errors of `ground` and on no part of a study.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .codes import missing_code
    from .columns import Column, ColumnSpec, describe_columns, find_column, select_columns
    from .headers import UNREAD_NAME, Title, count_named
    from .remarks import quantity_of
    from .text_table import TextTable, read_text_table, table_of_text
    from .units import FAMILIES, ZERO, Unit, unit_of

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
