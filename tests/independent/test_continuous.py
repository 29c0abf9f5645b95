"""Convergence of the kernels to motion that is continuous in time, at their stated orders."""

from typing import NamedTuple

import numpy as np
import pytest

from elastomer_friction.kernels import (
    SCHEMES,
    ConstantForce,
    State,
    lagged_slope,
    march,
    quadrature,
    steady_sliding,
)
from tests.convergence import observed_order
from tests.independent.continuous import Modes, Sliding
from tests.support.sweeps import sweep

LENGTH = 8
LINE = Modes(np.array([0.8, 0.5, 0.4]), np.array([0.3, 1.9, 4.0]), float(LENGTH))
REFINEMENTS = (8, 16, 32)  # samples per spacing
ORDERS = {"exponential": 1.8, "implicit-euler": 0.85}
STEPS = {"faster": (0.3, 1.0, 1.5), "slower": (0.3, 1.0, 0.5), "light": (0.05, 0.5, 2.0)}


class Start(NamedTuple):
    """Steady sliding on the line with m samples per spacing, by the kernels."""

    x: np.ndarray
    z: np.ndarray
    slope: np.ndarray
    w: np.ndarray
    d: float
    load: float  # on the whole line
    speed: float

    @classmethod
    def at(cls, m, scheme, load, speed):
        """Return steady sliding on the line, whose first sample is the highest."""
        x = np.arange(LENGTH * m) / m
        x = np.roll(x, -int(np.argmax(LINE(x)[0])))
        z, slope = LINE(x)
        (w, d), _ = steady_sliding(SCHEMES[scheme](1.0 / (m * speed)), z, load * z.size)
        return cls(x, z, slope, w, d, load * z.size, speed)

    def sliding(self, speed):
        """Return the same elements for continuous sliding."""
        return Sliding(LINE, self.x, np.minimum(self.w, self.z - self.d), self.d, self.load, speed)

    def friction(self, speed):
        """Return mu just after a change of the speed."""
        return quadrature(self.z, self.slope, self.w, self.d, self.speed, speed, self.load)[0]


def after_the_jump(m, scheme, load, speed, ratio):
    """Return mu averaged over each step for one tau after the jump: (kernels, continuous)."""
    start, after = Start.at(m, scheme, load, speed), ratio * speed
    law = SCHEMES[scheme](1.0 / (m * after))
    kept_steps = np.arange(1, round(m * after) + 1)
    weight = lagged_slope(start.slope, law.lag)
    control, state = ConstantForce(start.load), State(start.w, start.d)
    mu, _, _, _ = march(law, control, start.z, weight, state, kept_steps, np.inf)
    sliding = start.sliding(after)
    return mu, np.array([sliding.advance(k / (m * after)) for k in kept_steps])


@sweep("refinements", REFINEMENTS, (*REFINEMENTS, 64))
@pytest.mark.parametrize("name", STEPS)
@pytest.mark.parametrize("scheme", ORDERS)
def test_relaxation_runs_into_the_continuous_one(scheme, name, refinements):
    rms = []
    for m in refinements:
        mu, continuous = after_the_jump(m, scheme, *STEPS[name])
        rms.append([np.sqrt(np.mean((mu - continuous) ** 2))])
    assert observed_order(refinements, rms) > ORDERS[scheme]
    if scheme == "exponential":
        assert rms[-1][0] < 10.0 / m**2 * np.ptp(continuous)


@pytest.mark.parametrize("load", [0.05, 0.3])
def test_steady_sliding_is_the_mean_of_the_continuous_motion(load):
    errors = []
    for m in REFINEMENTS:
        start = Start.at(m, "exponential", load, 1.0)
        mu, sliding = start.friction(1.0), start.sliding(1.0)
        sliding.advance(3.0)
        errors.append([mu - sliding.advance(3.0 + 1.0 / m)])  # over a sample, the period
    assert abs(errors[-1][0]) < 1e-3 * mu
    assert observed_order(REFINEMENTS, errors) > 1.5


@pytest.mark.parametrize("ratio", [0.5, 2.0])
def test_the_jump_is_that_of_the_elements_at_rest(ratio):
    start = Start.at(256, "exponential", 0.3, 1.0)
    _, friction = start.sliding(ratio).derivatives(0.0, [start.d, 0.0])
    assert friction / start.load == pytest.approx(start.friction(ratio), rel=5e-3)
