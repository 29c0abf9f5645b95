"""Work balance of the march, all elements counted: F_x v + F_N d' = dE/dt + dissipation."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, ConstantForce, lagged_slope, march, steady_sliding
from tests.convergence import observed_order
from tests.lines import random_line
from tests.reference_march import Elements, constants, steady
from tests.sizes import size

ELEMENTS, LOAD, SPEED, RATIO, DURATION = 40, 0.05, 1.0, 1.3, 5  # duration in spacings
SEEDS = range(4)
REFINEMENTS = np.array([4, 8, 16, 32])[: size(4, 3)]


def displacements(z, slope, m, scheme):
    """Yield the displacements of all elements (reference) before and after each step."""
    u, _, d = steady(z, LOAD, constants(scheme, 1.0 / (m * SPEED))[0])
    step = constants(scheme, 1.0 / (m * SPEED * RATIO))
    elements = Elements(z, slope, u, d, LOAD, step)
    yield u
    for _ in range(DURATION * m):
        elements.advance()
        yield elements.u


def work(z, slope, m, scheme):
    """Return the work done on the line per element, from mu and d of the kernels."""
    before, after = (SCHEMES[scheme](1.0 / (m * SPEED * r)) for r in (1.0, RATIO))
    load = LOAD * z.size
    state, _ = steady_sliding(before, z, load)
    weight = lagged_slope(slope, after.lag)
    kept_steps = np.arange(1, DURATION * m + 1)
    mu, depth, _, _ = march(after, ConstantForce(load), z, weight, state, kept_steps, np.inf)
    return LOAD * (mu.sum() / m + depth[-1] - state.d)  # v dt = dx / m


def imbalance(m, seed, scheme):
    """Return (work - elastic - dissipated) / dissipated over the time after the jump."""
    z, slope = random_line(ELEMENTS, 1.0, m, seed)
    u = np.array(list(displacements(z, slope, m, scheme)))
    elastic = 0.5 * (np.mean(u[-1] ** 2) - np.mean(u[0] ** 2))
    dissipated = np.sum(np.mean(np.diff(u, axis=0) ** 2, axis=1)) * m * SPEED * RATIO
    return (work(z, slope, m, scheme) - elastic - dissipated) / dissipated


@pytest.mark.parametrize("scheme", SCHEMES)
def test_work_is_stored_or_dissipated(scheme):
    """First order: u' is discontinuous where an element meets the line within a step."""
    errors = np.array([[imbalance(m, seed, scheme) for seed in SEEDS] for m in REFINEMENTS])
    assert observed_order(REFINEMENTS, errors) > 0.8  # nominal 1; random edges scatter
    # Error constant about 0.16 / m (measured); a missing term would leave all of its share.
    assert np.sqrt(np.mean(errors[-1] ** 2)) < 0.3 / REFINEMENTS[-1]
