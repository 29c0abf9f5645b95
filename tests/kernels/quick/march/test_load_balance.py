"""Each step of the active-set march has the root of its balance; sums are those of numpy."""

import numpy as np
import pytest

from elastomer_friction.kernels import ConstantForce, lagged_slope, march
from elastomer_friction.kernels.quick.march.active import active_march
from elastomer_friction.kernels.quick.march.load_balance import STRIP, in_order, overlap_of
from tests.kernels.quick.march.given import Jump, setting_of, states_of


@pytest.mark.parametrize("load", [0.001, 0.1, 3.0])
def test_the_indentation_of_every_step_is_that_of_the_plain_march(load):
    setting, force = setting_of(Jump(0.7, 2, load, 10.0, 1.3), 120)
    steps = np.arange(1, 25)
    _, found, _, _, inside = active_march(setting, ConstantForce(force), steps)
    assert inside
    weight = lagged_slope(setting.slope, setting.law.lag)
    cap = setting.z.max() + force
    _, expected, _, _ = march(
        setting.law, ConstantForce(force), setting.z, weight, states_of(setting)[0], steps, cap
    )
    np.testing.assert_allclose(found, expected, rtol=1e-11)


@pytest.mark.parametrize("size", [0, 5, 4 * STRIP - 1, 4 * STRIP, 5 * STRIP + 7])
def test_overlaps_are_those_of_the_touching_elements(size):
    c = np.random.default_rng(5).standard_normal(size)
    depth, count = overlap_of(c, 0.2)
    assert depth == pytest.approx(np.maximum(0.2 - c, 0.0).sum(), rel=1e-12)
    assert count == np.count_nonzero(c < 0.2)


def test_parts_are_added_from_the_first_to_the_last():
    assert in_order(np.array([1.0, 1e100, -1e100])) == 0.0
    assert in_order(np.array([1e100, -1e100, 1.0])) == 1.0
