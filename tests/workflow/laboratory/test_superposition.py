"""Sweeps of known shifts become one curve, the shifts come back, and their errors cover."""

import numpy as np
import pytest

from elastomer_friction.kernels import Arrhenius, ShiftTable, Wlf
from elastomer_friction.workflow.laboratory.shift_fit import fit_shifts
from elastomer_friction.workflow.laboratory.superposition import superposed
from tests.workflow.laboratory.test_prony_fit import moduli, sbr

BRANCHES = ((3e7, 1e-3), (5e6, 2e-2), (2e6, 0.3), (4e5, 3.0), (3e5, 20.0))
OMEGA = np.geomspace(0.1, 100.0, 10)
WLF = Wlf(8.86, 101.6, 20.0)
TEMPERATURES = np.array([-10.0, 0.0, 10.0, 20.0, 30.0, 45.0])
TRUE = np.array([WLF.decades(t) for t in TEMPERATURES])
REST = 3  # the sweep at the reference


def noisy(values, noise, rng):
    """Return moduli of which each part has its own relative noise."""
    return values.real * (1.0 + noise * rng.standard_normal(values.size)) + 1j * np.abs(
        values.imag * (1.0 + noise * rng.standard_normal(values.size))
    )


def sweeps(noise=0.0, seed=0, vertical=None, law=WLF):
    """Return sweeps of known moduli at TEMPERATURES, smaller by 10^vertical."""
    rng = np.random.default_rng(seed)
    vertical = np.zeros(TEMPERATURES.size) if vertical is None else vertical
    return [
        (OMEGA, noisy(moduli(OMEGA * 10.0 ** law.decades(t), 1e6, BRANCHES), noise, rng) / 10.0**up)
        for t, up in zip(TEMPERATURES, vertical, strict=True)
    ]


@pytest.mark.parametrize("vertical", [False, True])
def test_shifts_without_noise_come_back(vertical):
    found = superposed(TEMPERATURES, sweeps(), REST, vertical)
    np.testing.assert_allclose(found.decades, TRUE, atol=2e-3)
    np.testing.assert_allclose(found.vertical, 0.0, atol=1e-3)
    assert found.rms < 1e-3
    assert found.errors[REST] == 0.0


def test_errors_cover_the_shifts():
    off = []
    for seed in range(12):
        found = superposed(TEMPERATURES, sweeps(0.02, seed), REST)
        free = found.errors > 0.0
        off.append(((found.decades - TRUE) / np.where(free, found.errors, 1.0))[free])
    assert 0.5 < np.sqrt(np.mean(np.square(off))) < 1.6
    assert np.mean(np.abs(off) < 3.0) > 0.97


def test_moduli_that_change_with_the_temperature_are_shifted_too():
    up = 0.1 * (TEMPERATURES - 20.0) / 40.0
    found = superposed(TEMPERATURES, sweeps(0.005, 1, up), REST, vertical=True)
    assert np.all(np.abs(found.vertical - up) < 3.0 * found.vertical_errors + 1e-3)
    assert np.all(np.abs(found.decades - TRUE) < 3.0 * found.errors + 1e-3)
    assert np.max(np.abs(found.vertical)) > 0.03


def test_a_spectrum_that_is_no_sum_of_a_few_branches_shifts_as_well():
    omega, law = np.geomspace(1.0, 300.0, 12), Wlf(12.0, 60.0, -40.0)
    temperatures = np.array([-50.0, -47.0, -44.0, -40.0, -35.0, -30.0])
    rng = np.random.default_rng(2)
    own = [(omega, noisy(sbr(omega * 10.0 ** law.decades(t)), 0.01, rng)) for t in temperatures]
    found = superposed(temperatures, own, 3)
    wanted = np.array([law.decades(t) for t in temperatures])
    assert np.all(np.abs(found.decades - wanted) <= 4.0 * found.errors)
    assert found.errors.max() < 0.1


