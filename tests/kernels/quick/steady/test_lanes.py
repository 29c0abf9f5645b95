"""Sixteen loads side by side: the sums of each as alone, to the bit."""

import numpy as np
import pytest

from elastomer_friction.kernels.quick.steady.carry import NO_GAPS, carry, decay_of
from elastomer_friction.kernels.quick.steady.lanes import LANES, carry_lanes
from tests.kernels.quick.steady.given import LINES, known, line_of

SEVERAL = np.geomspace(1e-3, 20.0, LANES)  # indentations, of a sample to full contact


@pytest.mark.parametrize("scheme", ["exponential", "implicit-euler"])
@pytest.mark.parametrize(("hurst", "elements", "m", "speed"), LINES)
def test_lanes_do_what_one_sweep_does_whatever_lies_beside(hurst, elements, m, speed, scheme):
    line = line_of(hurst, elements, m)
    law, spans, own = known(line, speed, scheme)
    decay = decay_of(law)
    alone = [carry(decay, line.z, spans, own.stay, d, None, None, NO_GAPS)[:2] for d in SEVERAL]
    for order in (np.arange(LANES), np.arange(LANES)[::-1], np.full(LANES, 5)):
        found = np.array(carry_lanes(decay, line.z, spans, own.stay, SEVERAL[order])).T
        np.testing.assert_array_equal(found, [alone[k] for k in order])


def test_what_has_decayed_is_zero_in_lanes_too():
    """Else subnormal numbers would slow them: a gap of 5000 samples, half left after each."""
    line = line_of(0.7, 64, 1)
    z = np.concatenate([line.z, np.full(5000, 9.0), line.z])
    law, spans, own = known(line._replace(z=z, slope=np.zeros(z.size)), 1.0 / np.log(2.0))
    found = carry_lanes(decay_of(law), z, spans, own.stay, np.full(LANES, 1.0))
    expected = carry(decay_of(law), z, spans, own.stay, 1.0, None, None, NO_GAPS)
    np.testing.assert_array_equal(np.array(found)[:, 0], expected[:2])
