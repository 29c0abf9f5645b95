"""The equivalent line: it keeps rms height, gradient and curvature of an isotropic surface."""

import numpy as np
import pytest

from elastomer_friction.kernels import (
    amplitudes,
    equivalent_amplitudes,
    equivalent_spectrum,
    rms_height,
    rms_slope,
)
from elastomer_friction.kernels.lines.self_affine import mode_numbers

N = 4096  # elements, on a length of N: the spacing is 1
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


def test_moments_of_a_random_surface_itself():
    """Rms height and gradient of a drawn periodic surface; a cut through it has half the square."""
    n, rng = 128, np.random.default_rng(5)
    k = 2.0 * np.pi * np.fft.fftfreq(n)
    q = np.hypot(*np.meshgrid(k, k))
    filtered = np.sqrt(gaussian(q)) * np.fft.fft2(rng.normal(size=(n, n)))
    height = np.sqrt(np.sum(np.abs(filtered) ** 2)) / n**2
    gradient = np.sqrt(np.sum(np.abs(q * filtered) ** 2)) / n**2
    amplitude = equivalent_amplitudes(gaussian, 16 * n, 16 * n)
    ratio = rms_slope(amplitude, 16 * n) / rms_height(amplitude)
    assert gradient / height == pytest.approx(ratio, rel=0.05)  # 200 patches of correlation
    # A cut holds only one of the two components of the gradient.
    cut = np.fft.ifft2(filtered).real
    slope = np.fft.ifft(1j * k * np.fft.fft(cut, axis=1), axis=1).real
    assert np.sqrt(np.mean(slope**2)) == pytest.approx(gradient / np.sqrt(2.0), rel=0.1)


@pytest.mark.parametrize("hurst", [0.0, 0.5, 1.0])
def test_a_self_affine_surface_gives_the_self_affine_line(hurst):
    """C_2D ~ q^(-2H-2) corresponds to C_1D ~ q^(-2H-1) (paper, Results)."""
    amplitude = equivalent_amplitudes(lambda q: q ** (-2.0 * hurst - 2.0), N, N)
    expected = amplitudes(hurst, N)
    np.testing.assert_allclose(amplitude / amplitude[0], expected / expected[0], rtol=1e-12)


def test_the_rule():
    q = np.array([0.5, 2.0])
    np.testing.assert_allclose(equivalent_spectrum(q, np.ones(2)), [np.pi, 4.0 * np.pi])


@pytest.mark.parametrize("bad", [-1.0, np.nan])
def test_no_power_spectrum_is_refused(bad):
    with pytest.raises(ValueError, match="finite and not negative"):
        equivalent_amplitudes(lambda q: np.full_like(q, bad), 1.0, 8)