def test_relaxation_tests_are_shifted_over_the_inverse_time():
    time = np.geomspace(1e-2, 10.0, 12)
    own = [
        (1.0 / time, 1e6 + sum(g * np.exp(-time / (b * 10.0**shift)) for g, b in BRANCHES))
        for shift in TRUE
    ]
    found = superposed(TEMPERATURES, own, REST)
    np.testing.assert_allclose(found.decades, TRUE, atol=5e-3)


def test_sweeps_without_a_modulus_in_common_are_refused():
    far = [(OMEGA, moduli(OMEGA * 10.0**shift, 1e6, [(1e9, 1e-3)])) for shift in (3.0, -3.0)]
    with pytest.raises(ValueError, match="the sweeps at 0 and 90 °C have no modulus in common"):
        superposed(np.array([0.0, 90.0]), far, 0)


KNOWN = np.diag([0.02, 0.01, 0.01, 0.0, 0.01, 0.02]) ** 2


@pytest.mark.parametrize("reference", [20.0, -3.0])
def test_constants_of_wlf_come_back_at_any_reference(reference):
    fit = fit_shifts(TEMPERATURES, TRUE, KNOWN, reference)
    c2 = WLF.c2 + reference - WLF.reference
    assert isinstance(fit.law, Wlf)
    assert fit.law == pytest.approx((WLF.c1 * WLF.c2 / c2, c2, reference), rel=1e-5)
    np.testing.assert_allclose(fit.decades, [fit.law.decades(t) for t in TEMPERATURES], atol=1e-6)


def test_it_does_not_matter_which_sweep_was_at_rest():
    rng = np.random.default_rng(0)
    raw = TRUE + 0.02 * rng.standard_normal(TRUE.size)
    each = 0.02**2 * np.eye(TRUE.size)
    found = []
    for rest in (1, 4):
        less = np.eye(TRUE.size) - np.eye(TRUE.size)[rest]
        found.append(fit_shifts(TEMPERATURES, less @ raw, less @ each @ less.T, 20.0))
    assert found[0].law == pytest.approx(found[1].law, rel=1e-3)
    assert found[0].errors == pytest.approx(found[1].errors, rel=1e-2)


def test_errors_of_the_constants_cover():
    off = []
    for seed in range(40):
        noise = np.random.default_rng(seed).standard_normal(TRUE.size) * np.sqrt(np.diag(KNOWN))
        fit = fit_shifts(TEMPERATURES, TRUE + noise, KNOWN, 20.0, "wlf")
        off.append((np.array(fit.law[:2]) - WLF[:2]) / fit.errors)
    assert 0.6 < np.sqrt(np.mean(np.square(off))) < 1.3


def test_the_law_that_describes_the_shifts_is_taken():
    law = Arrhenius(1.2e5, 20.0)
    shifts = np.array([law.decades(t) for t in TEMPERATURES])
    fit = fit_shifts(TEMPERATURES, shifts, KNOWN, 20.0, "arrhenius")
    assert fit.law == pytest.approx(law)
    assert isinstance(fit_shifts(TEMPERATURES, TRUE, KNOWN, 20.0).law, Wlf)
    other = fit_shifts(TEMPERATURES, TRUE, KNOWN, 20.0, "arrhenius")
    assert not other.holds
    assert other.worst > 0.05


def test_shifts_that_no_law_describes_are_a_table_that_is_zero_at_the_reference():
    shifts = TRUE + np.array([0.0, 0.4, -0.4, 0.0, 0.4, -0.4])
    fit = fit_shifts(TEMPERATURES, shifts, KNOWN, 25.0)
    assert isinstance(fit.law, ShiftTable)
    assert fit.law.decades(25.0) == pytest.approx(0.0, abs=1e-12)
    np.testing.assert_allclose(np.diff(fit.decades), np.diff(shifts))


@pytest.mark.parametrize(("law", "count"), [("wlf", 3), ("arrhenius", 2)])
def test_a_law_with_as_many_constants_as_shifts_is_none(law, count):
    own = slice(REST, REST + count)
    with pytest.raises(
        ValueError, match=f"{count} temperatures do not determine a law {law}: it needs"
    ):
        fit_shifts(TEMPERATURES[own], TRUE[own], KNOWN[own, own], 20.0, law)
