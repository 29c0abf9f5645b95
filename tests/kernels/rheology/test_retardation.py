"""Moduli of a material, and its conversion from the relaxation to the retardation form."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from elastomer_friction.kernels.rheology.retardation import retardation
from elastomer_friction.kernels.rheology.spectrum import (
    Spectrum,
    complex_modulus,
    relaxation_modulus,
)
from tests.viscoelastic import MATERIALS, PRONY3


@pytest.mark.parametrize("omega", [0.3, 3.0, 30.0])
def test_complex_modulus_is_the_transform_of_the_relaxation_modulus(omega):
    """The definition is G* = 1 + i omega int (G(t) - 1) e^(-i omega t) dt."""
    parts = [
        quad(lambda t: float(relaxation_modulus(PRONY3, t)) - 1.0, 0.0, 20.0, weight=weight,
             wvar=omega, limit=400)[0]
        for weight in ("cos", "sin")
    ]  # fmt: skip
    expected = 1.0 + 1j * omega * (parts[0] - 1j * parts[1])
    assert complex_modulus(PRONY3, omega) == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("name", MATERIALS)
def test_a_material_is_relaxed_in_the_end_and_viscous_as_tau_says(name):
    """tau = (eta + sum g t) / G is the slope of G'' at omega = 0, which sets low-speed friction."""
    omega = 1e-9
    modulus = complex_modulus(MATERIALS[name], omega)
    assert modulus.real == pytest.approx(1.0, abs=1e-6)
    assert modulus.imag / omega == pytest.approx(1.0, rel=1e-6)


OMEGA = np.geomspace(1e-9, 1e9, 181)
BRANCHES = st.lists(st.tuples(st.floats(-6, 6), st.floats(-9, 5)), max_size=30)


def compliance(spectrum):
    """Return J*(omega) of the retardation form."""
    units = retardation(spectrum)
    return units.glass + np.sum(
        units.compliances / (1.0 + 1j * OMEGA[:, None] * units.times), axis=1
    )


def exchanged(spectrum):
    """Return the largest deviation of compliance times modulus from one."""
    return np.abs(compliance(spectrum) * complex_modulus(spectrum, OMEGA) - 1.0).max()


@pytest.mark.parametrize("name", MATERIALS)
def test_compliance_is_the_inverse_of_the_modulus(name):
    assert exchanged(MATERIALS[name]) < 1e-14


@settings(max_examples=40)
@example([(2.0, -2.0), (0.0, -1.9999999999999998), (2.0, -1.9999999999999996)], 0.0)
@given(BRANCHES, st.one_of(st.just(0.0), st.floats(1e-9, 1e9)))
def test_any_branches_over_fourteen_decades(branches, viscosity):
    moduli = tuple(10.0**g for g, _ in branches)
    times = tuple(10.0**t for _, t in branches)
    if not branches and viscosity == 0.0:
        return
    spectrum = Spectrum(moduli, times, viscosity)
    units = retardation(spectrum)
    assert np.all(units.compliances > 0.0)
    assert np.all(np.diff(units.times) <= 0.0)  # times that differ in the last bit may merge
    assert units.glass + units.compliances.sum() == pytest.approx(1.0, abs=1e-14)
    assert exchanged(spectrum) < 1e-12


def test_retardation_times_lie_between_relaxation_times():
    spectrum = Spectrum(tuple(np.full(30, 0.7)), tuple(np.geomspace(1e-7, 1e7, 30)), 0.0)
    units, times = retardation(spectrum), np.sort(spectrum.times)[::-1]
    assert np.all(units.times > times)
    assert np.all(units.times[1:] < times[:-1])
    assert exchanged(spectrum) < 1e-13


@pytest.mark.parametrize(
    ("spectrum", "line"),
    [
        (Spectrum((0.0,), (1.0,), 1.0), "modulus = 0: that of a branch must be positive, finite"),
        (Spectrum((1.0,), (-2.0,), 1.0), "time = -2: that of a branch must be positive, finite"),
        (Spectrum((np.nan,), (1.0,), 1.0), "modulus = nan: that of a branch must be positive"),
        (Spectrum((1.0,), (np.inf,), 1.0), "time = inf: that of a branch must be positive"),
        (Spectrum((1.0,), (1.0,), -1.0), "viscosity = -1: must be finite, not negative"),
        (Spectrum((), (), 0.0), "a material needs a branch or a dashpot"),
    ],
)
def test_branches_without_a_meaning_are_refused(spectrum, line):
    with pytest.raises(ValueError, match=line):
        retardation(spectrum)
