"""What a worker process does with a batch. Imported by name; needs nothing set up beforehand."""

from workflow.batch import Batch, BatchResult, block_means
from workflow.versions import Versions, require


def run_batch(batch: Batch, expected: Versions) -> BatchResult:
    """Run a batch, if this process runs what the driver runs (else UserError)."""
    require(expected)
    return block_means(batch)
