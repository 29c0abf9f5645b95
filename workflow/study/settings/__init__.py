"""How any table of the user is read: checks of single values, lists of values, columns of text.

Knows no table: which keys there are is said where they are used.
"""

from typing import TYPE_CHECKING

from ...lazy import public_names

if TYPE_CHECKING:
    from .checks import (
        REQUIRED,
        UNBOUNDED,
        Key,
        as_table,
        as_text,
        check_keys,
        choice,
        flag,
        integer,
        number,
        positive,
        read_table,
        within,
    )
    from .columns import named_unit, read_columns, rows_of_file
    from .text import BrokenRowError, Rows, read_rows
    from .values import axis_values, checked_values

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
