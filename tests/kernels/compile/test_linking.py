"""What kernels call is linked into them: no machine code of its own, numbers and errors alike."""

from typing import NamedTuple

import numba
import numpy as np
import pytest

from elastomer_friction.kernels.compile.jit import by_type, kernel
from tests.sizes import PLAIN_PYTHON

pytestmark = pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")


class Pair(NamedTuple):
    """Arrays that are passed on."""

    first: np.ndarray
    second: np.ndarray


@by_type
def weigh(pair, i):
    """Return the weight of element i."""


@weigh.of(Pair)
def _weigh(pair, i):
    return pair.first[i] * pair.second[i]


@kernel
def lowest(values):
    """Return the number of the lowest value, which numpy refuses to tell of none."""
    return np.argmin(values)


@kernel
def total(pair):
    """Return a weighted sum."""
    found = 0.0
    for i in range(pair.first.size):
        found += weigh(pair, i)
    return found


@kernel
def both(pair):
    """Return what two others give."""
    return total(pair), lowest(pair.first)


@kernel
def twice(pair):
    """Return twice the sum: another caller."""
    return 2.0 * total(pair)


PAIR = Pair(np.array([3.0, 1.0, 2.0]), np.array([1.0, 10.0, 100.0]))


def test_a_kernel_that_is_only_called_by_kernels_gets_no_machine_code_of_its_own():
    assert both(PAIR) == (213.0, 1)
    assert twice(PAIR) == 426.0
    assert len(both.signatures) == len(twice.signatures) == 1
    assert total.signatures == lowest.signatures == []


def test_it_can_be_called_from_python_and_from_other_compiled_functions_too():
    @numba.njit
    def stranger(pair):
        return both(pair)

    assert stranger(PAIR) == both(PAIR) == (total(PAIR), lowest(PAIR.first))
    assert len(total.signatures) == 1


def test_an_error_inside_comes_out():
    nothing = Pair(np.empty(0), np.empty(0))
    assert total(nothing) == 0.0
    with pytest.raises(ValueError, match="empty"):
        both(nothing)
