"""Where batches are computed: processes of this machine, jobs, a scheduler; the stream of work.

The only room beside run that knows dask's scheduler.
"""

from typing import TYPE_CHECKING

from elastomer_friction.workflow.lazy import public_names

if TYPE_CHECKING:
    from elastomer_friction.workflow.cluster.calls import ROLL, Call, Roll
    from elastomer_friction.workflow.cluster.client import open_client
    from elastomer_friction.workflow.cluster.flow import stream
    from elastomer_friction.workflow.cluster.versions import check_versions, own_versions
    from elastomer_friction.workflow.cluster.watch import Watch
    from elastomer_friction.workflow.cluster.worker import run_batch

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
