"""Steady sliding: full contact, balance, contact conditions, monotone load, symmetries."""

import numpy as np
import pytest

from elastomer_friction.kernels import (
    SCHEMES,
    Kelvin,
    amplitudes,
    lagged_slope,
    quadrature,
    rms_slope,
    steady_sliding,
    step_average,
)
from elastomer_friction.kernels.model.steady import sweep
from tests.convergence import observed_order
from tests.lines import random_line
from tests.reference_march import constants, steady
from tests.references import full_contact_friction

# (Hurst exponent, samples per spacing, Fbar, vbar): light to full contact, slow to fast
CASES = [
    (0.0, 1, 0.02, 0.3),
    (0.3, 4, 1e-3, 0.05),
    (0.7, 1, 0.05, 2e-3),  # e^-500 is nothing: the elastic contact
    (0.7, 2, 0.1, 2.0),
    (0.7, 1, 1.0, 30.0),
    (1.0, 3, 3.0, 1.0),
    (1.0, 1, 40.0, 5.0),
]


def solved(z, load, speed, m, scheme):
    """Return the law and the steady state as w, d, sweeps; load = Fbar."""
    law = SCHEMES[scheme](1.0 / (m * speed))
    (w, d), sweeps = steady_sliding(law, z, load * z.size)
    return law, w, d, sweeps


def sinusoid(elements, m, amplitude):
    """Return heights, slopes and the rms slope of three waves along the line."""
    q = 6.0 * np.pi / elements
    angle = q * np.arange(elements * m) / m + 0.4
    slope = -amplitude * q * np.sin(angle)
    return amplitude * np.cos(angle), slope, amplitude * q / np.sqrt(2.0)


def spectrum(hurst):
    """Return the same of a random line around its mean."""
    z, slope = random_line(64, hurst, 2, seed=2)
    return z - z.mean(), slope, rms_slope(amplitudes(hurst, 64), 64)


WAVES = {f"sinusoid, m = {m}": (sinusoid(32, m, 1.3), m) for m in (1, 2, 7)}
SPECTRA = {f"hurst = {hurst}": (spectrum(hurst), 2) for hurst in (0.0, 0.7, 1.0)}


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("line", WAVES | SPECTRA)
def test_full_contact_is_exact(scheme, line):
    (z, slope, rms), m = (WAVES | SPECTRA)[line]
    load, speed = 60.0, 3.0
    _, w, d, _ = solved(z, load, speed, m, scheme)
    mu, rate, contact = quadrature(z, slope, w, d, speed, speed, load * z.size)
    # Sums of waves over whole periods are exact: rounding alone is left, of pressures of 60.
    assert contact == 1.0
    assert d == pytest.approx(load, rel=1e-13)
    assert mu == pytest.approx(full_contact_friction(rms, speed, load), rel=1e-12)
    assert abs(rate) < 1e-11


