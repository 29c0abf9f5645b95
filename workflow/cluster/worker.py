"""What a worker process does with a batch; loaded by every worker when it starts.

Imported by name; needs nothing set up beforehand.
"""

import logging
import signal
from collections.abc import Callable
from typing import Any

from distributed import Status, Worker, get_worker

from ..simulate import Batch, BatchResult, block_means
from .versions import Versions, require

CLOSING = (Status.closing, Status.closed)


def dask_setup(worker: Worker) -> None:
    """Leave Ctrl-C to the driver, which lets running batches finish and be stored.

    Of a worker that closes nothing is logged: a heartbeat that this cuts off is no error.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    logging.getLogger("distributed.worker").addFilter(lambda record: worker.status not in CLOSING)


def run_batch(
    batch: Batch, expected: Versions, work: Callable[[Batch], BatchResult] = block_means
) -> BatchResult:
    """Do the work of a batch, if this process runs what the driver runs (else UserError)."""
    require(expected)
    return work(batch)


def placed(item: Any, function: Callable) -> tuple[str, Any]:
    """Return the address of the worker that this is, and function(item)."""
    try:
        address = get_worker().address
    except ValueError:  # a simulation
        address = ""
    return address, function(item)
