"""Compilation of kernels: same results as Python, dispatch on types, linking into callers."""

import sys
from typing import NamedTuple

import numba
import numpy as np
import pytest
from numba.core.dispatcher import Dispatcher

from elastomer_friction.kernels import SCHEMES, Quantities, run_case
from elastomer_friction.kernels.compile.jit import dispatch_on_type, kernel, refcount_free_kernel
from tests.cases import CASE, line_of
from tests.sizes import PLAIN_PYTHON
from tests.support.python import printed

compiled_only = pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")


@compiled_only
def test_kernels_release_the_interpreter():
    """A scheduler must be able to reach a worker while a kernel runs."""
    ours = "elastomer_friction.kernels"
    modules = [module for name, module in sys.modules.items() if name.startswith(ours)]
    actual = [v for module in modules for v in vars(module).values() if isinstance(v, Dispatcher)]
    assert len(actual) > 20
    assert all(one.targetoptions["nogil"] is True for one in actual)


def numbers():
    """Return all numbers of four cases on a small line, in exact hexadecimal form."""
    lines = []
    for scheme in SCHEMES:
        for rate in (True, False):
            requested, case = Quantities(indentation_rate=rate), CASE._replace(scheme=scheme)
            actual = run_case(line_of(elements=60), case, requested)
            one = [actual.mu_1, actual.indentation, actual.contact_fraction]
            for values in (one, actual.mu_2, actual.jump, *actual.curves):
                lines.append(" ".join(float(value).hex() for value in values))
    return lines


@compiled_only
def test_machine_code_computes_what_python_computes_to_the_bit():
    """Sums have a fixed order, and products and sums are rounded one by one."""
    code = """
from tests.last_bit import perturb
perturb()
from tests.kernels.compile.test_jit import numbers
print(*numbers(), sep="\\n")
"""
    assert len(numbers()) == 2 * 2 * 6
    assert printed("-c", code, NUMBA_DISABLE_JIT="1").splitlines() == numbers()


class Scaled(NamedTuple):
    """A toy law."""

    factor: float


class Shifted(NamedTuple):
    """Another toy law, with other fields."""

    first: float
    second: float


class Unknown(NamedTuple):
    """A law without a body."""

    number: float


@dispatch_on_type
def change(law, u):
    """Return u, changed by the law."""


@change.register(Scaled)
def _scale(law, u):
    return law.factor / u


@change.register(Shifted)
def _shift(law, u):
    return u + law.first - law.second


@kernel
def changed_twice(law, u):
    """Return u, changed twice by the law."""
    return change(law, change(law, u))


@pytest.mark.parametrize("call", [changed_twice, lambda law, u: change(law, change(law, u))])
def test_every_type_has_a_body_of_its_own(call):
    assert call(Scaled(2.0), 5.0) == 5.0
    assert call(Shifted(3.0, 1.0), 5.0) == 9.0


def test_a_type_without_a_body_is_refused():
    with pytest.raises(TypeError, match="change is not defined for Unknown"):
        change(Unknown(1.0), 5.0)
    refused = TypeError if PLAIN_PYTHON else numba.errors.TypingError
    with pytest.raises(refused, match="change"):
        changed_twice(Unknown(1.0), 5.0)


@compiled_only
@pytest.mark.parametrize("compiled", [kernel, numba.njit])
def test_bodies_are_compiled_with_the_flags_of_kernels_whoever_calls(compiled):
    @compiled
    def caller(law, u):
        return change(law, u)

    assert caller(Scaled(2.0), 0.0) == float("inf")


class Pair(NamedTuple):
    """Arrays that kernels pass to other kernels."""

    first: np.ndarray
    second: np.ndarray


@dispatch_on_type
def weigh(pair, i):
    """Return the weight of element i."""


@weigh.register(Pair)
def _weigh(pair, i):
    return pair.first[i] * pair.second[i]


@kernel
def lowest(values):
    """Return the index of the lowest value; numpy raises an error for no values."""
    return np.argmin(values)


@kernel
def total(pair):
    """Return a weighted sum."""
    actual = 0.0
    for i in range(pair.first.size):
        actual += weigh(pair, i)
    return actual


@kernel
def both(pair):
    """Return the results of two other kernels."""
    return total(pair), lowest(pair.first)


@kernel
def twice(pair):
    """Return twice the weighted sum; another caller of ``total``."""
    return 2.0 * total(pair)


@refcount_free_kernel
def first_of(pair):
    """Return the first number, without counting references."""
    return pair.first[0]


PAIR = Pair(np.array([3.0, 1.0, 2.0]), np.array([1.0, 10.0, 100.0]))


@compiled_only
def test_a_kernel_that_is_only_called_by_kernels_gets_no_machine_code_of_its_own():
    assert both(PAIR) == (213.0, 1)
    assert twice(PAIR) == 426.0
    assert len(both.signatures) == len(twice.signatures) == 1
    assert total.signatures == lowest.signatures == []


@compiled_only
def test_it_can_be_called_from_python_and_from_other_compiled_functions_too():
    @numba.njit
    def stranger(pair):
        return both(pair)

    assert stranger(PAIR) == both(PAIR) == (total(PAIR), lowest(PAIR.first))
    assert len(total.signatures) == 1


@compiled_only
def test_an_error_inside_comes_out():
    nothing = Pair(np.empty(0), np.empty(0))
    assert total(nothing) == 0.0
    with pytest.raises(ValueError, match="empty"):
        both(nothing)
