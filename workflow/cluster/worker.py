"""What a worker process does with a batch; it needs nothing set up beforehand."""

from collections.abc import Callable
from typing import Any

from distributed import get_worker

from ..simulate import Batch, BatchResult, block_means
from ..system import Versions, require

PLACE = "elastomer_friction_worker"  # attribute of an error: where it was raised


def run_batch(
    batch: Batch, expected: Versions, work: Callable[[Batch], BatchResult] = block_means
) -> BatchResult:
    """Do the work of a batch, if this process runs what the driver runs (else UserError)."""
    require(expected)
    return work(batch)


def with_address(item: Any, function: Callable) -> tuple[str, Any]:
    """Return the address of the worker that this is, and function(item); errors say it, too."""
    address = get_worker().address
    try:
        return address, function(item)
    except Exception as error:
        setattr(error, PLACE, address)
        raise
