"""A measured power spectrum: its conventions, its moments and its modes, by closed forms."""

from math import gamma, pi

import numpy as np
import pytest

from elastomer_friction.kernels import (
    IsotropicSpectrum,
    amplitudes,
    equivalent_amplitudes,
    isotropic_of_cut,
    isotropic_of_equivalent,
    rms_height,
)
from elastomer_friction.kernels.half_space.surface import (
    isotropic_amplitudes,
    ring_amplitudes,
    rms_height_of,
)

H, LENGTH, N = 0.8, 2e-3, 64
Q = np.geomspace(1e3, 2e5, 30)  # 1/m
C_2D = 3e-4 * Q ** (-2.0 * H - 2.0)
CUT_OF_EQUIVALENT = 2.0 * gamma(H + 1.5) / ((2.0 * H + 1.0) * np.sqrt(pi) * gamma(H + 1.0))


def test_a_cut_has_0_54_of_the_equivalent_line_at_a_hurst_exponent_of_0_8():
    assert abs(CUT_OF_EQUIVALENT - 0.54) < 5e-3
    equivalent = pi * Q * C_2D
    np.testing.assert_allclose(isotropic_of_equivalent(Q, equivalent), C_2D, rtol=1e-14)
    np.testing.assert_allclose(
        isotropic_of_cut(Q, CUT_OF_EQUIVALENT * equivalent), C_2D, rtol=1e-10
    )


def test_a_cut_with_a_roll_off_is_inverted():
    """C_2D = (1 + (q/q_0)^2)^-(H+1) has the cut q_0 B (1 + (q/q_0)^2)^-(H+1/2) (beta function)."""
    q = np.geomspace(1e2, 1e7, 301)
    x = 1.0 + (q / 1e4) ** 2
    cut = 1e4 * np.sqrt(pi) * gamma(H + 0.5) / gamma(H + 1.0) * x ** (-H - 0.5)
    np.testing.assert_allclose(isotropic_of_cut(q, cut), x ** (-H - 1.0), rtol=3e-3)


def test_height_slope_and_the_cut_off_of_a_slope_are_the_integrals():
    spectrum = IsotropicSpectrum(tuple(Q), tuple(C_2D))
    for q in (2.3e3, Q[7], Q[-2]):
        height = 2.0 * pi * 3e-4 * (Q[0] ** -1.6 - q**-1.6) / 1.6
        slope = 2.0 * pi * 3e-4 * (q**0.4 - Q[0] ** 0.4) / 0.4
        actual = spectrum.moments_below(q)
        assert actual[0] == pytest.approx(height, rel=1e-10)
        assert actual[1] == pytest.approx(slope, rel=1e-10)
        assert spectrum.wave_number_of_slope(slope**0.5) == pytest.approx(q, rel=1e-9)
    flat = IsotropicSpectrum((1.0, 10.0), (1.0, 1e-2))  # C ~ q^-2: a logarithm
    assert flat.moments_below(10.0)[0] == pytest.approx(2.0 * pi * np.log(10.0), rel=1e-12)


def test_slopes_outside_the_table_are_refused():
    spectrum = IsotropicSpectrum(tuple(Q), tuple(C_2D))
    most = float(spectrum.moments_below(Q[-1])[1] ** 0.5)
    with pytest.raises(ValueError, match="that of all waves"):
        spectrum.wave_number_of_slope(1.01 * most)


def test_a_self_affine_table_has_the_modes_of_the_self_affine_surface():
    spectrum = IsotropicSpectrum(tuple(Q), tuple(C_2D))
    line = equivalent_amplitudes(spectrum.at, LENGTH, N)
    np.testing.assert_allclose(line / rms_height(line), amplitudes(H, N), rtol=1e-10)

    def inside(q):
        return np.where(q <= pi * N / LENGTH * (1.0 + 1e-9), spectrum.at(q), 0.0)

    rings = isotropic_amplitudes(inside, LENGTH, N)
    np.testing.assert_allclose(rings / rms_height_of(rings), ring_amplitudes(H, N), rtol=1e-10)
    assert rings[0, 1] == pytest.approx(2.0 * pi / LENGTH * spectrum.at(2.0 * pi / LENGTH) ** 0.5)
