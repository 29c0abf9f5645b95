"""A sampled line: its origin, and what is refused."""

import numpy as np
import pytest

from kernels import Line
from tests.cases import M, line_of


def test_line_starts_at_its_top_and_counts_from_its_bottom():
    line = line_of()
    assert line.z[0] == line.z.max()
    assert line.z.min() == 0.0
    assert np.sqrt(np.mean((line.z + line.datum) ** 2)) == pytest.approx(1.0, rel=1e-13)
    assert abs(np.mean(line.z) + line.datum) < 1e-13  # datum: from the mean line
    given = Line.from_samples(np.roll(line.z, 5) + 3.0, np.roll(line.slope, 5), M)
    np.testing.assert_allclose(given.z, line.z, atol=1e-14)
    np.testing.assert_array_equal(given.slope, line.slope)
    assert (given.datum, given.steps_per_spacing) == (3.0, M)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
@pytest.mark.parametrize("where", [0, 1])
def test_samples_that_are_no_numbers_are_refused(bad, where):
    samples = [np.arange(4.0), np.arange(4.0)]
    samples[where][2] = bad
    with pytest.raises(ValueError, match="finite"):
        Line.from_samples(*samples, 1)


@pytest.mark.parametrize(("heights", "slopes", "m"), [(4, 3, 1), (0, 0, 1), (4, 4, 0)])
def test_lines_that_are_none_are_refused(heights, slopes, m):
    with pytest.raises(ValueError, match="one slope per height"):
        Line.from_samples(np.zeros(heights), np.zeros(slopes), m)


@pytest.mark.parametrize("scale", [1e-300, 1e-51, 1e51, 1e308])
def test_heights_in_other_units_than_their_roughness_are_refused(scale):
    with pytest.raises(ValueError, match="units of their roughness"):
        Line.from_samples(np.array([-1.0, 1.0]) * scale, np.zeros(2), 1)
