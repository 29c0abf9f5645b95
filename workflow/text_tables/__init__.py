"""Reader of text tables: rows, column names and units, and the selection of columns by quantity.

All commands and file keys share it. It depends on the errors of `ground` and on no part of a study.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .codes import missing_code
    from .numerals import archive_kind, decoded, is_text
    from .remarks import quantity_of
    from .text_table import (
        Column,
        ColumnSpec,
        TextTable,
        describe_columns,
        find_column,
        read_text_table,
        select_columns,
        table_of_text,
    )
    from .titles import UNREAD_NAME, Title, count_named
    from .units import FAMILIES, ZERO, Unit, unit_of

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
