"""Compilation: it computes what Python computes, lets other threads run, and goes by types."""

import os
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import numba
import pytest

from kernels import contact, friction, steady
from kernels.jit import by_type, kernel
from kernels.march import march
from kernels.motion import slide, stretches
from tests.sizes import PLAIN_PYTHON

ROOT = Path(__file__).resolve().parents[2]
KERNELS = (
    contact.overlap,
    contact.solve_indentation,
    friction.quadrature,
    friction.lagged_slope,
    friction.step_average,
    march,
    slide.shift,
    slide.start_rings,
    steady.sweep,
    steady.steady_sliding,
    stretches.touchable,
)
compiled_only = pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")


@compiled_only
@pytest.mark.parametrize("kernel", KERNELS, ids=lambda k: k.__name__)
def test_kernels_release_the_interpreter(kernel):
    """A scheduler must be able to talk to a worker while a kernel runs."""
    assert kernel.targetoptions["nogil"] is True


CASES = """
from kernels import SCHEMES, Quantities, run_case
from tests.cases import CASE, line_of
for scheme in SCHEMES:
    for rate in (True, False):
        found = run_case(line_of(), CASE._replace(scheme=scheme), Quantities(indentation_rate=rate))
        numbers = [found.mu_1, found.indentation, found.contact_fraction]
        for values in (numbers, found.mu_2, found.jump, *found.curves):
            print(*(float(value).hex() for value in values))
"""


def printed(**environment):
    """Return what CASES print in a process of their own: the small lines of plain Python."""
    script = f"import tests.sizes\ntests.sizes.PLAIN_PYTHON = True\n{CASES}"
    process = subprocess.run(
        [sys.executable, "-c", script],
        cwd=ROOT,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=True,
    )
    return process.stdout


@compiled_only
def test_machine_code_computes_what_python_computes_to_the_bit():
    """Sums have a fixed order, and products and sums are rounded one by one."""
    compiled = printed()
    assert compiled.count("\n") == 2 * 2 * 6
    assert compiled == printed(NUMBA_DISABLE_JIT="1")


class Scaled(NamedTuple):
    """A toy law."""

    factor: float


class Shifted(NamedTuple):
    """Another toy law, of other numbers."""

    first: float
    second: float


class Unknown(NamedTuple):
    """A law without a body."""

    number: float


@by_type
def change(law, u):
    """Return u changed."""


@change.of(Scaled)
def _scale(law, u):
    return law.factor / u


@change.of(Shifted)
def _shift(law, u):
    return u + law.first - law.second


@kernel
def changed_twice(law, u):
    """Return u changed twice."""
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


def test_a_declared_function_keeps_its_name_and_words():
    assert change.__name__ == "change"
    assert change.__doc__ == "Return u changed."
    assert change.bodies == {Scaled: _scale, Shifted: _shift}
