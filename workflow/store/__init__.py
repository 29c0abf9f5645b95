"""Finished block means on the disk: immutable shards, and a journal that says what they hold.

One process writes, any number read; a record is found by (key of its task, block).
"""

from typing import TYPE_CHECKING

from workflow.lazy import public_names

if TYPE_CHECKING:
    from workflow.store.journal import size
    from workflow.store.merge import merge_into
    from workflow.store.shelf import Shelf
    from workflow.store.store import DamagedShard, Store, store_folder
    from workflow.store.verify import Verified, holds_a_store

__all__, __getattr__ = public_names(__name__, __file__)
