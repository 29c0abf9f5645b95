"""Functions that run on worker processes, which need no setup."""

from collections.abc import Callable
from typing import Any

from distributed import get_worker

from ..simulate import Batch, BatchResult, block_means
from ..system import Versions, require

ADDRESS_ATTRIBUTE = "elastomer_friction_worker"  # attribute of an error: address of its worker


def run_batch(
    batch: Batch, expected: Versions, work: Callable[[Batch], BatchResult] = block_means
) -> BatchResult:
    """Compute a batch. Raises UserError if the versions here differ from those of the driver."""
    require(expected)
    return work(batch)


def with_address(item: Any, function: Callable) -> tuple[str, Any]:
    """Return the address of this worker and function(item); attach the address to any error."""
    address = get_worker().address
    try:
        return address, function(item)
    except Exception as error:
        setattr(error, ADDRESS_ATTRIBUTE, address)
        raise
