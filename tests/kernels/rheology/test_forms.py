"""One step of each form of a material, and known histories: exact, or at the expected order."""

import numpy as np
import pytest
from scipy.integrate import quad

from elastomer_friction.kernels import SCHEMES
from elastomer_friction.kernels.rheology.forms import FORMS_BY_SCHEME
from elastomer_friction.kernels.rheology.law import (
    Elements,
    advance_memory,
    displacement,
    law_of,
    memory_size,
    predict,
    rest_memory,
    static_pressure,
)
from elastomer_friction.kernels.rheology.lookahead import (
    fill_memory,
    lookahead_law,
    lookahead_memory,
    slide_element,
)
from elastomer_friction.kernels.rheology.prony import moments
from elastomer_friction.kernels.rheology.relaxed import relaxation
from elastomer_friction.kernels.rheology.retardation import Retardation, retardation
from elastomer_friction.kernels.rheology.spectrum import KELVIN, relaxation_modulus
from tests.convergence import observed_order
from tests.reference_march import constants
from tests.viscoelastic import MATERIALS, PRONY3, Foundation


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("dt", np.geomspace(1e-6, 30.0, 15))
def test_constants_are_those_of_the_defining_formulas(scheme, dt):
    step = SCHEMES[scheme](dt)
    # Some formulas lose digits as eps / dt; 20 Gauss nodes integrate the lag to rounding.
    lost = 1e-15 + 4e-16 / dt
    expected = constants(scheme, dt)
    assert step.decay == pytest.approx(expected[0], rel=1e-15)
    assert step[1:] == pytest.approx(expected[1:], rel=1e-12 + lost)
    # The force of an element held at u is -u (eq. 2).
    assert step.stiffness * (1.0 - step.decay) == pytest.approx(1.0, rel=lost)


def test_lag_of_the_exponential_scheme_between_its_limits():
    lag = [SCHEMES["exponential"](dt).lag for dt in np.geomspace(1e-12, 1e6, 400)]
    assert lag[0] == pytest.approx(0.5, abs=1e-12)  # dt -> 0: uniform weight
    assert lag[-1] == pytest.approx(1e-6, rel=1e-12)  # dt -> inf: the last tau counts
    assert np.all(np.diff(lag) < 1e-12)  # falling; rounding of 1/dt - 1/expm1(dt) below 1e-3


@pytest.mark.parametrize("dt", np.geomspace(1e-9, 1e9, 19))
def test_one_unit_is_the_kelvin_element(dt):
    law, kelvin = law_of(retardation(KELVIN), dt), SCHEMES["exponential"](dt)
    assert law.decay[0] == pytest.approx(kelvin.decay, rel=1e-15)
    assert law.stiffness == pytest.approx(kelvin.stiffness, rel=1e-14)
    assert law.lag == pytest.approx(kelvin.lag, rel=1e-11)
    assert (law.linear, law.stale[0]) == (0.0, 0.0)


@pytest.mark.parametrize("x", [1e-12, 1e-4, 0.0999, 0.1001, 3.0, 50.0, 1e8])
def test_moments_are_those_of_a_linear_force(x):
    """The weights of end and start force are integrals with the weight e^-(x - s)."""
    _, gone, end, start = moments(x)
    assert gone == pytest.approx(-np.expm1(-x), rel=1e-15)
    assert end + start == pytest.approx(gone, rel=1e-13)
    if x < 100.0:
        expected, _ = quad(lambda s: np.exp(-(1.0 - s) * x) * x * s, 0.0, 1.0, epsrel=1e-13)
        assert end == pytest.approx(expected, rel=1e-11)


