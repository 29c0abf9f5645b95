"""The kernels refined in time run into the motion that is continuous in time, at their order."""

from typing import NamedTuple

import numpy as np
import pytest

from kernels import SCHEMES, ConstantForce, State, lagged_slope, march, quadrature, steady_sliding
from tests.convergence import observed_order
from tests.independent.continuous import Modes, Sliding

LENGTH = 8
LINE = Modes(np.array([0.8, 0.5, 0.4]), np.array([0.3, 1.9, 4.0]), float(LENGTH))
REFINEMENTS = (8, 16, 32, 64)  # samples per spacing
ORDERS = {"exponential": 1.8, "implicit-euler": 0.9}
STEPS = {"faster": (0.3, 1.0, 1.5), "slower": (0.3, 1.0, 0.5), "light": (0.05, 0.5, 2.0)}


class Start(NamedTuple):
    """Steady sliding on the line with m samples per spacing, as the kernels find it."""

    x: np.ndarray
    z: np.ndarray
    slope: np.ndarray
    w: np.ndarray
    d: float

    @classmethod
    def at(cls, m, scheme, load, speed):
        """Return it, the highest point first."""
        x = np.arange(LENGTH * m) / m
        top = int(np.argmax(LINE(x)[0]))
        x = np.roll(x, -top)
        z, slope = LINE(x)
        (w, d), _ = steady_sliding(SCHEMES[scheme](1.0 / (m * speed)), z, load * z.size)
        return cls(x, z, slope, w, d)

    def sliding(self, load, speed):
        """Return the same elements, to slide continuously."""
        u = np.minimum(self.w, self.z - self.d)
        return Sliding(LINE, self.x, u, self.d, load * self.z.size, speed)


def after_the_jump(m, scheme, load, speed, ratio):
    """Return mu averaged over each step of one tau after the jump: of the kernels, continuous."""
    start = Start.at(m, scheme, load, speed)
    after = ratio * speed
    law = SCHEMES[scheme](1.0 / (m * after))
    kept_steps = np.arange(1, round(m * after) + 1)
    weight = lagged_slope(start.slope, law.lag)
    control, state = ConstantForce(load * start.z.size), State(start.w, start.d)
    mu, _, _, _ = march(law, control, start.z, weight, state, kept_steps, np.inf)
    sliding = start.sliding(load, after)
    return mu, np.array([sliding.advance(k / (m * after)) for k in kept_steps])


@pytest.mark.parametrize("name", STEPS)
@pytest.mark.parametrize("scheme", ORDERS)
def test_relaxation_runs_into_the_continuous_one(scheme, name):
    errors = []
    for m in REFINEMENTS:
        mu, continuous = after_the_jump(m, scheme, *STEPS[name])
        errors.append(mu - continuous)
    rms = [[np.sqrt(np.mean(e**2))] for e in errors]
    assert observed_order(REFINEMENTS, rms) > ORDERS[scheme]
    if scheme == "exponential":
        assert rms[-1][0] < 2e-3 * np.ptp(continuous)


@pytest.mark.parametrize("load", [0.05, 0.3])
def test_steady_sliding_is_the_mean_of_the_continuous_motion(load):
    speed, errors = 1.0, []
    for m in REFINEMENTS[:3]:
        start = Start.at(m, "exponential", load, speed)
        mu, _, _ = quadrature(
            start.z, start.slope, start.w, start.d, speed, speed, load * start.z.size
        )
        sliding = start.sliding(load, speed)
        sliding.advance(4.0)
        errors.append([mu - sliding.advance(5.0)])  # over a way of one spacing
    assert abs(errors[-1][0]) < 1e-3 * mu
    assert observed_order(REFINEMENTS[:3], errors) > 1.5


@pytest.mark.parametrize("ratio", [0.5, 2.0])
def test_the_jump_is_that_of_the_elements_at_rest(ratio):
    load, speed, m = 0.3, 1.0, 256
    start = Start.at(m, "exponential", load, speed)
    after, _, _ = quadrature(
        start.z, start.slope, start.w, start.d, speed, ratio * speed, load * start.z.size
    )
    sliding = start.sliding(load, ratio * speed)
    _, friction = sliding.derivatives(0.0, [start.d, 0.0])
    assert friction / (load * start.z.size) == pytest.approx(after, rel=5e-3)
