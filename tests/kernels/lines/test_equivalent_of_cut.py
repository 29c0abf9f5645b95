"""The line equivalent to a surface, from measured cuts: inversion of the Abel transform."""

import numpy as np
import pytest

from elastomer_friction.kernels import equivalent_of_cut
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes, rms_slope_of
from elastomer_friction.kernels.lines.measured_modes import measured_amplitudes

N = 256


@pytest.mark.parametrize(("hurst", "rolloff"), [(0.8, 4), (0.3, 4), (0.3, 0)])
def test_the_rings_of_the_surface_come_back_from_its_rows(hurst, rolloff):
    own = ring_amplitudes(hurst, N, rolloff, 100)
    surface = Surface.drawn(np.random.default_rng(0), own, N, 1)
    cut = measured_amplitudes(surface.z)
    actual = equivalent_of_cut(cut)
    q = 2.0 * np.pi / N * np.arange(1, actual.size + 1)
    slope = float(np.sum(0.5 * (q * actual) ** 2))
    assert slope == pytest.approx(2.0 * np.sum(0.5 * (q * cut) ** 2), rel=0.01)
    assert slope == pytest.approx(rms_slope_of(own, N) ** 2, rel=0.01)
    k = np.hypot(np.fft.fftfreq(own.shape[0], 1.0 / own.shape[0])[:, None], np.arange(own.shape[1]))
    both = np.where(np.arange(own.shape[1]) == 0, 1.0, 2.0) * own**2
    rings = np.bincount(np.round(k).astype(int).ravel(), both.ravel())[1:]
    for first, last in ((10, 30), (30, 60), (60, 99)):
        band = 0.5 * np.sum(actual[first:last] ** 2)
        assert band == pytest.approx(rings[first:last].sum(), rel=0.02)
