"""Random lines: normalisation, spectrum, and samples of one function for every m."""

import itertools

import numpy as np
import pytest

from elastomer_friction.kernels import (
    amplitudes,
    draw_phases,
    equivalent_amplitudes,
    matching_rolloff,
    power_spectrum,
    rms_height,
    rms_slope,
    sample_line,
)
from elastomer_friction.kernels.lines.self_affine import mode_numbers

HURST = (0.0, 0.3, 0.7, 1.0)
SIZES = (2, 3, 50, 51)  # even sizes have a Nyquist mode


def drawn(hurst, elements, seed=1):
    """Return (amplitudes, phases) of one line."""
    return amplitudes(hurst, elements), draw_phases(np.random.default_rng(seed), elements)


def cosine_sum(amplitude, phases, elements, m):
    """Return (heights, slopes) by the sum that defines the line (self_affine.py)."""
    x = np.arange(elements * m) / m
    q = 2.0 * np.pi * np.arange(1, amplitude.size + 1) / elements
    angle = np.outer(x, q) + phases
    return np.cos(angle) @ amplitude, -np.sin(angle) @ (amplitude * q)


@pytest.mark.parametrize("hurst", HURST)
@pytest.mark.parametrize(
    ("elements", "m"), [*itertools.product(SIZES, [2, 3]), (3, 1), (51, 1), (501, 1)]
)
def test_rms_height_and_slope_of_the_samples(hurst, elements, m):
    amplitude, phases = drawn(hurst, elements)
    z, slope = sample_line(amplitude, phases, elements, m)
    # For sampling above twice the highest wave number, mean squares are exact sums over modes.
    assert np.sqrt(np.mean(z**2)) == pytest.approx(1.0, rel=1e-13)
    assert np.sqrt(np.mean(slope**2)) == pytest.approx(rms_slope(amplitude, elements), rel=1e-13)
    assert abs(z.mean()) < 1e-14
    assert abs(slope.mean()) < 1e-13


@pytest.mark.parametrize(("hurst", "ratio"), [(0.0, 1.04), (0.3, 1.17), (0.7, 1.39), (1.0, 1.55)])
def test_integral_normalisation_of_the_paper(hurst, ratio):
    """At N = 5000, lines are rougher than with "modal" by these factors (two decimals)."""
    amplitude = amplitudes(hurst, 5000, "integral")
    assert np.sqrt(np.sum(amplitude**2) / 2) == pytest.approx(ratio, abs=0.005)
    # Only the common factor differs.
    factor = amplitude / amplitudes(hurst, 5000)
    np.testing.assert_allclose(factor, factor[0], rtol=1e-12)


def test_unknown_normalisation_is_refused():
    with pytest.raises(ValueError, match="modal"):
        amplitudes(0.7, 50, "peak")


@pytest.mark.parametrize("hurst", HURST)
@pytest.mark.parametrize("elements", SIZES)
@pytest.mark.parametrize("m", [1, 2, 5])
def test_samples_are_the_cosine_sum(hurst, elements, m):
    amplitude, phases = drawn(hurst, elements)
    z, slope = sample_line(amplitude, phases, elements, m)
    z_sum, slope_sum = cosine_sum(amplitude, phases, elements, m)
    # Tolerances for rounding in sums of 25 terms of order one, and of order pi for slopes.
    np.testing.assert_allclose(z, z_sum, atol=1e-13)
    np.testing.assert_allclose(slope, slope_sum, atol=3e-13)


def test_phases_are_reproducible_and_fill_the_circle():
    first = draw_phases(np.random.default_rng([7, 3]), 5000)
    again = draw_phases(np.random.default_rng([7, 3]), 5000)
    other = draw_phases(np.random.default_rng([7, 4]), 5000)
    np.testing.assert_array_equal(first, again)
    assert not np.any(first == other)
    assert first.min() >= 0.0
    assert first.max() < 2.0 * np.pi
    # With uniform phases the sum of 2500 unit vectors is of order 50; allow 4 sigma.
    assert np.abs(np.exp(1j * first).sum()) < 4.0 * np.sqrt(first.size)


@pytest.mark.parametrize("hurst", HURST)
@pytest.mark.parametrize("normalisation", ["modal", "integral"])
def test_below_the_roll_off_the_spectrum_is_flat_and_beyond_the_cut_off_there_is_none(
    hurst, normalisation
):
    amplitude = amplitudes(hurst, 200, normalisation, rolloff=8.0, cutoff=40)
    np.testing.assert_array_equal(amplitude[:8], amplitude[7])
    assert amplitude[15] / amplitude[31] == pytest.approx(2.0 ** (hurst + 0.5), rel=1e-13)
    assert np.all(amplitude[:40] > 0.0)
    assert not amplitude[40:].any()


@pytest.mark.parametrize("hurst", HURST)
def test_roll_off_and_cut_off_keep_the_normalisation(hurst):
    assert np.sum(amplitudes(hurst, 200, "modal", 7.5, 40) ** 2) == pytest.approx(2.0, rel=1e-13)
    # int_1^k_c max(k, k_r)^(-2H-1) dk by the trapezoidal rule on a fine grid
    k = np.linspace(1.0, 40.0, 200_001)
    power = np.maximum(k, 7.5) ** (-2.0 * hurst - 1.0)
    integral = np.trapezoid(power, k)
    amplitude = amplitudes(hurst, 200, "integral", 7.5, 40)
    assert 0.5 * amplitude[20] ** 2 == pytest.approx(21.0 ** (-2.0 * hurst - 1.0) / integral)


