"""What is listed and what is summed make up what touches."""

import numpy as np
import pytest

from elastomer_friction.kernels import ConstantForce, lagged_slope
from elastomer_friction.kernels.quick.contacts.pressed import weighed_in_fours
from elastomer_friction.kernels.quick.march.bounds import first_bounds
from elastomer_friction.kernels.quick.march.given import a_of
from elastomer_friction.kernels.quick.march.lists import add_sample, add_span, lists_of
from elastomer_friction.kernels.quick.march.load_balance import foresee
from elastomer_friction.kernels.quick.march.runs import classes_of
from elastomer_friction.kernels.quick.steady.spans import SPAN, add_rises, spans_of
from tests.kernels.quick.march.given import Jump, setting_of


@pytest.mark.parametrize("load", [0.01, 0.3, 3.0])
def test_lists_and_sums_carry_the_load_of_the_start_together(load):
    """Were the speed not to change: then D is d (1 - E) at once."""
    setting, force = setting_of(Jump(0.5, 4, load, 10.0, 1.0), 150)
    guess = foresee(ConstantForce(force), setting)
    bounds = first_bounds(setting, guess, 0.1)
    runs, met, sums = classes_of(setting, bounds)
    lists = lists_of(runs, met)
    depth, _, _ = weighed_in_fours(lists.c, None, lists.weight, setting.start.d)
    assert setting.law.stiffness * (depth + sums.depth) == pytest.approx(force, rel=1e-9)
    assert lists.first[-1] == lists.z.size == (runs.top - runs.bottom + 1).sum()


@pytest.mark.parametrize("hurst", [0.0, 1.0])
def test_a_span_is_its_samples_round_the_period(hurst):
    setting, _ = setting_of(Jump(hurst, 4, 0.5, 10.0, 1.2), 4 * SPAN)
    z, level = setting.z + 7.0, 0.4
    setting = setting._replace(z=z, spans=spans_of(z, setting.slope))
    add_rises(setting.spans.rows, z, setting.slope)
    a = a_of(setting.law, z, np.roll(z, -1))
    weight = lagged_slope(setting.slope, setting.law.lag)
    for b in (0, 3, z.size // SPAN - 1):
        own = slice(b * SPAN, (b + 1) * SPAN)
        whole, one_by_one = np.zeros(4), np.zeros(4)
        add_span(setting, level, b, whole)
        for j in range(own.start, own.stop):
            add_sample(level - a[j], weight[j], one_by_one)
        each = level - a[own]
        expected = [SPAN, each.sum(), weight[own].sum(), each @ weight[own]]
        scale = np.abs(each).sum() * np.abs(weight[own]).max()
        np.testing.assert_allclose(whole, expected, rtol=1e-11, atol=1e-13 * scale)
        np.testing.assert_allclose(one_by_one, expected, rtol=1e-11, atol=1e-13 * scale)
