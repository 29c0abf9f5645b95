"""Sampled and measured lines: origin, quartets, interpolation of samples, and refused input."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from elastomer_friction.kernels import (
    QUARTET,
    Line,
    amplitudes,
    draw_phases,
    measured_amplitudes,
    rms_height,
    rms_slope,
    sample_line,
)
from elastomer_friction.kernels.lines.measured_modes import measured_modes
from tests.cases import M, line_of


def test_line_starts_at_its_top_and_counts_from_its_bottom():
    line = line_of()
    assert line.z[0] == line.z.max()
    assert line.z.min() == 0.0
    assert np.sqrt(np.mean((line.z + line.datum) ** 2)) == pytest.approx(1.0, rel=1e-13)
    assert abs(np.mean(line.z) + line.datum) < 1e-13  # datum is relative to the mean line
    given = Line.from_samples(np.roll(line.z, 5) + 3.0, np.roll(line.slope, 5), M)
    np.testing.assert_allclose(given.z, line.z, atol=1e-14)
    np.testing.assert_array_equal(given.slope, line.slope)
    assert (given.datum, given.steps_per_spacing, given.band_limited) == (3.0, M, False)


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


@pytest.mark.parametrize("elements", [50, 51])
@pytest.mark.parametrize("m", [1, 4])
def test_a_quartet_is_the_lines_of_phases_that_are_as_probable(elements, m):
    """The phases are shifted by 0, pi, pi/2 and 3 pi/2."""
    amplitude = amplitudes(0.7, elements)
    phases = draw_phases(np.random.default_rng(5), elements)
    quartet = list(Line.quartet(amplitude, phases, elements, m))
    assert len(quartet) == QUARTET
    for line, turn in zip(quartet, (0.0, 1.0, 0.5, 1.5), strict=True):
        expected = Line.self_affine(amplitude, phases + turn * np.pi, elements, m)
        np.testing.assert_allclose(line.z, expected.z, atol=1e-13)
        np.testing.assert_allclose(line.slope, expected.slope, atol=1e-13)
        assert line.datum == pytest.approx(expected.datum, rel=1e-13)
        assert (line.steps_per_spacing, line.band_limited) == (m, True)


def test_the_first_of_a_quartet_is_the_line_alone_and_every_other_one_stands_on_its_head():
    """This holds to the bit, except for the heights of the second line, which differ in origin."""
    amplitude = amplitudes(0.3, 50)
    phases = draw_phases(np.random.default_rng(6), 50)
    quartet = list(Line.quartet(amplitude, phases, 50, 3))
    alone = Line.self_affine(amplitude, phases, 50, 3)
    np.testing.assert_array_equal(quartet[0].z, alone.z)
    np.testing.assert_array_equal(quartet[0].slope, alone.slope)
    other = Line.from_samples(-alone.z, -alone.slope, 3)
    np.testing.assert_array_equal(quartet[1].slope, other.slope)


HEIGHTS = st.integers(4, 40).flatmap(lambda n: arrays(float, n, elements=st.floats(-1.0, 1.0)))
SIZES = (4, 5, 64, 65)


def some_line(samples, seed=3):
    """Return the heights of a random walk that returns to its start."""
    walk = np.cumsum(np.random.default_rng(seed).normal(size=samples))
    return walk - walk[-1] * np.arange(samples) / samples


@given(HEIGHTS, st.integers(1, 4))
def test_resampling_keeps_the_samples(heights, m):
    z, _ = sample_line(*measured_modes(heights), heights.size, m)
    np.testing.assert_allclose(z[::m] + heights.mean(), heights, atol=1e-13)


@given(HEIGHTS)
def test_the_power_of_the_modes_is_the_variance(heights):
    """By Parseval's theorem sum A_k^2 / 2 is the variance of the heights."""
    amplitude = measured_amplitudes(heights[None, :])
    assert rms_height(amplitude) == pytest.approx(heights.std(), rel=1e-12, abs=1e-15)


@pytest.mark.parametrize("samples", SIZES)
@pytest.mark.parametrize("m", [1, 3])
def test_slopes_are_those_of_the_cosines(samples, m):
    x = np.arange(samples * m) / m
    q = 2.0 * np.pi / samples
    heights = 2.0 + 0.5 * np.cos(q * np.arange(samples) + 0.3)
    z, slope = sample_line(*measured_modes(heights), samples, m)
    np.testing.assert_allclose(z, 0.5 * np.cos(q * x + 0.3), atol=1e-13)
    np.testing.assert_allclose(slope, -0.5 * q * np.sin(q * x + 0.3), atol=1e-13)


@pytest.mark.parametrize("samples", [5, 65])  # even sizes determine half of the Nyquist mode
def test_rms_slope_is_that_of_the_line(samples):
    heights = some_line(samples)
    _, slope = sample_line(*measured_modes(heights), samples, 2)
    amplitude = measured_amplitudes(heights[None, :])
    assert rms_slope(amplitude, samples) == pytest.approx(np.sqrt(np.mean(slope**2)), rel=1e-12)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_measured_samples_that_are_no_numbers_are_refused(bad):
    with pytest.raises(ValueError, match="not finite"):
        Line.measured(np.array([0.0, 1.0, bad, 2.0]), 1)


def test_too_few_samples_are_refused():
    with pytest.raises(ValueError, match="needs 4 or more"):
        Line.measured(np.array([0.0, 1.0, 2.0]), 1)
