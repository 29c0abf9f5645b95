"""Persson's theory: exact in full contact, linear at light loads, for maps and lines."""

import numpy as np
import pytest

from elastomer_friction.kernels import KELVIN, Case, Quantities, Spectrum, amplitudes
from elastomer_friction.kernels.half_space.cases import run_case
from elastomer_friction.kernels.half_space.persson import (
    persson_theory,
    waves_of_line,
    waves_of_map,
    waves_of_self_affine,
)
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes, rms_slope_of

BRANCHES = Spectrum((2.0, 5.0), (0.3, 0.08), 0.0)


@pytest.mark.parametrize("spectrum", [KELVIN, BRANCHES], ids=["kelvin", "branches"])
@pytest.mark.parametrize("speed", [0.3, -0.3])
def test_friction_in_full_contact_is_that_of_the_half_space(spectrum, speed):
    n, load = 8, 400.0
    amplitude = ring_amplitudes(0.7, n, cutoff=2)
    surface = Surface.drawn(np.random.default_rng(1), amplitude, n, 16)
    case = Case(load, speed, (), (), "exponential", spectrum)
    result = run_case(surface, case, Quantities(jump=False, relaxation=False))
    mu, area = persson_theory(waves_of_map(amplitude, n), spectrum, load / n, speed)
    assert result.contact_fraction == 1.0
    assert area == pytest.approx(1.0, abs=1e-12)
    assert mu == pytest.approx(result.mu_1, rel=0.01)


def test_the_area_at_light_loads_is_linear():
    """A/A_0 = sqrt(8/pi) sigma_0/(E* grad z), at rest."""
    amplitude = ring_amplitudes(0.5, 32)
    load = 1e-3 * rms_slope_of(amplitude, 32)
    _, area = persson_theory(waves_of_map(amplitude, 32), KELVIN, load, 1e-9)
    assert area == pytest.approx(np.sqrt(8.0 / np.pi) * 1e-3, rel=1e-4)


@pytest.mark.parametrize("load", [0.01, 0.2])
def test_a_line_represents_its_equivalent_surface(load):
    """They differ by the number of modes in a ring, which is 8 for the longest wave, not 2 pi."""
    n = 128
    line = persson_theory(waves_of_line(amplitudes(0.3, n), n), KELVIN, load, 0.3)
    ring = persson_theory(waves_of_map(ring_amplitudes(0.3, n), n), KELVIN, load, 0.3)
    assert line == pytest.approx(ring, rel=0.05)


@pytest.mark.parametrize("normalisation", ["modal", "integral"])
@pytest.mark.parametrize("modes", [(4.0, 0), (8.5, 200)])
def test_rings_replace_the_wave_vectors_of_a_large_surface(normalisation, modes):
    n = 1024
    rings = waves_of_self_affine(0.4, n, *modes, normalisation)
    lattice = waves_of_map(ring_amplitudes(0.4, n, *modes, normalisation), n)
    assert rings.q.size < lattice.q.size
    for load in (0.003, 0.1, 30.0):
        ours, theirs = (persson_theory(waves, BRANCHES, load, 0.5) for waves in (rings, lattice))
        assert ours == pytest.approx(theirs, rel=0.01)


def test_bands_of_a_long_line_keep_its_height_and_slope():
    n = 40_000
    whole = amplitudes(0.8, n)
    result = waves_of_line(whole, n)
    q = 2.0 * np.pi / n * np.arange(1, whole.size + 1)
    assert result.q.size < whole.size
    assert result.power.sum() == pytest.approx(0.5 * (whole**2).sum(), rel=1e-12)
    assert (result.power * result.q**2).sum() == pytest.approx(
        0.5 * (whole**2 * q**2).sum(), rel=1e-12
    )
