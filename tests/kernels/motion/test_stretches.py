"""Stretches that can touch: all of the line below the cap, long gaps left out."""

import numpy as np
import pytest

from elastomer_friction.kernels.motion.stretches import SHORT_GAP, bounds, gather, touchable
from tests.lines import random_line


def test_stretches_cover_exactly_what_can_touch():
    z, _ = random_line(400, 0.2, 1, seed=2)
    for cap in np.quantile(z, [0.005, 0.02, 0.3, 0.9]):
        start, stop = touchable(z, cap)
        inside = np.zeros(z.size, bool)
        for a, b in zip(start, stop, strict=True):
            inside[a:b] = True
            assert z[a] < cap
            assert z[b - 1] < cap
        assert np.all(z[~inside] >= cap)
        assert np.all(start[1:] - stop[:-1] > SHORT_GAP)
    start, stop = touchable(z, np.inf)
    assert (start.tolist(), stop.tolist()) == ([0], [z.size])


@pytest.mark.parametrize("gap", [SHORT_GAP, SHORT_GAP + 1])
def test_a_gap_is_left_out_from_one_sample_beyond_a_short_one(gap):
    z = np.concatenate([np.ones(40), np.zeros(2), np.ones(gap), np.zeros(3)])
    start, stop = touchable(z, 0.5)
    if gap == SHORT_GAP:
        assert (start.tolist(), stop.tolist()) == ([40], [z.size])
    else:
        assert (start.tolist(), stop.tolist()) == ([40, 42 + gap], [42, z.size])


def test_gather_and_bounds_are_those_of_numpy():
    values = np.random.default_rng(1).normal(size=100)
    start, stop = np.array([3, 40, 41, 99]), np.array([7, 41, 90, 100])
    pieces = [values[a:b] for a, b in zip(start, stop, strict=True)]
    np.testing.assert_array_equal(gather(values, start, stop), np.concatenate(pieces))
    np.testing.assert_array_equal(bounds(stop - start), [0, 4, 5, 54, 55])
