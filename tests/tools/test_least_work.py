"""The least work that `make bench` prints beside its rows: no more than the kernels do."""

import numpy as np
import pytest

from elastomer_friction.kernels.lines.polynomials import (
    coefficients_between,
    fill_derivatives,
    septic_height,
)
from tests.tools.rivals import limits


class Counted(float):
    """A number that counts what is done with it, but for powers of constants."""

    flops = 0


def counting(operation):
    def counted(one, other):
        Counted.flops += 1
        return Counted(operation(one, float(other)))

    return counted


for name in ("add", "radd", "sub", "rsub", "mul", "rmul", "truediv"):
    setattr(Counted, f"__{name}__", counting(getattr(float, f"__{name}__")))


def flops_of(kernel, *arguments):
    """Return the flops of a kernel that calls no other; arguments : shapes, or numbers."""
    numbers = np.frompyfunc(Counted, 1, 1)
    given = [numbers(np.ones(one)) if isinstance(one, tuple) else one for one in arguments]
    Counted.flops = 0
    getattr(kernel, "py_func", kernel)(*given)
    return Counted.flops


@pytest.mark.parametrize(
    ("least", "done"),
    [
        (
            limits.COEFFICIENTS,
            flops_of(coefficients_between, (4,), (4,), (2, 4), Counted(0.5), 2, 1),
        ),
        (limits.VALUE, flops_of(septic_height, (8,), Counted(0.5))),
        (limits.BENDS, flops_of(fill_derivatives, (5,), (5,), Counted(0.5), range(5), (2, 5))),
    ],
)
def test_least_flops_are_nearly_those_of_the_kernels(least, done):
    assert 0.8 * done < least <= done
