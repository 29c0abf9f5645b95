"""Base of all rooms: errors, numbers as text, files and their kinds, and lazily imported names.

Imports no other room.
"""

from typing import TYPE_CHECKING

from .lazy import public_names

if TYPE_CHECKING:
    from .errors import (
        ErrorCollector,
        UserError,
        UserErrors,
        counted,
        did_you_mean,
        lacks_memory,
        printable,
    )
    from .file_kinds import decoded, foreign_content, is_text
    from .garbage import garbage_collection_paused
    from .numbers import with_error
    from .plain_files import MAX_INPUT_BYTES, open_plain, read_plain

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
