"""Sums by strips are those of numpy."""

import numpy as np
import pytest

from kernels import SCHEMES, lagged_slope
from kernels.active.strips import STRIP, add_stretch, in_order, overlaps

LAW = SCHEMES["exponential"](0.3)


@pytest.fixture(name="line")
def fixture_line():
    rng = np.random.default_rng(5)
    return rng.standard_normal((3, 3 * STRIP + 7))


def test_overlaps_are_those_of_the_touching_samples(line):
    z, w, _ = line
    depth, count = overlaps(z, w, 0.7, 0.2)
    each = np.maximum(0.2 - (z - 0.7 * w), 0.0)
    assert depth == pytest.approx(each.sum(), rel=1e-12)
    assert count == np.count_nonzero(each)


@pytest.mark.parametrize("stretch", [(0, 103), (40, 45), (96, 103), (7, 90)])
def test_a_stretch_adds_its_samples_round_the_period(line, stretch):
    z, slope, _ = line
    start, stop = stretch
    parts = np.zeros((3, STRIP))
    add_stretch(LAW, z, slope, 1.5, start, stop, *parts)
    p = 1.5 - (z - LAW.decay * np.roll(z, -1))[start:stop]
    lagged = lagged_slope(slope, LAW.lag)[start:stop]
    expected = [p.sum(), lagged.sum(), (p * lagged).sum()]
    assert [in_order(part) for part in parts] == pytest.approx(expected, rel=1e-10)
