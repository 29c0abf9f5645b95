"""Where batches are computed: processes of this machine, jobs, a scheduler; the stream of work.

The only room beside run that knows dask's scheduler.
"""

from typing import TYPE_CHECKING

from workflow.lazy import public_names

if TYPE_CHECKING:
    from workflow.cluster.calls import ROLL, Call, Roll
    from workflow.cluster.client import open_client
    from workflow.cluster.flow import stream
    from workflow.cluster.versions import check_versions, own_versions
    from workflow.cluster.watch import Watch
    from workflow.cluster.worker import run_batch

__all__, __getattr__ = public_names(__name__, __file__)
