"""Energy balance of programmes, and the dissipation of a step against quadrature."""

import itertools

import numpy as np
import pytest

from elastomer_friction.kernels.body.element_line import element_line
from elastomer_friction.kernels.body.step import Move
from elastomer_friction.kernels.model.force import ConstantForce
from elastomer_friction.kernels.motion.legs import Hold, Oscillation, Ramp, Slide
from elastomer_friction.kernels.motion.track import Track
from elastomer_friction.kernels.rheology.forms import FORMS_BY_SCHEME
from elastomer_friction.kernels.rheology.law import (
    Elements,
    advance_memory,
    displacement,
    law_of,
    predict,
)
from elastomer_friction.kernels.rheology.spectrum import KELVIN
from elastomer_friction.kernels.scene.energy import (
    EnergyRecord,
    add_step_energies,
    stored_energy,
)
from tests.convergence import observed_order
from tests.kernels.scene.given import EVERY_LEG, MATERIALS, SOLID, a_line, trace
from tests.sizes import size

ALL = ("trace", "energy", "contact_lengths", "snapshots", "state")
PROGRAMMES = {
    "slide, hold, slide": (Slide(0.5, 3.0), Hold(2.0), Slide(0.5, 3.0)),
    "reversal": (Slide(0.5, 3.3), Slide(-0.8, 4.0)),
    "ramp": (Ramp(0.2, 2.0, 4.0),),
    "oscillation": (Oscillation(0.0, 1.5, 0.3, 1),),
}


def balance(result):
    """Return (work - change of stored - dissipated, closing work, dissipated), all cumulative."""
    change = result["stored_energy"] - result["stored_energy"][0]
    missing = result["work"] - change - result["dissipated_energy"]
    return missing, result["closing_work"], result["dissipated_energy"]


def test_with_a_dashpot_alone_the_balance_closes_to_rounding_by_the_closing_work():
    result = trace(a_line(), EVERY_LEG, KELVIN, start="relaxed", requested=ALL)
    missing, closing, dissipated = balance(result)
    np.testing.assert_allclose(missing, closing, rtol=0, atol=1e-12 * dissipated[-1])
    assert closing[-1] > 1e-4 * dissipated[-1]


def test_with_branches_beside_a_dashpot_the_balance_closes_with_the_step():
    """Forces of the last step act on units that are faster than the step (rheology/prony.py)."""
    refinements, errors = np.array([4, 8, 16, 32])[: size(4, 2)], []
    for m in refinements:
        line = a_line(size(20, 8), 1.0, m, 0)
        result = trace(
            line, PROGRAMMES["reversal"], MATERIALS["damped"], start="relaxed", requested=ALL
        )
        missing, closing, dissipated = balance(result)
        errors.append([(missing[-1] - closing[-1]) / dissipated[-1]])
    assert observed_order(refinements, errors) > 1.2
    assert abs(errors[-1][0]) < size(5e-3, 0.05)


@pytest.mark.parametrize("name", MATERIALS)
@pytest.mark.parametrize("programme", PROGRAMMES)
def test_no_step_gains_energy(name, programme):
    result = trace(a_line(), PROGRAMMES[programme], MATERIALS[name], start="relaxed", requested=ALL)
    assert np.all(np.diff(result["dissipated_energy"]) >= 0.0)
    assert np.all(result["stored_energy"] > 0.0)


def missing_work(name, programme, refinements, seeds):
    """Return the residual of the energy balance over the dissipation, (refinements, seeds)."""
    errors = np.empty((len(refinements), seeds))
    for k, m in enumerate(refinements):
        for seed in range(seeds):
            line = a_line(size(20, 8), 1.0, m, seed)
            result = trace(
                line, PROGRAMMES[programme], MATERIALS[name], start="relaxed", requested=ALL
            )
            missing, _, dissipated = balance(result)
            errors[k, seed] = missing[-1] / dissipated[-1]
    return errors