@pytest.mark.parametrize("hurst", HURST)
def test_no_roll_off_and_no_cut_off_leave_every_bit(hurst):
    """Explicit values that change nothing leave every bit, too."""
    usual = amplitudes(hurst, 51)
    np.testing.assert_array_equal(amplitudes(hurst, 51, rolloff=1.0, cutoff=25), usual)


def test_a_cut_off_leaves_the_other_modes_in_phase():
    """A line with a lower cut-off is the same line without its short waves."""
    amplitude, phases = drawn(0.7, 64)
    cut, _ = sample_line(amplitudes(0.7, 64, cutoff=10), phases, 64, 1)
    spectrum = np.fft.rfft(sample_line(amplitude, phases, 64, 1)[0])
    spectrum[11:] = 0.0
    smooth = np.fft.irfft(spectrum, 64)
    np.testing.assert_allclose(cut * smooth.std(), smooth, atol=1e-13)


@pytest.mark.parametrize(("rolloff", "cutoff"), [(11.0, 10), (-1.0, 0), (0.0, 26), (26.0, 0)])
def test_wave_numbers_that_do_not_ascend_are_refused(rolloff, cutoff):
    with pytest.raises(ValueError, match="must ascend to N/2 = 25"):
        amplitudes(0.7, 50, "modal", rolloff, cutoff)


@pytest.mark.parametrize(("hurst", "slope"), [(0.0, 1.2), (0.5, 0.4), (1.0, 0.06)])
def test_a_roll_off_gives_lines_of_a_slope(hurst, slope):
    rolloff = matching_rolloff(hurst, 1024, slope)
    amplitude = amplitudes(hurst, 1024, "modal", rolloff)
    assert rms_slope(amplitude, 1024) == pytest.approx(slope, rel=1e-12)
    assert 1.0 < rolloff < 512.0


@pytest.mark.parametrize("slope", [0.05, 1.9, float("nan")])
def test_slopes_that_no_roll_off_gives_are_refused(slope):
    with pytest.raises(ValueError, match=r"lines of H = 0.5 have 0.1083 to 1.816"):
        matching_rolloff(0.5, 1024, slope)


@pytest.mark.parametrize("length", [1.0, 64.0, 1e-5])
def test_the_integral_is_the_mean_square_height_and_slope(length):
    amplitude = 3e-8 * amplitudes(0.7, 64)
    q, spectrum = power_spectrum(amplitude, length)
    step = 2.0 * np.pi / length
    np.testing.assert_allclose(q, step * np.arange(1, 33))
    assert np.sum(spectrum) * step == pytest.approx(rms_height(amplitude) ** 2, rel=1e-13)
    assert rms_height(amplitude) == pytest.approx(3e-8, rel=1e-13)
    slope = rms_slope(amplitude, 64) * 64 / length
    assert np.sum(spectrum * q**2) * step == pytest.approx(slope**2, rel=1e-13)


N = 4096  # elements on a length of N, so that the spacing is 1
STEP = 2.0 * np.pi / N


def gaussian(q):
    """Return C_2D of a surface of rms height 2 and correlation length 9 (Gaussian spectrum)."""
    return 4.0 * 81.0 / (4.0 * np.pi) * np.exp(-81.0 * q**2 / 4.0)


def test_height_gradient_and_curvature_are_those_of_the_surface():
    """2 pi int q^(n+1) C_2D dq of the Gaussian spectrum is h^2 (4/xi^2)^(n/2) (n/2)!"""
    amplitude = equivalent_amplitudes(gaussian, N, N)
    q = STEP * mode_numbers(N)
    curvature = 0.5 * np.sum((amplitude * q**2) ** 2)
    assert rms_height(amplitude) ** 2 == pytest.approx(4.0, rel=1e-4)
    assert rms_slope(amplitude, N) ** 2 == pytest.approx(4.0 * 4.0 / 81.0, rel=1e-4)
    assert curvature == pytest.approx(4.0 * 2.0 * (4.0 / 81.0) ** 2, rel=1e-4)


@pytest.mark.parametrize("hurst", [0.0, 0.5, 1.0])
def test_a_self_affine_surface_gives_the_self_affine_line(hurst):
    """C_2D ~ q^(-2H-2) corresponds to C_1D ~ q^(-2H-1) (paper, Results)."""
    amplitude = equivalent_amplitudes(lambda q: q ** (-2.0 * hurst - 2.0), N, N)
    expected = amplitudes(hurst, N)
    np.testing.assert_allclose(amplitude / amplitude[0], expected / expected[0], rtol=1e-12)


@pytest.mark.parametrize("bad", [-1.0, np.nan])
def test_no_power_spectrum_is_refused(bad):
    with pytest.raises(ValueError, match="finite and not negative"):
        equivalent_amplitudes(lambda q: np.full_like(q, bad), 1.0, 8)
