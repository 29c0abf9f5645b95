"""Sizes of test problems: smaller where the kernels run as plain Python."""

import numba
import pytest

PLAIN_PYTHON = bool(numba.config.DISABLE_JIT)
# Of tests that take seconds to compile a version of kernels that others do not need.
COMPILES_ALONE = () if PLAIN_PYTHON else (pytest.mark.exhaustive,)


def size(compiled: int, plain: int) -> int:
    """Return the size for compiled kernels, or the smaller one under NUMBA_DISABLE_JIT=1."""
    return plain if PLAIN_PYTHON else compiled