@pytest.mark.parametrize(("name", "order"), [("solid", 1.5), ("damped", 0.8)])
@pytest.mark.parametrize("programme", PROGRAMMES)
def test_the_balance_closes_at_second_order_with_a_glassy_modulus(programme, name, order):
    """With a dashpot and branches, the order is one because forces jump at touch-down."""
    refinements = np.array([4, 8, 16, 32])[: size(4, 2)]
    errors = missing_work(name, programme, refinements, size(3, 1))
    assert observed_order(refinements, errors) > size(order, 0.3)
    assert np.abs(errors[-1]).max() < size(3e-3, 0.2)


def test_a_relaxed_line_at_rest_does_no_work():
    result = trace(a_line(), (Hold(3.0),), SOLID, start="relaxed", requested=ALL)
    for name in ("dissipated_energy", "work", "closing_work"):
        np.testing.assert_allclose(result[name], 0.0, atol=1e-14)
    np.testing.assert_allclose(result["stored_energy"], result["stored_energy"][0], rtol=1e-13)


@pytest.mark.parametrize("name", MATERIALS)
@pytest.mark.parametrize("dt", [1e-6, 0.03, 50.0])
def test_a_step_dissipates_the_integral_of_the_rates(name, dt):
    """Integrate lambda/J (dy/dt)^2 over a step for every unit, under the force of the scheme."""
    form = FORMS_BY_SCHEME["exponential"](MATERIALS[name])
    law = law_of(form, dt)
    rng = np.random.default_rng(1)
    memory, (p, new) = -rng.random((form.times.size, 3)), rng.random((2, 3))
    w = np.empty(3)
    predict(law, memory, p, w)
    settled = memory.copy()
    advance_memory(law, settled, w.copy(), p, new)
    before, after = Elements(memory, p, 0.0), Elements(settled, new, 1.0)
    z = np.zeros((1, 6))
    here = np.zeros(2, np.int64)
    track = Track(z, z, here, here, np.array([dt]), np.zeros(2), np.zeros(2))
    body, _ = element_line(form, ConstantForce(1.0), track, before)
    record = EnergyRecord(np.empty((4, 0)), np.zeros(3))
    add_step_energies(body, law, record, Move(0, 1, 1, True, dt), dt, before, after)
    sums = record.sums
    begun = law.linear * p + (1.0 - law.linear) * new
    expected = 0.0
    nodes, weights = np.polynomial.legendre.leggauss(40)
    for compliance, time, y in zip(form.compliances, form.times, memory, strict=True):
        slope = (new - begun) / dt
        steady = -compliance * (begun - time * slope)  # limit of y under the force at the start
        # The exponential is smooth within each of these parts, for any step.
        edges = np.unique(np.minimum(np.array([0.0, 1.0, 4.0, 16.0, 40.0, np.inf]) * time, dt))
        for a, b in itertools.pairwise(edges):
            t = 0.5 * (a + b) + 0.5 * (b - a) * nodes[:, None]
            rate = -compliance * slope - (y - steady) / time * np.exp(-t / time)
            expected += time / compliance * 0.5 * (b - a) * np.sum(weights[:, None] * rate**2)
    assert sums[0] == pytest.approx(expected, rel=1e-7)
    mean = new + 0.5 * law.linear * (p - new)
    rise = displacement(form, settled, new) - displacement(form, memory, p)
    np.testing.assert_allclose(sums[1:], [mean.sum(), np.sum(mean * (1.0 + rise))], rtol=1e-13)


def test_stored_energy_is_that_of_the_springs():
    form = FORMS_BY_SCHEME["exponential"](SOLID)
    memory, p = np.array([[-0.3, -0.1]]), np.array([0.4, 0.0])
    units = (0.3**2 + 0.1**2) / form.compliances[0]
    assert stored_energy(form, memory, p) == pytest.approx((form.glass * 0.16 + units) / 4.0)
