"""Sizes of test problems: smaller where the kernels run as plain Python."""

import numba

PLAIN_PYTHON = bool(numba.config.DISABLE_JIT)


def size(compiled: int, plain: int) -> int:
    """Return the size for compiled kernels, or the smaller one under NUMBA_DISABLE_JIT=1."""
    return plain if PLAIN_PYTHON else compiled
