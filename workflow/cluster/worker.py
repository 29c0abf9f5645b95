"""Functions that run on workers and on the scheduler, which need no setup."""

import pickle
from collections.abc import Collection
from functools import lru_cache
from typing import Any

from distributed import get_worker

ADDRESS_ATTRIBUTE = "elastomer_friction_worker"  # attribute of an error: address of its worker

unpickled = lru_cache(8)(pickle.loads)  # of functions, which are the same for many tasks


def with_address(function: bytes, item: bytes, inputs: list[tuple[str, Any]]) -> tuple[str, Any]:
    """Return the address of this worker and function(item, *values of the inputs).

    Function and item are pickled, so that the scheduler only passes them on. Errors carry the
    address too.
    """
    address = get_worker().address
    try:
        return address, unpickled(function)(pickle.loads(item), *(value for _, value in inputs))
    except Exception as error:
        setattr(error, ADDRESS_ATTRIBUTE, address)
        raise


def forget_tasks(keys: Collection[str], dask_scheduler: Any) -> None:
    """Let a scheduler keep results as data only, so that it computes no lost one again."""
    for key in keys:
        task = dask_scheduler.tasks.get(key)
        if task and task.state == "memory":
            task.run_spec = None