def test_a_linear_force_is_followed_exactly():
    """Under p = t each unit has y = -J (t - lambda (1 - e^(-t/lambda))), in uneven steps."""
    form = Retardation(1.0, np.array([0.7, 0.3]), np.array([2.0, 0.1]))
    memory, p, w, now = np.zeros((2, 1)), np.zeros(1), np.empty(1), 0.0
    for dt in (0.01, 0.3, 1.1, 1e-5):
        now += dt
        law, new = law_of(form, dt), np.array([now])
        assert law.linear == 1.0
        predict(law, memory, p, w)
        advance_memory(law, memory, w, p, new)
        p = new
    lag = form.times * -np.expm1(-now / form.times)
    assert memory[:, 0] == pytest.approx(-form.compliances * (now - lag), rel=1e-13)


def test_what_is_left_of_a_state_is_never_subnormal():
    law = law_of(retardation(KELVIN), 1.0)
    memory, w, p = np.array([[-1.0]]), np.empty(1), np.zeros(1)
    for _ in range(1000):
        predict(law, memory, p, w)
        advance_memory(law, memory, w, p, p)
        assert memory[0, 0] == 0.0 or abs(memory[0, 0]) > 1e-201
    assert memory[0, 0] == 0.0


@pytest.mark.parametrize("dt", np.geomspace(1e-9, 1e6, 16))
def test_without_branches_it_is_implicit_euler(dt):
    law, kelvin = law_of(relaxation(KELVIN), dt), SCHEMES["implicit-euler"](dt)
    assert (law.stiffness, law.lag) == (pytest.approx(kelvin.stiffness, rel=1e-15), 0.0)
    memory, w = np.array([[-1.0]]), np.empty(1)
    predict(law, memory, np.zeros(1), w)
    assert w == pytest.approx(-kelvin.decay, rel=1e-14)
    advance_memory(law, memory, w, np.zeros(1), np.zeros(1))
    assert memory[0] == pytest.approx(-kelvin.decay, rel=1e-14)


def test_a_constant_rate_is_followed_exactly():
    """For u = -t the force is t + sum g t_b (1 - e^(-t/t_b)), in uneven steps."""
    form = relaxation(PRONY3)
    memory, w, now, p = np.zeros((4, 1)), np.empty(1), 0.0, np.zeros(1)
    for dt in (0.01, 0.3, 1.1, 1e-5):
        now += dt
        law = law_of(form, dt)
        predict(law, memory, p, w)
        p = law.stiffness * (w + now)
        advance_memory(law, memory, w, p, p)
        stresses = form.moduli * form.times * -np.expm1(-now / form.times)
        assert p == pytest.approx(now + stresses.sum(), rel=1e-11)
    assert memory[-1] == pytest.approx(-now, rel=1e-13)
    assert memory[:-1, 0] == pytest.approx(-stresses, rel=1e-11)


REFINEMENTS = np.array([1, 2, 4, 8])


def fresh(form, n=1):
    """Return elements that have never been touched."""
    return Elements(np.zeros((memory_size(form), n)), np.zeros(n), 0.0)


def held_indentation(name, scheme, refinement):
    """Return the largest relative error of the force at constant d, from the second decade on."""
    spectrum = MATERIALS[name]
    form = FORMS_BY_SCHEME[scheme](spectrum)
    glass = 1.0 + sum(spectrum.moduli)
    # At t = 0+ the line is indented, but nothing has crept yet.
    elements = Elements(np.zeros((memory_size(form), 1)), np.full(1, glass), 1.0)
    if scheme == "implicit-euler":  # the memory is the stress of the branches, and u = -1
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
    elements = Elements(rest_memory(form, np.ones(1)), np.zeros(1), -1.0)
    line = Foundation(form, np.zeros(1), elements)
    now = 0.0
    for dt in (1e-9, 1e-3, 0.4, 2.0, 1e3):
        now += dt
        line.step(0, dt, d=-2.0)  # far above: nothing touches
        u = displacement(form, line.memory, line.p)
        exact = -np.sum(form.compliances * np.exp(-now / form.times))
        assert u == pytest.approx(exact, rel=1e-12, abs=1e-300)


