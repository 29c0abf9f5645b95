"""The study of three rheologies: their bells, the shift with temperature, the step."""

import numpy as np
import pytest

from elastomer_friction.kernels.rheology.spectrum import complex_modulus
from elastomer_friction.studies.rheology.figure import warmest
from elastomer_friction.workflow.study.read import read_study
from tests.support.studies import run

pytestmark = pytest.mark.exhaustive  # its scenes compile kernels of their own

DECADES = 2  # by which the times are longer at the colder temperature


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    """Return the study on a short line, at temperatures that shift times by steps of the grid."""
    wlf = read_study("rheology", "smoke").material.wlf
    cold = wlf.reference - DECADES * wlf.c2 / (wlf.c1 + DECADES)
    assert wlf.decades(cold) == pytest.approx(DECADES, abs=1e-12)
    warm = f"material.temperature=[{cold!r}, {wlf.reference!r}]"
    settings = (warm, "surface.length=2.5e-4", "grid.normal_force=1.25e-3")
    return run(tmp_path_factory.mktemp("rheology"), "rheology", *settings)


def sbr(omega):
    """Return G* (Pa) of the source: springpots of the Shull group (studies/rheology/sbr.csv)."""
    turn = 1j * omega / (2.0 * np.pi * 6.94e7)
    glass = 1.0 / (1.0 / (1.12e9 * turn ** (55 / 90)) + 1.0 / (1.12e9 * turn ** (2 / 90)))
    return (1.76e6 * turn ** (2.3 / 90) + glass) / 3.0


def test_branches_are_those_of_the_source():
    material = read_study("rheology").material.at_reference
    omega = np.geomspace(1e-2, 1e10, 49)
    spectrum = material.spectrum()
    modulus = [material.shear_modulus * complex_modulus(spectrum, w * material.tau) for w in omega]
    assert abs(np.array(modulus) / sbr(omega) - 1.0).max() < 0.02
    shift = material.shift(-30.0)  # Vogel's law of the source
    assert np.log(shift) == pytest.approx(481.0 / 48.4 - 481.0 / 98.4, rel=1e-4)


def test_rheologies_share_the_slowest_loss():
    materials = read_study("rheology").materials
    assert [m.at_reference.tau for m in materials.values()] == pytest.approx(
        [2.42723] * 3, rel=1e-4
    )
    glassy = {name: sum(g for g, _ in m.branches) for name, m in materials.items()}
    assert glassy["standard"] == pytest.approx(glassy[""], rel=1e-4)


def test_linear_solid_has_a_bell_and_kelvin_loses_its_contact(groups):
    standard, kelvin = warmest(groups["standard"]), warmest(groups["kelvin"])
    mu = standard.mu_1.values
    top = int(mu.argmax())
    assert 0 < top < mu.size - 1
    assert mu[-1] < 1e-2 * mu[top]
    np.testing.assert_allclose(mu[-2] / mu[-1], 10.0, rtol=0.05)  # glassy: mu falls as 1/v
    np.testing.assert_allclose(kelvin.mu_1[1] / kelvin.mu_1[0], 10.0, rtol=0.05)  # mu rises as v
    np.testing.assert_allclose(standard.mu_1[:3], kelvin.mu_1[:3], rtol=0.05)
    assert kelvin.contact_fraction[-1] < 0.1 * standard.contact_fraction[-1]


def test_rubber_has_the_broadest_bell(groups):
    data = groups[""].mu_1
    rubber = np.concatenate([data.isel(temperature=1)[:DECADES], data.isel(temperature=0)])
    widths = []
    for mu in (rubber, groups["standard"].mu_1.isel(temperature=1).values):
        widths.append(int((mu > 0.03 * mu.max()).sum()))
    assert widths[0] > widths[1]
    assert 0 < rubber.argmax() < rubber.size - 1
