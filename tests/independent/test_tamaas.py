"""Comparison with the contact package tamaas for Kelvin elements, over a whole velocity step.

tamaas solves contact of a generalized Maxwell solid: a spring in parallel with branches. A spring
of modulus 1 with one branch of viscosity G_1 tau_1 = 1 and tau_1 << dt equals the Kelvin element
under implicit Euler, up to tau_1/dt. Influence coefficients of one in Fourier space turn the
half-space into a foundation of independent springs. tamaas presses surfaces upwards, so it gets -z.
(L. Frerot, G. Anciaux, V. Rey, S. Pham-Ba, J.-F. Molinari, J. Open Source Softw. 5, 2121 (2020).)
"""

import numpy as np
import pytest

from elastomer_friction.kernels import (
    SCHEMES,
    ConstantForce,
    lagged_slope,
    march,
    steady_sliding,
    step_average,
)
from tests.lines import random_line
from tests.support.sweeps import mostly_exhaustive

tamaas = pytest.importorskip("tamaas", reason="needs the extra 'verify': pip install '.[verify]'")

tamaas.set_log_level(tamaas.LogLevel.warning)  # print no table of every solution

ELEMENTS = 5000
LOAD, SPEED, RATIO = 0.01, 4.0, 2.0
TO_STEADY, AFTER = 100, 50  # steps
BRANCH = 1e-9  # tau_1/dt
TOLERANCE = 1e-6


class Foundation:
    """Kelvin elements under a line that moves by one sample per step, solved by tamaas."""

    def __init__(self, z):
        self.z, self.moved = z, 0
        self.model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_1d, [1.0], [z.size])
        self.model.nu, self.model.E = 0.0, 2.0  # shear modulus 1, that of the spring
        short = BRANCH / SPEED
        self.solver = tamaas.MaxwellViscoelastic(
            self.model, -z, 1e-14, 1.0 / SPEED, [1.0 / short], [short]
        )
        for name in ("Westergaard::neumann", "westergaard_neumann"):
            self.model.operators[name]["influence"][...] = 1.0

    def advance(self, speed):
        """Move the line by one sample at a speed; return the forces, by sample of the line."""
        self.moved += 1
        self.solver.time_step = 1.0 / speed
        self.solver.surface[:] = -np.roll(self.z, self.moved)
        self.solver.solve(LOAD)
        return np.roll(np.array(self.model.traction), -self.moved)


@mostly_exhaustive("hurst", [0.7], [0.0, 1.0])
def test_a_whole_velocity_step(hurst):
    z, slope = random_line(ELEMENTS, hurst, 1, seed=1)
    load = LOAD * ELEMENTS
    one, two = (SCHEMES["implicit-euler"](1.0 / v) for v in (SPEED, RATIO * SPEED))
    foundation = Foundation(z)
    for _ in range(TO_STEADY):
        forces = foundation.advance(SPEED)
    state, _ = steady_sliding(one, z, load)
    w, d = state
    expected = one.stiffness * np.maximum(0.0, d - (z - w))
    np.testing.assert_allclose(forces, expected, rtol=0.0, atol=TOLERANCE * expected.max())
    mu_1 = float(forces @ slope / forces.sum())
    assert mu_1 == pytest.approx(step_average(slope, z - w, d), rel=TOLERANCE)

    forces = [foundation.advance(RATIO * SPEED) for _ in range(AFTER)]
    actual = [float(f @ slope / f.sum()) for f in forces]
    weight = lagged_slope(slope, two.lag)
    kept_steps = np.arange(1, AFTER + 1)
    mu, _, _, _ = march(two, ConstantForce(load), z, weight, state, kept_steps, np.inf)
    np.testing.assert_allclose(actual, mu, rtol=TOLERANCE)
    assert np.ptp(mu) > 1e3 * TOLERANCE * mu[-1]  # friction changes enough for the test
