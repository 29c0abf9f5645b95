"""A smooth line between its samples against finer samples of it."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, Line, amplitudes, draw_phases, steady_sliding
from elastomer_friction.kernels.quick.contacts.fine_line import (
    curvatures,
    gaps_of,
    interpolate,
    lowest_between,
    mark_missed,
    mark_touchable,
    marked,
)
from elastomer_friction.kernels.quick.steady.carry import carry, decay_of
from elastomer_friction.kernels.quick.steady.spans import spans_of
from elastomer_friction.kernels.quick.steady.thresholds import thresholds_of

STEPS, ELEMENTS = 4, 100


def line_of(steps):
    """Return the same random line at so many samples per spacing."""
    phases = draw_phases(np.random.default_rng(0), ELEMENTS)
    return Line.self_affine(amplitudes(0.7, ELEMENTS), phases, ELEMENTS, steps)


COARSE = line_of(STEPS)
BEND = curvatures(COARSE.z, COARSE.slope, 1.0 / STEPS)


def test_a_refined_line_is_the_line():
    fold = 8
    fine, at = line_of(STEPS * fold), np.arange(COARSE.z.size)
    heights, slopes = interpolate(COARSE.z, COARSE.slope, BEND, at, 1.0 / STEPS, fold)
    above = COARSE.z[0] + COARSE.datum
    order = np.argmin(np.abs(fine.z[:, None] + fine.datum - above), axis=0)[0]
    z, slope = np.roll(fine.z, -order) + fine.datum - COARSE.datum, np.roll(fine.slope, -order)
    np.testing.assert_allclose(heights, z, atol=2e-4 * np.ptp(z))
    np.testing.assert_allclose(slopes, slope, atol=2e-3 * np.abs(slope).max())


def test_no_interval_is_lower_than_it_is_said_to_be():
    at = np.arange(COARSE.z.size)
    heights, _ = interpolate(COARSE.z, COARSE.slope, BEND, at, 1.0 / STEPS, 16)
    least = [lowest_between(COARSE.z, COARSE.slope, j, 1.0 / STEPS) for j in at]
    # By the cubic through heights and slopes; the rest of the line is a thousandth of its height.
    assert (heights.reshape(-1, 16).min(axis=1) >= np.array(least) - 1e-3).all()


@pytest.mark.parametrize("wide", [1, 2, 8])
def test_marked_intervals_come_so_many_together(wide):
    low = np.zeros(COARSE.z.size, bool)
    low[[3, 4, 5, 200, 399]] = True
    at = marked(low, wide)
    assert set(np.flatnonzero(low)) <= set(at)
    assert (np.diff(at) > 0).all()
    assert at.size % wide == 0
    assert (at[::wide] % wide == 0).all()
    assert at.size <= 3 * wide + 5


def test_whole_spans_that_lie_high_are_passed_by_and_no_interval_of_them_could_touch():
    """Marks against the condition itself, of every interval."""
    load = 0.01 * COARSE.z.size
    state, _ = steady_sliding(SCHEMES["exponential"](1.0 / (STEPS * 5.0)), COARSE.z, load)
    least = [lowest_between(COARSE.z, COARSE.slope, j, 1.0 / STEPS) for j in range(state.w.size)]
    low = np.array(least) - 1.001 * state.d < state.w
    low = low | np.roll(low, 1) | np.roll(low, -1)
    assert 0 < low.sum() < 0.3 * low.size
    spans = spans_of(COARSE.z, COARSE.slope)
    found = mark_touchable(COARSE.z, COARSE.slope, spans, state, 1.0 / STEPS, 1e-3)
    np.testing.assert_array_equal(found, low)


@pytest.mark.parametrize(("fold", "wide"), [(4, 4), (6, 8), (16, 1)])
def test_flight_over_gaps_is_as_over_samples_and_what_it_touches_is_found(fold, wide):
    """Left out: all that does not touch, then a contact as well."""
    speed, load = 5.0, 0.03 * COARSE.z.size
    state, _ = steady_sliding(SCHEMES["exponential"](1.0 / (STEPS * speed)), COARSE.z, load)
    line_spans = spans_of(COARSE.z, COARSE.slope)
    low = mark_touchable(COARSE.z, COARSE.slope, line_spans, state, 1.0 / STEPS, 1e-3)
    law = SCHEMES["exponential"](1.0 / (STEPS * fold * speed))

    def swept(at):
        z, slope = interpolate(COARSE.z, COARSE.slope, BEND, at, 1.0 / STEPS, fold)
        lowest = z.min()
        spans, own = spans_of(z - lowest, slope), thresholds_of(z, slope, speed, law.stiffness)
        gaps = gaps_of(law, at, fold, COARSE.z.size)
        stay = own.stay - lowest
        d = state.d - lowest
        return carry(decay_of(law), z - lowest, spans, stay, d, None, None, gaps), gaps

    def missed(at, gaps):
        line = COARSE.z, COARSE.slope, line_spans, 1.0 / STEPS
        return mark_missed(*line, law.decay**fold, state.d, at, gaps, fold, low)

    (all_of_it, _), at = swept(np.arange(COARSE.z.size)), marked(low, wide)
    found, gaps = swept(at)
    assert at.size < 0.8 * COARSE.z.size
    assert found[2:] == all_of_it[2:]  # touching samples, pieces
    # The line is a little lower over its deepest sample than fine samples are.
    assert found[:2] == pytest.approx(all_of_it[:2], rel=1e-12)
    assert missed(at, gaps) == 0
    deepest = int(np.argmin(COARSE.z))
    low[:] = False
    low[deepest - 5 : deepest + 6] = True
    few = marked(low, wide)
    _, gaps = swept(few)
    assert missed(few, gaps) > 0
    assert low.sum() > 11
