"""Thresholds of spans against those of the samples, and against steady sliding itself."""

import numpy as np
import pytest

from elastomer_friction.kernels import steady_sliding
from elastomer_friction.kernels.quick.steady.spans import SPAN
from tests.kernels.quick.steady.given import LINES, LOADS, known, line_of, touching


@pytest.mark.parametrize("scheme", ["exponential", "implicit-euler"])
@pytest.mark.parametrize(("hurst", "elements", "m", "speed"), LINES)
def test_thresholds_tell_where_contact_lasts_and_presses(hurst, elements, m, speed, scheme):
    line = line_of(hurst, elements, m)
    law, _, found = known(line, speed, scheme)
    z = line.z
    stay = (z - law.decay * np.roll(z, -1)) / (1.0 - law.decay)
    press = z - speed * line.slope
    count = z.size // SPAN
    for largest, whole, each in [
        (found.stay, found.stay_all, stay),
        (found.press, found.press_all, press),
    ]:
        scale = 1e-12 * np.abs(each).max()
        spans = each[: count * SPAN].reshape(count, SPAN).max(axis=1, initial=-np.inf)
        np.testing.assert_allclose(largest, spans, atol=scale)
        assert whole == pytest.approx(each.max(), abs=scale)


@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize(("hurst", "elements", "m", "speed"), LINES)
def test_the_criterion_of_full_contact_is_exact(hurst, elements, m, speed, load):
    line = line_of(hurst, elements, m)
    law, _, found = known(line, speed)
    (w, d), _ = steady_sliding(law, line.z, load * line.z.size)
    full = load + line.z.mean() > found.stay_all
    assert touching(line.z, w, d).all() == full
    if full:
        assert d == pytest.approx(load + line.z.mean(), rel=1e-12)
