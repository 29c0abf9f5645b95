"""Store of finished block means on the disk: immutable shards, and a journal of their contents.

One process writes, any number may read. A record is identified by (key of its task, block).
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .merge import merge_into
    from .store import DamagedShard, Store, enter_result, is_as_written, store_folder
    from .verify import Verification, holds_a_store
    from .write_buffer import WriteBuffer

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
