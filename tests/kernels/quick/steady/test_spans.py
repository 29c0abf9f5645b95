"""Spans against the samples themselves."""

import numpy as np
import pytest

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
    spans_of,
)
from tests.kernels.quick.steady.given import LINES, known, line_of


@pytest.mark.parametrize(("hurst", "elements", "m", "speed"), LINES)
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
