"""Compilation: it computes what Python computes, and lets other threads run."""

import numpy as np
import pytest

from kernels import contact, friction, steady
from kernels.march import march, touchable
from tests.lines import random_line
from tests.sizes import PLAIN_PYTHON

KERNELS = (
    contact.overlap,
    contact.solve_indentation,
    friction.quadrature,
    friction.lagged_slope,
    friction.step_average,
    touchable,
    march,
    steady.sweep,
    steady.steady_sliding,
)
compiled_only = pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")


@compiled_only
@pytest.mark.parametrize("kernel", KERNELS, ids=lambda k: k.__name__)
def test_kernels_release_the_interpreter(kernel):
    """A scheduler must be able to talk to a worker while a kernel runs."""
    assert kernel.targetoptions["nogil"] is True


@compiled_only
def test_machine_code_computes_what_python_computes():
    z, slope = random_line(61, 0.7, 1, seed=4)
    w, d, sweeps = steady.steady_sliding(z, 3.0, 0.4, 1.0 / 0.6)
    w_plain, d_plain, sweeps_plain = steady.steady_sliding.py_func(z, 3.0, 0.4, 1.0 / 0.6)
    # Only the order of sums may differ by vectorization.
    np.testing.assert_allclose(w, w_plain, rtol=1e-14, atol=1e-14)
    assert d == pytest.approx(d_plain, rel=1e-14)
    assert abs(sweeps - sweeps_plain) <= 1
    found = friction.quadrature(z, slope, w, d, 1.0, 1.1, 3.0)
    plain = friction.quadrature.py_func(z, slope, w, d, 1.0, 1.1, 3.0)
    assert found == pytest.approx(plain, rel=1e-13, abs=1e-13)
