"""Execution of batches on local processes, batch jobs or a running scheduler.

Only this package and ``run`` import dask's scheduler.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .blame import Blame
    from .client import open_client
    from .flow import Stream
    from .node import Arrival, Node, Snapshot, WorkerDied
    from .pool import Pool
    from .worker import run_batch

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
