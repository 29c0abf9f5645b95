"""A sweep by spans against the sweep over every sample."""

import numpy as np
import pytest

from elastomer_friction.kernels.quick.steady.spans import SPAN
from tests.kernels.quick.steady.given import LINES, LOADS, both, line_of

EVERYWHERE = pytest.mark.parametrize(("hurst", "elements", "m", "speed"), LINES)


@pytest.mark.parametrize("scheme", ["exponential", "implicit-euler"])
@pytest.mark.parametrize("load", LOADS)
@EVERYWHERE
def test_state_and_forces_are_those_of_the_plain_sweep(hurst, elements, m, speed, load, scheme):
    line = line_of(hurst, elements, m)
    d, plain, expected, w, (total, slope, count, _), _ = both(line, speed, load, scheme)
    np.testing.assert_allclose(w, plain, rtol=1e-12, atol=1e-150)
    # The plain sum loses digits as the stiffness, m vbar and more: 4000 here at most.
    assert (total, slope) == pytest.approx(expected[:2], rel=1e-10 * (1.0 + 1e-3 * d / load))
    assert count == expected[2]


@pytest.mark.parametrize("load", LOADS)
@EVERYWHERE
def test_elements_enter_spans_with_the_displacement_upstream(hurst, elements, m, speed, load):
    line = line_of(hurst, elements, m)
    d, plain, _, _, _, contacts = both(line, speed, load)
    u = np.minimum(plain, line.z - d)
    above = np.append(np.arange(SPAN, line.z.size, SPAN), 0)
    found = contacts.entered[: above.size]
    np.testing.assert_allclose(found, u[above], rtol=1e-12, atol=1e-150)
