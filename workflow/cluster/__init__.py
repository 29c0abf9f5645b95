"""Where batches are computed: processes of this machine, jobs, a scheduler; the stream of work.

The only room beside run that knows dask's scheduler.
"""

from typing import TYPE_CHECKING

from ..lazy import public_names

if TYPE_CHECKING:
    from .calls import ROLL, Call, Roll
    from .client import open_client
    from .flow import stream
    from .versions import check_versions, own_versions
    from .watch import Watch
    from .worker import run_batch

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
