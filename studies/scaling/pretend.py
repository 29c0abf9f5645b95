"""Batches without kernels: results of the right shape at no cost, or after their predicted time."""

import sys
import time
from collections.abc import Callable

import cloudpickle
import numpy as np

from workflow.simulate.tasks import PHASES, SCALARS, Batch, BatchResult

cloudpickle.register_pickle_by_value(sys.modules[__name__])


def whole(function: Callable[[Batch], BatchResult]) -> Callable[..., BatchResult]:
    """Return a function of this module such that workers, who cannot import it, are sent it."""
    return lambda batch, **_: function(batch)


def pretend(batch: Batch) -> BatchResult:
    """Return a result of zeros that claims the predicted time."""
    shape = (len(batch.tasks), batch.blocks)
    return BatchResult(
        scalars=np.zeros((*shape, len(SCALARS))),
        curves=np.zeros((*shape, batch.samples - 1)),
        spent=np.zeros((len(batch.tasks), len(PHASES))),
        seconds=batch.seconds,
        peak=0,
    )


def sleep_through(batch: Batch) -> BatchResult:
    """Return a result of zeros after the predicted time."""
    time.sleep(batch.seconds)
    return pretend(batch)
