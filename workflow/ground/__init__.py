"""What every room stands on: the error that is shown as a line, plain files, names of a room.

Imports nothing of ours.
"""

from typing import TYPE_CHECKING

from .lazy import public_names

if TYPE_CHECKING:
    from .errors import ErrorCollector, UserError, UserErrors, counted, did_you_mean, printable
    from .garbage import garbage_collection_paused
    from .plain_files import MOST_BYTES, open_plain, read_plain

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
