"""The one place that decides how kernels are compiled."""

import contextlib
from collections.abc import Callable

import numba

from kernels.cache import CheckedCache

FLAGS = {
    "nogil": True,  # a scheduler must be able to talk to a worker while a kernel runs
    "error_model": "numpy",  # division by zero gives inf as in numpy, loops stay vectorizable
}


def kernel(function: Callable) -> Callable:
    """Compile a function, or leave it as it is under NUMBA_DISABLE_JIT=1."""
    compiled = numba.njit(**FLAGS)(function)
    if compiled is not function:
        with contextlib.suppress(RuntimeError):  # no folder at all can be written
            compiled._cache = CheckedCache(function)
    return compiled
