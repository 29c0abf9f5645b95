"""Prony series from moduli: exact spectra come back, noise is no branch, limits are said."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastomer_friction.workflow.laboratory.prony_fit import (
    TIME_MARGIN,
    condensed,
    fit_prony,
    measured_moduli,
)

THREE = ((3e7, 1e-3), (5e6, 2e-2), (2e6, 0.3))
OMEGA = np.geomspace(1e-2, 1e5, 60)
F0 = 6.94e7  # Hz, of crosslinked SBR at 20 °C


def moduli(omega, relaxed, branches):
    """Return G* of a Prony series by its definition."""
    sums = [g * 1j * omega * t / (1.0 + 1j * omega * t) for g, t in branches]
    return relaxed + np.sum(sums, axis=0)


def sbr(omega):
    """Return G* of crosslinked SBR: springpots of the Shull group (docs/scenes.md)."""
    turn = 1j * omega / (2.0 * np.pi * F0)
    glass = 1.0 / (1.0 / (1.12e9 * turn ** (55 / 90)) + 1.0 / (1.12e9 * turn ** (2 / 90)))
    return (1.76e6 * turn ** (2.3 / 90) + glass) / 3.0


def test_a_spectrum_without_noise_comes_back():
    fit = fit_prony(OMEGA, moduli(OMEGA, 1e6, THREE))
    np.testing.assert_allclose(fit.branches, THREE, rtol=1e-6)
    assert fit.shear_modulus == pytest.approx(1e6, rel=1e-6)
    assert fit.worst < 1e-8
    assert fit.determined
    assert fit.least == pytest.approx(1e6, rel=0.01)


@pytest.mark.parametrize("part", [np.array, np.real])
def test_least_squares_of_the_combinations_are_those_of_all_values(part):
    omega = np.geomspace(1e-3, 1e7, 300)  # of real moduli, 1/t
    noise = 1.0 + 0.05 * np.random.default_rng(1).standard_normal(300)
    full = measured_moduli(omega, part(noise * moduli(omega, 1e6, THREE)), 0.1)
    few = condensed(full)
    reach = np.log([1.0 / (TIME_MARGIN * omega[-1]), TIME_MARGIN**2 / omega[0]])
    times = np.exp(np.random.default_rng(2).uniform(*reach, 40))
    assert few.wanted.size < full.wanted.size / 2
    products = []
    for data in (full, few):
        rows = np.column_stack([*data.weighted(times), data.wanted])
        products.append(rows.T @ rows)
    size = np.sqrt(np.diag(products[0]))
    assert abs((products[1] - products[0]) / np.outer(size, size)).max() < 1e-8


@settings(max_examples=3, deadline=None)
@given(st.integers(0, 10**6), st.floats(1e-3, 1e3), st.floats(1e-3, 1e3))
def test_the_fit_follows_the_units_of_moduli_and_times(seed, stiffer, slower):
    rng = np.random.default_rng(seed)
    noise = 1.0 + 0.01 * (rng.standard_normal(60) + 1j * rng.standard_normal(60))
    measured = noise * moduli(OMEGA, 1e6, THREE)
    measured = measured.real + 1j * np.abs(measured.imag)
    own, other = fit_prony(OMEGA, measured), fit_prony(OMEGA / slower, stiffer * measured)
    assert other.rms == pytest.approx(own.rms, rel=1e-3)
    assert other.shear_modulus == pytest.approx(stiffer * own.shear_modulus, rel=1e-3)
    assert len(own.branches) == len(other.branches)


@pytest.mark.parametrize("seed", range(3))
def test_noise_makes_no_branches_and_is_the_residual(seed):
    rng = np.random.default_rng(seed)
    exact = moduli(OMEGA, 1e6, THREE)
    noise = rng.standard_normal((2, OMEGA.size))
    fit = fit_prony(
        OMEGA, exact.real * (1 + 0.02 * noise[0]) + 1j * exact.imag * (1 + 0.02 * noise[1])
    )
    assert len(fit.branches) <= 4
    assert 0.01 < fit.rms < 0.025
    assert abs(moduli(OMEGA, fit.shear_modulus, fit.branches) / exact - 1.0).max() < 0.05
    assert fit.least <= 1e6 <= 1.03 * fit.most


def test_a_rubber_over_twelve_decades_takes_a_branch_per_decade():
    omega = np.geomspace(1e-2, 1e10, 25)
    fit = fit_prony(omega, sbr(omega))
    assert len(fit.branches) <= 16
    assert fit.rms < 0.0101
    assert fit.worst < 0.03
    assert fit.loss_residual.max() < 0.05
    again = abs(moduli(omega, fit.shear_modulus, fit.branches) / sbr(omega) - 1.0)
    assert again.max() == pytest.approx(fit.worst, rel=1e-9)
    assert not fit.determined  # a springpot of 2.3 degrees never comes to rest


def test_the_number_of_branches_can_be_limited():
    fit = fit_prony(OMEGA, moduli(OMEGA, 1e6, THREE), branches=2)
    assert len(fit.branches) == 2
    assert fit.rms > 0.01


def test_a_window_that_ends_in_the_transition_does_not_determine_the_relaxed_modulus():
    omega = np.geomspace(1e2, 1e5, 40)
    noise = 1.0 + 0.02 * np.random.default_rng(1).standard_normal(40)
    fit = fit_prony(omega, noise * moduli(omega, 1e6, [(3e7, 1e-3), (5e6, 1e-1)]))
    assert not fit.determined
    assert fit.least < 1e6 < fit.most
    assert fit.most > 1.3 * fit.least


@pytest.mark.parametrize(
    ("omega", "values"),
    [
        ([1.0, 2.0, 3.0], [1.0 + 1j] * 3),
        ([1.0, 2.0, 3.0, -4.0], [1.0 + 1j] * 4),
        ([1.0, 2.0, 3.0, 4.0], [1.0, 2.0, -1.0, 3.0]),
        ([1.0, 2.0, 3.0, 4.0], [1.0, np.nan, 1.0, 3.0]),
        ([1.0, 2.0, 3.0, 4.0], [1.0, 1.0 - 1j, 1.0, 3.0]),
    ],
)
def test_what_is_no_measurement_is_refused(omega, values):
    with pytest.raises(ValueError, match="four frequencies or more"):
        fit_prony(np.array(omega), np.array(values))


def test_a_modulus_so_well_known_that_no_other_of_the_scan_will_do_is_determined():
    """The time is one of the grid, so that nothing is left over; the scan misses 1 by 2 %."""
    omega = np.geomspace(1.0, 1e3, 20)
    fit = fit_prony(omega, moduli(omega, 1.0, [(0.9583, 1.0)]))
    assert fit.determined
    assert [fit.least, fit.most] == pytest.approx([1.0, 1.0], rel=1e-6)


def test_branches_are_left_out_only_where_the_data_do_not_tell():
    """Without the weakest of four branches the residual is 1.6 times the noise."""
    exact = moduli(OMEGA, 1e6, ((3e7, 1e-4), (4e6, 3e-3), (6e5, 0.03), (2e6, 0.3)))
    noise = 0.02 * np.random.default_rng(0).standard_normal((2, OMEGA.size))
    measured = exact.real * (1.0 + noise[0]) + 1j * exact.imag * (1.0 + noise[1])
    fit = fit_prony(OMEGA, measured)
    assert fit.rms < 1.1 * np.sqrt(np.mean(np.abs(measured / exact - 1.0) ** 2))


@pytest.mark.parametrize("seed", range(8))
def test_a_flat_loss_has_a_relaxed_modulus_within_a_range_that_holds_the_true_one(seed):
    """Branches go on for two decades below the lowest frequency."""
    rng = np.random.default_rng(seed)
    omega = np.geomspace(10 ** rng.uniform(-3, -1), 10 ** rng.uniform(1, 3), 14)
    times = np.geomspace(0.1 / omega.max(), 100.0 / omega.min(), 24)
    exact = moduli(omega, 3e5, [(1e5, time) for time in times])
    noise = 1.0 + 0.02 * rng.standard_normal((2, omega.size))
    fit = fit_prony(omega, exact.real * noise[0] + 1j * exact.imag * noise[1])
    assert fit.least <= 3e5 <= fit.most
    assert 0.0 < fit.shear_modulus <= fit.most
    assert not fit.determined


def test_the_residual_of_a_small_loss_is_relative_to_it():
    """A tenth of a percent of G' is ten times a loss modulus of a ten-thousandth of it."""
    omega = np.geomspace(1.0, 1e4, 41)
    moduli = 1e6 * (1.0 + 1e-4j) * np.ones(41)  # no branch has a constant loss angle
    fit = fit_prony(omega, moduli)
    assert fit.rms < 1e-3
    assert fit.loss_residual.max() > 0.5
    assert fit_prony(omega, moduli.real).loss_residual.max() == 0.0  # a relaxation test
