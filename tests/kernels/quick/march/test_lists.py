"""What is said to touch always does, what is said never to never does; a span is its samples."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, ConstantForce, lagged_slope, solve_indentation
from elastomer_friction.kernels.quick.march.balance import foresee
from elastomer_friction.kernels.quick.march.bounds import first_bounds, holds
from elastomer_friction.kernels.quick.march.lists import add_sample, add_span
from elastomer_friction.kernels.quick.march.runs import classes_of
from elastomer_friction.kernels.quick.march.setting import advance, rise
from elastomer_friction.kernels.quick.steady.spans import SPAN, add_rises, spans_of
from tests.kernels.quick.march.given import Jump, setting_of, states_of
from tests.sizes import size


def listed_of(runs, touching):
    """Return which samples are listed. touching : at some moment within the bounds."""
    found = np.zeros(touching.size, bool)
    for bottom, top in zip(runs.bottom, runs.top, strict=True):
        assert not found[bottom : top + 1].any()
        found[bottom : top + 1] = True
    for top, distance, sure in zip(runs.top, runs.distance, runs.sure, strict=True):
        between = (top + np.arange(1, distance)) % found.size
        assert not (found | touching)[between].any()
        above = (top + distance) % found.size
        assert touching[above] if sure else found[above]
    return found


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("ratio", [0.4, 1.2, 2.5])
@pytest.mark.parametrize("hurst", [0.0, 0.7])
def test_classes_hold_as_long_as_bounds_do(hurst, ratio, scheme):
    seen = np.zeros(3, int)  # samples that never touch, always do, are listed
    for load, x in ((1e-3, 0.3), (0.03, 30.0), (0.5, 3.0), (5.0, 100.0), (25.0, 3.0)):
        for margin in (0.1, 1.0):
            setting, force = setting_of(Jump(hurst, 4, load, x, ratio, scheme), size(80, 30))
            law, d = setting.law, setting.start.d
            bounds = first_bounds(setting, foresee(ConstantForce(force), setting), margin)
            runs, met, sums = classes_of(setting, bounds)
            w = states_of(setting)[0].w
            before = setting.z - w < d
            listed = listed_of(runs, before)
            assert listed.sum() == met.z.size
            assert (before & ~listed).sum() == sums.samples
            seen += [(~before & ~listed).sum(), int(sums.samples), met.z.size]
            u = np.minimum(w, setting.z - d)
            for _ in range(size(100, 20)):
                w, old = law.decay * np.roll(u, -1), d
                d, _ = solve_indentation(setting.z - w, force / law.stiffness, d)
                if not holds(bounds, d, advance(law, d, old)):
                    break
                assert ((setting.z - w < d) == before)[~listed].all()
                u = np.minimum(w, setting.z - d)
    assert (seen > 0).all()


@pytest.mark.parametrize("hurst", [0.0, 1.0])
def test_a_span_is_its_samples_round_the_period(hurst):
    setting, _ = setting_of(Jump(hurst, 4, 0.5, 10.0, 1.2), 4 * SPAN)
    z, level = setting.z + 7.0, 0.4
    setting = setting._replace(z=z, spans=spans_of(z, setting.slope))
    add_rises(setting.spans.rows, z, setting.slope)
    a = rise(setting.law, z, np.roll(z, -1))
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
