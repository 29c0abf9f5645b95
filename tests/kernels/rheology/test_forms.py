"""Both forms of a material do what it does: known histories, and orders towards them."""

import numpy as np
import pytest

from elastomer_friction.kernels.rheology.forms import FORMS
from elastomer_friction.kernels.rheology.law import (
    Elements,
    displacement,
    lasting,
    law_of,
    memories,
    rest,
)
from elastomer_friction.kernels.rheology.retardation import retardation
from elastomer_friction.kernels.rheology.spectrum import KELVIN, relaxation_modulus
from tests.convergence import observed_order
from tests.viscoelastic import MATERIALS, Foundation

REFINEMENTS = np.array([1, 2, 4, 8])


def fresh(form, n=1):
    """Return elements that nothing has touched."""
    return Elements(np.zeros((memories(form), n)), np.zeros(n), 0.0)


def held_indentation(name, scheme, refinement):
    """Return the largest relative error of F(t) at constant d, from the second decade on."""
    spectrum = MATERIALS[name]
    form = FORMS[scheme](spectrum)
    glass = 1.0 + sum(spectrum.moduli)
    # At 0+ the line is in, and no time has passed: nothing has crept yet.
    elements = Elements(np.zeros((memories(form), 1)), np.full(1, glass), 1.0)
    if scheme == "implicit-euler":  # its memory is the stress of the branches and u = -1
        elements.memory[:-1, 0] = -form.moduli
        elements.memory[-1, 0] = -1.0
    line, worst, now = Foundation(form, np.zeros(1), elements), 0.0, 0.0
    for end in np.geomspace(1e-4, 10.0, 40 * refinement + 1):
        line.step(0, end - now, d=1.0)
        now = end
        exact = float(relaxation_modulus(spectrum, now))
        worst = max(worst, abs(line.p[0] / exact - 1.0)) if now > 1e-3 else worst
    return worst


@pytest.mark.parametrize("name", ["standard", "Prony3"])
def test_stress_relaxes_as_the_modulus_says_at_second_order(name):
    errors = [[held_indentation(name, "exponential", k)] for k in REFINEMENTS]
    assert observed_order(REFINEMENTS, errors) > 1.8
    assert errors[-1][0] < 2e-3


@pytest.mark.parametrize("name", ["standard", "Prony3"])
def test_stress_relaxes_exactly_in_the_relaxation_form(name):
    assert held_indentation(name, "implicit-euler", 1) < 1e-12


@pytest.mark.parametrize("name", MATERIALS)
def test_creep_without_force_is_exact_whatever_the_step(name):
    form = retardation(MATERIALS[name])
    elements = Elements(rest(form, np.ones(1)), np.zeros(1), -1.0)
    line = Foundation(form, np.zeros(1), elements)
    now = 0.0
    for dt in (1e-9, 1e-3, 0.4, 2.0, 1e3):
        now += dt
        line.step(0, dt, d=-2.0)  # far above: nothing touches
        u = displacement(form, line.memory, line.p)
        exact = -np.sum(form.compliances * np.exp(-now / form.times))
        assert u == pytest.approx(exact, rel=1e-12, abs=1e-300)


@pytest.mark.parametrize("name", MATERIALS)
@pytest.mark.parametrize("scheme", FORMS)
def test_what_rests_under_a_force_stays(name, scheme):
    form = FORMS[scheme](MATERIALS[name])
    p = np.array([2.0])
    line = Foundation(form, np.zeros(1), Elements(rest(form, p), p, 2.0))
    assert displacement(form, line.memory, line.p) == pytest.approx(-2.0, rel=1e-14)
    viscosity, pressure = lasting(form, line.memory)
    assert (viscosity > 0.0) == (MATERIALS[name].viscosity > 0.0)
    if viscosity > 0.0:
        assert viscosity == pytest.approx(MATERIALS[name].viscosity, rel=1e-13)
        assert pressure == pytest.approx(p, rel=1e-13)
    for dt in (1e-3, 1.0, 1e6):
        line.step(0, dt, load=2.0)
        assert line.d == pytest.approx(2.0, rel=1e-12)
        assert line.p == pytest.approx(p, rel=1e-11)  # rounding of u counts 1 / dt times


@pytest.mark.parametrize("name", MATERIALS)
def test_both_forms_press_in_alike(name):
    """Indented at a constant rate from nothing: two derivations, one limit."""

    def force(scheme, steps):
        form = FORMS[scheme](MATERIALS[name])
        line = Foundation(form, np.zeros(1), fresh(form))
        for k in range(steps):
            line.step(0, 1.0 / steps, d=(k + 1.0) / steps)
        return line.p[0]

    counts = 32 * REFINEMENTS
    gaps = [[force("exponential", k) / force("implicit-euler", k) - 1.0] for k in counts]
    assert np.abs(gaps).max() < 3e-2
    assert abs(gaps[-1][0]) < 3e-3
    if name in ("Kelvin", "standard", "Prony3"):  # what is fast is resolved from the first on
        assert observed_order(counts, gaps) > 0.9


@pytest.mark.parametrize("dt", np.geomspace(1e-9, 1e6, 16))
@pytest.mark.parametrize("name", ["standard", "Prony3", "SBR", "dashpot"])
def test_the_old_force_comes_back_with_a_gain_below_one(name, dt):
    law = law_of(retardation(MATERIALS[name]), dt)
    assert 0.0 <= law.linear <= 1.0
    assert law.stale.sum() * law.stiffness <= 0.8 + 1e-12
    assert 0.0 <= law.lag <= 0.5 + 1e-12


def test_kelvin_memory():
    assert {scheme: memories(form(KELVIN)) for scheme, form in FORMS.items()} == {
        "exponential": 1,
        "implicit-euler": 1,
    }
