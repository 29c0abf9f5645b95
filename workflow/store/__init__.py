"""Finished block means on the disk: immutable shards, and a journal that says what they hold.

One process writes, any number read; a record is found by (key of its task, block).
"""

from typing import TYPE_CHECKING

from elastomer_friction.workflow.lazy import public_names

if TYPE_CHECKING:
    from elastomer_friction.workflow.store.journal import size
    from elastomer_friction.workflow.store.merge import merge_into
    from elastomer_friction.workflow.store.shelf import Shelf
    from elastomer_friction.workflow.store.store import DamagedShard, Store, store_folder
    from elastomer_friction.workflow.store.verify import Verified, holds_a_store

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
