"""The power spectrum of lines: its normalisation and its unit."""

import numpy as np
import pytest

from elastomer_friction.kernels import amplitudes, power_spectrum, rms_height, rms_slope


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


def test_one_cosine_has_one_line():
    """A cosine of amplitude A holds A^2 / 2, whatever the length of the line."""
    for length in (1.0, 2.0):
        q, spectrum = power_spectrum(np.array([0.0, 0.2, 0.0]), length)
        assert spectrum[1] * q[0] == pytest.approx(0.02)
        assert (spectrum[0], spectrum[2]) == (0.0, 0.0)
