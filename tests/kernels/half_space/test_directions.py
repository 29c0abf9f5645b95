"""Restart of stalled search directions, on a map on which they once stalled."""

import numba
import numpy as np
import pytest

from elastomer_friction.kernels import Case, Quantities
from elastomer_friction.kernels.half_space.cases import run_case
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes
from elastomer_friction.workflow.simulate.drawing import line_generator


@pytest.mark.skipif(
    bool(numba.config.DISABLE_JIT), reason="NUMBA_DISABLE_JIT=1: 30 million samples"
)
def test_a_contact_with_stalling_directions_is_solved():
    """H = 0.8, x = 30, one of 1296 maps of the study bodies: no convergence in 20 000 passes."""
    surface = Surface.drawn(line_generator(3, 0.8, 32, 8), ring_amplitudes(0.8, 32, 2), 32, 4)
    case = Case(1.5, 9.60000000000582, (1.0,), (), "exponential")
    result = run_case(surface, case, Quantities(jump=False, relaxation=False))
    assert np.isfinite(result.mu_1)
    assert result.work < 6000 * surface.z.size
