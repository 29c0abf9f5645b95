"""Response to velocity jumps: a jump of mu with a dashpot, a jump of d mu/dt without one."""

import numpy as np
import pytest

from elastomer_friction.kernels import Line, amplitudes, draw_phases, quadrature, steady_sliding
from elastomer_friction.kernels.branches.memory_friction import friction_jump, initial_rate
from elastomer_friction.kernels.branches.steady_memory import steady_memory
from elastomer_friction.kernels.model.friction import lagged_slope
from elastomer_friction.kernels.rheology.forms import FORMS_BY_SCHEME
from elastomer_friction.kernels.rheology.kelvin import SCHEMES
from elastomer_friction.kernels.rheology.law import law_of
from elastomer_friction.kernels.rheology.spectrum import KELVIN
from tests.viscoelastic import MATERIALS, Foundation, of_unit_tau

ELEMENTS = 16


def line_of(m):
    """Return a smooth random line with m samples per spacing."""
    phases = draw_phases(np.random.default_rng(2), ELEMENTS)
    return Line.self_affine(amplitudes(1.0, ELEMENTS), phases, ELEMENTS, m)


def steady(material, line, speed, scheme="exponential", load=0.3):
    """Return (form, elements) of steady sliding."""
    form = FORMS_BY_SCHEME[scheme](material)
    m = line.steps_per_spacing
    return form, steady_memory(form, line.z, speed * m, load * line.z.size).elements


def sliding(material, line, speed, scheme="exponential"):
    """Return the first arguments of friction_jump, up to the elements."""
    form, elements = steady(material, line, speed, scheme)
    return form, line, elements


@pytest.mark.parametrize("ratio", [0.5, 1.0, 1.2, 5.0])
def test_a_kelvin_element_jumps_as_in_its_quadrature(ratio):
    line, speed = line_of(4), 2.0
    load = 0.3 * line.z.size
    state, _ = steady_sliding(SCHEMES["exponential"](1.0 / (4.0 * speed)), line.z, load)
    mu = [quadrature(line.z, line.slope, *state, speed, s * speed, load)[0] for s in (1.0, ratio)]
    jump = friction_jump(*sliding(KELVIN, line, speed), speed, ratio)
    assert jump == pytest.approx(mu[1] - mu[0], rel=1e-4, abs=1e-12)


@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_full_contact_jumps_by_the_share_of_the_dashpot(direction):
    """The jump is eta (v2 - v1) mean(z'^2) / Fbar, whatever the branches."""
    q, a, m = 2.0 * np.pi / 32.0, 0.3, 4
    x = np.arange(32 * m) / m
    line = Line.from_samples(a * np.cos(q * x), -a * q * np.sin(q * x), m)
    material, load = MATERIALS["dashpot"], 40.0
    for scheme in FORMS_BY_SCHEME:
        form, elements = steady(material, line, direction * 3.0, scheme, load)
        expected = direction * material.viscosity * 3.0 * 0.4 * (a * q) ** 2 / (2.0 * load)
        jump = friction_jump(form, line, elements, direction * 3.0, 1.4)
        assert jump == pytest.approx(expected, rel=1e-9)


def test_a_march_jumps_by_the_formula():
    """The change of mu in the first step converges to the formula under refinement."""
    material, speed, ratio = MATERIALS["dashpot"], 3.0, 2.0
    errors = []
    for m in (32, 256):
        line = line_of(m)
        form, elements = steady(material, line, speed)
        law = law_of(form, 1.0 / (speed * m))
        before = np.dot(elements.p, lagged_slope(line.slope, law.lag)) / elements.p.sum()
        after = first_step(form, line, elements, ratio * speed)
        errors.append((after - before) / friction_jump(form, line, elements, speed, ratio) - 1.0)
    assert abs(errors[1]) < 0.15
    assert abs(errors[1]) < 0.3 * abs(errors[0])


def first_step(form, line, elements, speed):
    """Return mu of the first step at another speed, averaged over the step."""
    m = line.steps_per_spacing
    march = Foundation(form, line.z, elements)
    march.step(1, 1.0 / (speed * m), load=float(elements.p.sum()))
    weight = lagged_slope(line.slope, law_of(form, 1.0 / (speed * m)).lag)
    return float(np.dot(np.roll(march.p, -1), weight) / march.p.sum())


@pytest.mark.parametrize("ratio", [0.5, 1.5])
def test_without_a_dashpot_the_rate_jumps(ratio):
    """The rate that the change of speed adds in the first step agrees with the formula."""
    material, speed = of_unit_tau((10.0, 3.0), (0.05, 0.5)), 1.0
    line = line_of(512)
    units, elements = steady(material, line, speed)
    dt = 1.0 / (ratio * speed * 512)
    start = np.dot(elements.p, line.slope) / elements.p.sum()
    rate = (first_step(units, line, elements, ratio * speed) - start) / dt
    constant = (first_step(units, line, elements, speed) - start) * speed * 512
    expected = initial_rate(units, line, elements.p, speed, ratio)
    assert rate - constant == pytest.approx(expected, rel=0.1)
