"""What a worker process does with a batch. Imported by name; needs nothing set up beforehand."""

from workflow.simulate.block_means import block_means
from workflow.simulate.tasks import Batch, BatchResult
from workflow.versions import Versions, require


def run_batch(batch: Batch, expected: Versions) -> BatchResult:
    """Run a batch, if this process runs what the driver runs (else UserError)."""
    require(expected)
    return block_means(batch)
