"""Friction from dissipated energy: against loss moduli, fine lines and the Kelvin element."""

import numpy as np
import pytest

from elastomer_friction.kernels import Line, amplitudes, draw_phases
from elastomer_friction.kernels.branches.memory_friction import friction_by_loss
from elastomer_friction.kernels.branches.steady_memory import steady_memory
from elastomer_friction.kernels.rheology.forms import FORMS_BY_SCHEME
from elastomer_friction.kernels.rheology.retardation import retardation
from elastomer_friction.kernels.rheology.spectrum import complex_modulus
from tests.convergence import observed_order
from tests.sizes import PLAIN_PYTHON, size
from tests.viscoelastic import MATERIALS, PRONY3

ELEMENTS = size(120, 30)


def line_of(m, seed=1, elements=ELEMENTS):
    """Return a random line of H = 0.7 with m samples per spacing: the same line for every m."""
    phases = draw_phases(np.random.default_rng(seed), elements)
    return Line.self_affine(amplitudes(0.7, elements), phases, elements, m)


def friction(material, line, speed, load=0.1, scheme="exponential"):
    """Return (mu, contact) of steady sliding."""
    form = FORMS_BY_SCHEME[scheme](material)
    m = line.steps_per_spacing
    state = steady_memory(form, line.z, speed * m, load * line.z.size)
    return friction_by_loss(retardation(material), form, line, state.p, speed)


def errors_in_full_contact(material, rate, refinements, scheme="exponential"):
    """Return relative errors, (refinements, 1); on a sinusoid mu = a^2 q G''(q v) / (2 Fbar)."""
    q, a = 2.0 * np.pi / 32.0, 0.3
    modulus = complex_modulus(material, abs(rate))
    load = 1.5 * a * abs(modulus)
    exact = np.sign(rate) * a**2 * q * modulus.imag / (2.0 * load)
    errors = []
    for m in refinements:
        x = np.arange(32 * m) / m
        line = Line.from_samples(a * np.cos(q * x), -a * q * np.sin(q * x), int(m))
        mu, contact = friction(material, line, rate / q, load, scheme)
        assert contact == 1.0
        errors.append([mu / exact - 1.0])
    return np.array(errors)


@pytest.mark.parametrize("name", MATERIALS)
@pytest.mark.parametrize("scheme", FORMS_BY_SCHEME)
@pytest.mark.parametrize("rate", [0.3, 5.0, -100.0])
def test_a_sinusoid_in_full_contact_shows_the_loss_modulus(name, scheme, rate):
    """In full contact every element is driven harmonically."""
    refinements = np.array([1, 2, 4])
    errors = errors_in_full_contact(MATERIALS[name], rate, refinements, scheme)
    assert np.abs(errors[-1]).max() < (2e-3 if scheme == "exponential" else 2e-2)
    if name in ("Kelvin", "standard", "Prony3") and scheme == "exponential":
        assert observed_order(refinements, errors) > 1.7


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: long, fine lines")
@pytest.mark.parametrize(("name", "speed"), [
    ("standard", 1e-4), ("standard", 0.1), ("standard", 10.0), ("standard", 1e4),
    ("Prony3", 1e-4), ("Prony3", 3.0), ("SBR", 1e-4), ("SBR", 1e3), ("dashpot", 1e-4),
])  # fmt: skip
def test_four_samples_per_spacing_are_near_sixty_four(name, speed):
    """This holds even at low speeds, where the sum over samples errs by more than the friction."""
    errors = []
    for seed in range(3):
        coarse = friction(MATERIALS[name], line_of(4, seed), speed)[0]
        errors.append(coarse / friction(MATERIALS[name], line_of(64, seed), speed)[0] - 1.0)
    assert np.sqrt(np.mean(np.square(errors))) < 0.03


def test_friction_is_nan_where_nothing_touches():
    line, form = line_of(4), retardation(PRONY3)
    state = steady_memory(form, line.z, 1.0, np.nan, -1.0)
    mu, contact = friction_by_loss(form, form, line, state.p, 0.25)
    assert np.isnan(mu)
    assert contact == 0.0
