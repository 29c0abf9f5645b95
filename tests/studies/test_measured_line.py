"""Measured lines beside random ones of their spectrum, and of their height and slope."""

import numpy as np
import pytest

STUDY = ("measured_line",)
KINDS = ("", "random_phase", "self_affine")


def test_the_spectra_are_those_of_lines_of_one_height_and_slope(groups):
    for data in groups.values():
        step = data.wave_number[0]
        height = np.sqrt((data.power_spectrum * step).sum())
        slope = np.sqrt((data.power_spectrum * data.wave_number**2 * step).sum())
        assert float(height) == pytest.approx(float(data.roughness), rel=1e-9)
        np.testing.assert_allclose(data.rms_slope, slope, rtol=1e-9)
    measured, random, fractal = (groups[name].power_spectrum for name in KINDS)
    np.testing.assert_array_equal(measured, random)
    assert float(abs(np.log(fractal / random)).max()) > 1.0


def test_height_and_slope_make_friction(groups):
    """To 20 %, whatever the spectrum and the phases; contact varies by more."""
    measured, random, fractal = (groups[name] for name in KINDS)
    for data in (measured, fractal):
        np.testing.assert_allclose(data.mu_1 / random.mu_1, 1.0, atol=0.25)
        np.testing.assert_allclose(data.contact_fraction / random.contact_fraction, 1.0, atol=0.5)
    exponent = np.log(measured.mu_1[1] / measured.mu_1[0]) / np.log(10.0)
    assert float(exponent) == pytest.approx(1.0, abs=0.05)  # x = 0.3 to 3


def test_measured_lines_vary_more_than_random_ones(groups):
    """Patches of one surface differ in roughness: so do their lines, 16 of which are a block.

    Up to x = 3: beyond, four blocks of few contacts say little of an error.
    """
    measured, random, _ = (groups[name] for name in KINDS)
    assert (measured.mu_1_error > 1.2 * random.mu_1_error)[:2].all()


def test_the_result_says_which_lines_it_was_computed_on(groups):
    assert groups[""].attrs["lines"].startswith("afm-lines.nc: 64 lines of 512 samples")
    like = [groups[name].attrs["lines"] for name in KINDS[1:]]
    assert like[0].startswith("random lines of the power spectrum of afm-lines.nc")
    assert like[1].startswith("self-affine lines, H = 1, of rms height and slope of afm-lines.nc")
    assert all("its parabola removed" in data.attrs["lines"] for data in groups.values())
