"""Spans and their thresholds against the samples themselves; a stacked line is as if alone."""

import numpy as np
import pytest

from elastomer_friction.kernels import steady_sliding
from elastomer_friction.kernels.quick.steady.spans import (
    FIRST,
    HEIGHT,
    RISE,
    SLOPE,
    SPAN,
    SQUARE,
    STEEP,
    TURN,
    WORK,
    add_rises,
)
from tests.kernels.quick.steady.given import (
    LOADS,
    known,
    line_of,
    on_every_line,
    spans_of,
    touching,
)


@on_every_line
def test_sums_are_those_of_the_samples(hurst, elements, m, speed):
    line = line_of(hurst, elements, m)
    _, spans, _ = known(line, speed)
    count = line.z.size // SPAN
    z, s = (values[: count * SPAN].reshape(count, SPAN) for values in line[:2])
    a, c = z - z[:, :1], s - s[:, :1]
    up, turn = (np.roll(f, -1)[: count * SPAN].reshape(count, SPAN) for f in line[:2])
    up, turn = up - z, turn - s
    assert np.isnan(spans.rows[:count, RISE:]).all()
    add_rises(spans.rows, *line[:2])
    rows = spans.rows[:count].T
    for found, expected in [
        (spans.lowest, z.min(axis=1, initial=np.inf)),
        (spans.steepest, np.abs(s).max(axis=1, initial=0.0)),
        (spans.first, z[:, 0]),
        (spans.height, a.sum(axis=1)),
        (rows[FIRST], z[:, 0]),
        (rows[STEEP], s[:, 0]),
        (rows[HEIGHT], a.sum(axis=1)),
        (rows[SLOPE], c.sum(axis=1)),
        (rows[WORK], (a * c).sum(axis=1)),
        (rows[SQUARE], (c * c).sum(axis=1)),
        (rows[RISE], (c * up).sum(axis=1)),
        (rows[TURN], (up * turn).sum(axis=1)),
    ]:
        np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-12)
    a, c = line.z - line.z[0], line.slope - line.slope[0]
    expected = [a.sum(), c.sum(), (a * c).sum(), (c * c).sum()]
    np.testing.assert_allclose(spans.whole, expected, rtol=1e-12, atol=1e-11)
    assert line.z[spans.deepest] == line.z.min()
    after = count * SPAN % line.z.size
    assert (spans.rows[count, [FIRST, STEEP]] == [line.z[after], line.slope[after]]).all()


@pytest.mark.parametrize("samples", [1, 15, 16, 17, 40, 48])
def test_the_deepest_sample_is_the_first_of_the_lowest(samples):
    for seed in range(20):
        z = np.random.default_rng(seed).integers(0, 4, samples).astype(float)
        assert spans_of(z, z).deepest == np.argmin(z)


@pytest.mark.parametrize("scheme", ["exponential", "implicit-euler"])
@on_every_line
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
@on_every_line
def test_the_criterion_of_full_contact_is_exact(hurst, elements, m, speed, load):
    line = line_of(hurst, elements, m)
    law, _, found = known(line, speed)
    (w, d), _ = steady_sliding(law, line.z, load * line.z.size)
    full = load + line.z.mean() > found.stay_all
    assert touching(line.z, w, d).all() == full
    if full:
        assert d == pytest.approx(load + line.z.mean(), rel=1e-12)
