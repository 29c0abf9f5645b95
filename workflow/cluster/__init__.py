"""Calls of functions on local processes, batch jobs or a running scheduler.

Only this package imports dask's scheduler.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .client import open_client
    from .pool import Pool
    from .remote_call import Arrival, Call, ResultLost, Snapshot, WorkerDied

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