@pytest.mark.parametrize("name", MATERIALS)
@pytest.mark.parametrize("scheme", FORMS_BY_SCHEME)
def test_what_rests_under_a_force_stays(name, scheme):
    form = FORMS_BY_SCHEME[scheme](MATERIALS[name])
    p = np.array([2.0])
    line = Foundation(form, np.zeros(1), Elements(rest_memory(form, p), p, 2.0))
    assert displacement(form, line.memory, line.p) == pytest.approx(-2.0, rel=1e-14)
    viscosity, pressure = static_pressure(form, line.memory)
    assert (viscosity > 0.0) == (MATERIALS[name].viscosity > 0.0)
    if viscosity > 0.0:
        assert viscosity == pytest.approx(MATERIALS[name].viscosity, rel=1e-13)
        assert pressure == pytest.approx(p, rel=1e-13)
    for dt in (1e-3, 1.0, 1e6):
        line.step(0, dt, load=2.0)
        assert line.d == pytest.approx(2.0, rel=1e-12)
        assert line.p == pytest.approx(p, rel=1e-11)  # rounding of u is amplified by 1 / dt


@pytest.mark.parametrize("name", MATERIALS)
def test_both_forms_press_in_alike(name):
    """At a constant rate of indentation the two derivations converge to one limit."""

    def force(scheme, steps):
        form = FORMS_BY_SCHEME[scheme](MATERIALS[name])
        line = Foundation(form, np.zeros(1), fresh(form))
        for k in range(steps):
            line.step(0, 1.0 / steps, d=(k + 1.0) / steps)
        return line.p[0]

    counts = 32 * REFINEMENTS
    gaps = [[force("exponential", k) / force("implicit-euler", k) - 1.0] for k in counts]
    assert np.abs(gaps).max() < 3e-2
    assert abs(gaps[-1][0]) < 3e-3
    if name in ("Kelvin", "standard", "Prony3"):  # all times are resolved at any refinement
        assert observed_order(counts, gaps) > 0.9


@pytest.mark.parametrize("dt", np.geomspace(1e-9, 1e6, 16))
@pytest.mark.parametrize("name", ["standard", "Prony3", "SBR", "dashpot"])
def test_the_old_force_comes_back_with_a_gain_below_one(name, dt):
    law = law_of(retardation(MATERIALS[name]), dt)
    assert 0.0 <= law.linear <= 1.0
    assert law.stale.sum() * law.stiffness <= 0.8 + 1e-12
    assert 0.0 <= law.lag <= 0.5 + 1e-12


@pytest.mark.parametrize("count", [1, 7, 8, 9, 16, 30])
@pytest.mark.parametrize("name", MATERIALS)
@pytest.mark.parametrize("scheme", FORMS_BY_SCHEME)
def test_an_element_that_meets_many_samples_is_stepped_like_one(scheme, name, count):
    form, rng = FORMS_BY_SCHEME[scheme](MATERIALS[name]), np.random.default_rng(3)
    law, heights, d = law_of(form, 0.02), rng.normal(size=count), 0.4
    memory, p, w = rest_memory(form, np.full(1, 0.1)), np.full(1, 0.1), np.empty(1)
    ahead = lookahead_law(law)
    y = lookahead_memory(ahead, memory[:, 0], p[0])
    began, forces = y.copy(), np.empty(count)
    total = slide_element(ahead, y, d, heights, forces)
    filled = np.empty((memory.size, count))
    fill_memory(ahead, began, forces[::-1].copy(), filled, count - 1, -1, count)
    assert total == pytest.approx(forces.sum(), rel=1e-12)
    np.testing.assert_allclose(began, y, rtol=1e-11, atol=1e-13)
    for i in range(count):
        predict(law, memory, p, w)
        new = law.stiffness * np.maximum(0.0, w + d - heights[i])
        advance_memory(law, memory, w, p, new)
        p = new
        assert forces[i] == pytest.approx(new[0], rel=1e-11, abs=1e-13)
        np.testing.assert_allclose(filled[:, count - 1 - i], memory[:, 0], rtol=1e-11, atol=1e-13)
    assert 0 < np.count_nonzero(forces) < count or count == 1
