"""How any table of the user is read: checks, keys, lists of values.

Knows no table: which keys there are is said where they are used.
"""

from typing import TYPE_CHECKING

from ...ground import public_names

if TYPE_CHECKING:
    from .checks import (
        as_table,
        as_text,
        checked_values,
        choice,
        flag,
        integer,
        number,
        one_or_several,
        positive,
        within,
    )
    from .key import Key, check_keys, checked, filled, read_table
    from .pieces import (
        NOT_ZERO,
        NUMBER,
        POSITIVE,
        TEXT,
        Schema,
        pair,
        schema_of,
        table_of,
        values_of,
        values_of_axis,
    )
    from .words import as_toml, default_of

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
