"""Orders of convergence at all speeds and loads, and the change of friction on halving the step."""

import numpy as np
import pytest

from elastomer_friction.kernels import (
    SCHEMES,
    Case,
    Line,
    Quantities,
    amplitudes,
    draw_phases,
    run_case,
)
from tests.convergence import observed_order
from tests.lines import parabola
from tests.references import parabola_forces
from tests.sizes import size

STEADY = Quantities(jump=False, relaxation=False)
REFINEMENTS = np.array(size([8, 16, 32, 64], [8, 64]))
OFFSETS = (0.0, 0.17, 0.31, 0.5, 0.73, 0.9)
ORDERS = {"exponential": 1.8, "implicit-euler": 0.9}


def steady(line, load, speed, scheme):
    """Return the outcome of steady sliding only."""
    return run_case(line, Case(load, speed, (), (), scheme), STEADY)


@pytest.mark.parametrize("depth", [0.1, 4.5])
@pytest.mark.parametrize("speed", [0.02, 0.1, 1.0, *size([8.0, 64.0], [8.0])])
@pytest.mark.parametrize("scheme", SCHEMES)
def test_order_holds_from_slow_to_fast_and_light_to_heavy(scheme, speed, depth):
    """Errors of d and mu, with 8 or more samples per tau and per contact size."""
    elements = int(max(16, 6.0 * np.sqrt(2.0 * depth) + 30.0 * speed))  # memory of e^-30
    normal, tangential = parabola_forces(depth, 1.0, speed)
    errors = []
    for refinement in REFINEMENTS:
        m = int(refinement * max(1.0, 1.0 / speed, depth**-0.5))
        row = []
        for offset in OFFSETS:
            line = Line.from_samples(*parabola(elements, m, offset, 1.0), m)
            actual = steady(line, normal / elements, speed, scheme)
            row += [actual.indentation / depth - 1.0, actual.mu_1 / (tangential / normal) - 1.0]
        errors.append(row)
    assert observed_order(REFINEMENTS, np.array(errors)) > ORDERS[scheme]
    allowed = {"exponential": 2.0 / REFINEMENTS[-1] ** 2, "implicit-euler": 0.3 / REFINEMENTS[-1]}
    assert np.abs(errors[-1]).max() < allowed[scheme]


@pytest.mark.parametrize("load", [1e-2, 0.3, 10.0, 1e4])
@pytest.mark.parametrize("x", [1e-4, 1e-2, 1.0, 30.0, 1e3, 1e6])
@pytest.mark.parametrize("scheme", SCHEMES)
def test_halving_the_step_changes_friction_by_less_than_predicted(scheme, x, load):
    """The bound, relative to mu, is 100 / (samples in contact)^2, plus 0.5 / m for first order.

    See docs/stability.md. Contacts narrower than 8 samples are not tested.
    """
    elements = 16
    amplitude = amplitudes(1.0, elements)
    for seed in range(size(12, 4)):
        phases = draw_phases(np.random.default_rng(seed), elements)
        for m in (8, 16, 32)[: size(3, 2)]:
            one, half = (
                steady(Line.self_affine(amplitude, phases, elements, q), load, x / np.pi, scheme)
                for q in (m, 2 * m)
            )
            samples = one.contact_fraction * elements * m
            predicted = 100.0 / samples**2 + (0.5 / m if scheme == "implicit-euler" else 0.0)
            assert abs(half.mu_1 / one.mu_1 - 1.0) < predicted or samples < 8.0
