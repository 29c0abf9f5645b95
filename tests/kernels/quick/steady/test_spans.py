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
    Spans,
    add_rises,
    spans_of,
)
from elastomer_friction.kernels.quick.steady.stack import (
    alone,
    spans_in,
    spans_of_line,
    stack_of,
    stacked,
)
from tests.kernels.quick.steady.given import LOADS, known, line_of, on_every_line, touching


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


LINES = [line_of(hurst, 77, 2, seed) for seed, hurst in enumerate((0.0, 0.7, 1.0))]


def stack():
    """Return all lines as a stack."""
    return stack_of(stacked([o.z for o in LINES]), stacked([o.slope for o in LINES]))


@pytest.mark.parametrize("spans_at", [spans_of_line, spans_in])
def test_what_is_known_of_the_spans_of_a_line_is_known_in_a_stack(spans_at):
    found = stack()
    for k, line in enumerate(LINES):
        for one, other in zip(spans_at(found, k), spans_of(line.z, line.slope), strict=True):
            np.testing.assert_array_equal(one, other)


def test_what_is_written_into_the_spans_of_a_line_is_in_the_stack():
    found = stack()
    spans_of_line(found, 1).rows[0, RISE] = 5.0
    assert found.rows[1, 0, RISE] == 5.0
    assert np.isnan(found.rows[(0, 2), 0, RISE]).all()


def test_a_line_of_a_stack_is_a_stack():
    one = alone(stack(), 2)
    expected = stack_of(LINES[2].z.reshape(1, -1), LINES[2].slope.reshape(1, -1))
    for own, other in zip(one, expected, strict=True):
        np.testing.assert_array_equal(own, other)
    assert Spans._fields[:-1] == one._fields[2:-1]


def test_a_single_row_is_not_copied():
    row = np.arange(3.0)
    assert np.shares_memory(stacked([row]), row)
    np.testing.assert_array_equal(stacked([row, 2.0 * row]), [row, 2.0 * row])
