"""RelaxationForm of a material in time and in frequency."""

import numpy as np
import pytest
from scipy.integrate import quad

from elastomer_friction.kernels.rheology.spectrum import (
    KELVIN,
    Spectrum,
    complex_modulus,
    relaxation_modulus,
)
from tests.viscoelastic import MATERIALS, PRONY3


@pytest.mark.parametrize("omega", [0.3, 3.0, 30.0])
def test_complex_modulus_is_the_transform_of_the_relaxation_modulus(omega):
    """G* = 1 + i omega int (G(t) - 1) e^(-i omega t) dt: the definition, integrated."""
    parts = [
        quad(lambda t: float(relaxation_modulus(PRONY3, t)) - 1.0, 0.0, 20.0, weight=weight,
             wvar=omega, limit=400)[0]
        for weight in ("cos", "sin")
    ]  # fmt: skip
    expected = 1.0 + 1j * omega * (parts[0] - 1j * parts[1])
    assert complex_modulus(PRONY3, omega) == pytest.approx(expected, rel=1e-6)


def test_kelvin_element():
    omega = np.array([0.0, 0.5, 7.0])
    assert complex_modulus(KELVIN, omega) == pytest.approx(1.0 + 1j * omega, rel=1e-15)
    assert np.all(relaxation_modulus(KELVIN, omega + 1.0) == 1.0)


@pytest.mark.parametrize("name", MATERIALS)
def test_a_material_is_relaxed_in_the_end_and_viscous_as_tau_says(name):
    """tau = (eta + sum g t) / G is the slope of G'' at rest: the same friction at low speeds."""
    omega = 1e-9
    modulus = complex_modulus(MATERIALS[name], omega)
    assert modulus.real == pytest.approx(1.0, abs=1e-6)
    assert modulus.imag / omega == pytest.approx(1.0, rel=1e-6)


def test_a_branch_needs_a_time():
    with pytest.raises(ValueError, match="zip"):
        complex_modulus(Spectrum((1.0, 2.0), (1.0,), 0.0), 1.0)
