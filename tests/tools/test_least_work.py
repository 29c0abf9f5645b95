"""The least work that `make bench` prints beside its rows: no more than the kernels do."""

import itertools

import numpy as np
import pytest

from elastomer_friction.kernels.lines.polynomials import bends, height, septic
from tests.tools.rivals import limits

OPERATIONS = [a + b for a, b in itertools.product(("", "r"), ("add", "sub", "mul", "truediv"))]


class Counted(float):
    """A number that counts what is done with it; powers cost nothing, as they are of constants."""

    flops = 0


def _counting(name):
    def operation(one, other):
        Counted.flops += 1
        return Counted(getattr(float, name)(one, float(other)))

    return operation


for operation in OPERATIONS:
    setattr(Counted, f"__{operation}__", _counting(f"__{operation}__"))


def flops_of(kernel, *arguments):
    """Return the flops of a kernel that calls no other; arguments : shapes, or numbers."""
    given = [
        np.vectorize(Counted, otypes=[object])(np.ones(one)) if isinstance(one, tuple) else one
        for one in arguments
    ]
    Counted.flops = 0
    getattr(kernel, "py_func", kernel)(*given)
    return Counted.flops


@pytest.mark.parametrize(
    ("least", "done"),
    [
        (limits.COEFFICIENTS, flops_of(septic, (4,), (4,), (4, 2), Counted(0.5), 1)),
        (limits.VALUE, flops_of(height, (8,), Counted(0.5))),
        (8 * limits.BENDS, flops_of(bends, (8,), (8,), Counted(0.5))),
    ],
)
def test_least_flops_are_nearly_those_of_the_kernels(least, done):
    assert 0.8 * done < least <= done
