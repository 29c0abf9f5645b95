"""The one reader of text tables, for every door: rows, names and units, columns by what they hold.

Knows the errors of users, and no table of a study.
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
    from .titles import UNREAD, Title, count_named
    from .units import FAMILIES, ZERO, Unit, unit_of

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