@pytest.mark.parametrize("scheme", SCHEMES)
def test_step_average_of_the_sinusoid_is_second_order(scheme):
    """In full contact it is so for both schemes: their forces differ by a shift alone."""
    refinements, errors = np.array([16, 32, 64, 128, 256]), []
    for m in refinements:
        z, slope, rms = sinusoid(32, m, 1.3)
        law, w, d, _ = solved(z, 3.0, 2.0, m, scheme)
        mu = step_average(lagged_slope(slope, law.lag), z - w, d)
        errors.append([mu / full_contact_friction(rms, 2.0, 3.0) - 1.0])
    assert observed_order(refinements, np.array(errors)) == pytest.approx(2.0, abs=0.01)
    assert abs(errors[-1][0]) < 1e-6


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize(("hurst", "m", "load", "speed"), CASES)
def test_state_is_that_of_an_element_carried_round_the_line(scheme, hurst, m, load, speed):
    z, _ = random_line(60, hurst, m, seed=3)
    _, found, d, _ = solved(z, load, speed, m, scheme)
    u, w, expected = steady(z, load, constants(scheme, 1.0 / (m * speed))[0])
    # Bisection to one ulp; the force loses digits as the stiffness, at most 150 here.
    assert d == pytest.approx(expected, rel=1e-12)
    np.testing.assert_allclose(found, w, atol=1e-12 * max(1.0, d))
    np.testing.assert_allclose(np.minimum(found, z - d), u, atol=1e-12 * max(1.0, d))


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize(("hurst", "m", "load", "speed"), CASES)
def test_balance_and_contact_conditions(scheme, hurst, m, load, speed):
    z, _ = random_line(60, hurst, m, seed=4)
    law, w, d, sweeps = solved(z, load, speed, m, scheme)
    u = np.minimum(w, z - d)
    force = law.stiffness * (w - u)
    rounding = 1e-15 * law.stiffness * d / load  # of w - u, relative to the mean force
    assert force.mean() == pytest.approx(load, rel=1e-14 + rounding)
    assert -u.mean() == pytest.approx(load, rel=1e-14 + rounding)  # the steady mean of eq. 2
    assert np.all(force >= 0.0)
    assert np.all(u <= z - d + 1e-15 * d)  # nothing passes through the line
    assert np.all((force == 0.0) | (np.abs(u - (z - d)) <= 4e-16 * (z + d)))  # complementarity
    np.testing.assert_allclose(w, law.decay * np.roll(u, -1), atol=1e-14 * max(1.0, d))
    assert sweeps <= 10


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("load", [1e-9, 1e-3, 1.0, 1e4])
@pytest.mark.parametrize("speed", [1e-4, 1.0, 1e3])
def test_extreme_loads_and_speeds_need_few_sweeps(scheme, load, speed):
    z, slope = random_line(100, 0.7, 1, seed=5)
    law, w, d, sweeps = solved(z, load, speed, 1, scheme)
    assert sweeps <= 20  # convex Newton: about 5; rounding may creep by ulps at high speed
    force = law.stiffness * np.maximum(0.0, d - (z - w)).mean()
    # The overlap is known to eps times the heights (1 here) or d, and multiplied by the stiffness.
    assert force == pytest.approx(load, rel=1e-12 + 1e-15 * law.stiffness * (1 + d / load))
    assert np.isfinite(quadrature(z, slope, w, d, speed, speed, load * z.size)).all()


@pytest.mark.parametrize("scheme", SCHEMES)
def test_force_increases_convexly_with_the_indentation(scheme):
    z, _ = random_line(80, 0.7, 2, seed=6)
    law = SCHEMES[scheme](0.2)
    depths = np.linspace(0.05, 6.0, 40)
    w = np.empty_like(z)
    found = [sweep(law, z, d, np.argmin(z), w)[:2] for d in depths]
    force, slope = np.array(found).T
    assert np.all(np.diff(force) > 0.0)
    assert np.all(np.diff(slope) >= -1e-12)
    # Convex: secants lie between the tangents at their ends.
    secant = np.diff(force) / np.diff(depths)
    assert np.all(slope[:-1] <= secant + 1e-11)
    assert np.all(secant <= slope[1:] + 1e-11)


@pytest.mark.parametrize("deepest", [0, 1, 40, 78, 79])
def test_one_sweep_visits_every_sample_once_wherever_it_starts(deepest):
    z = 2.0 + np.cos(np.arange(80) * 0.31)
    z[deepest] = 0.0
    w = np.full_like(z, np.nan)
    total, _, touching = sweep(Kelvin(0.8, 5.0, 0.0), z, 1.4, deepest, w)
    u = z[deepest] - 1.4
    expected = 0.0
    for k in range(1, 81):  # upstream, so that the deepest sample comes last
        j = (deepest - k) % 80
        assert w[j] == 0.8 * u
        u = min(w[j], z[j] - 1.4)
        expected += w[j] - u
    assert total == pytest.approx(expected, rel=1e-14)
    assert touching == np.sum(np.minimum(w, z - 1.4) < w)
