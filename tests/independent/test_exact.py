"""The kernels against exact arithmetic on tiny lines: steady state, jump, a whole velocity step."""

import math
import random
from decimal import Decimal, localcontext
from fractions import Fraction

import numpy as np
import pytest

from kernels import (
    SCHEMES,
    Case,
    ConstantForce,
    Line,
    Quantities,
    lagged_slope,
    march,
    run_case,
    steady_sliding,
)
from tests.independent.exact import (
    Exponential,
    ImplicitEuler,
    elastic_correction,
    friction_at_once,
    relaxation,
    steady,
    step_friction,
)

DIGITS = 60
STEPS = 10
TOLERANCE = 1e-12
NUMBERS = {"implicit-euler": (Fraction, ImplicitEuler), "exponential": (Decimal, Exponential)}
LOADS = {"one asperity": 2**-20, "light": 2**-4, "middle": 0.75, "full contact": 64.0}
SPEEDS = {"slow": 2**-6, "middle": 0.5, "fast": 16.0}
M = 2


@pytest.fixture(autouse=True)
def digits():
    """Compute decimals with many digits."""
    with localcontext() as context:
        context.prec = DIGITS
        yield


def tiny_line(seed, samples=6, ties=False):
    """Return a line whose heights and slopes are floats that fractions hold exactly."""
    rng = random.Random(seed)
    span = 3 if ties else 64
    z = np.array([rng.randint(-span, span) / 32 for _ in range(samples)])
    slope = np.array([rng.randint(-64, 64) / 32 for _ in range(samples)])
    return Line.from_samples(z, slope, M)


class Both:
    """One velocity step on a tiny line: the floats of the kernels and the exact numbers."""

    def __init__(self, line, scheme, load, speed, ratio):
        self.line, self.scheme, self.ratio = line, scheme, ratio
        self.number, law = NUMBERS[scheme]
        self.load, self.speed = load, speed
        self.z = [self.number(h) for h in line.z.tolist()]
        self.slope = [self.number(s) for s in line.slope.tolist()]
        self.target = self.number(load) * len(self.z)
        self.before = law(1 / (M * self.number(speed)))
        self.after = law(1 / (M * self.number(ratio) * self.number(speed)))

    def exact(self):
        """Return mu_1, mu_2, jump, the curve of mu as run_case defines it, d before and after."""
        one = steady(self.before, self.z, self.target)
        two = steady(self.after, self.z, self.target)
        v1 = self.number(self.speed)
        v2 = v1 * self.number(self.ratio)
        mu_1, summed = self.steady_friction(one, v1)
        mu_0, _ = friction_at_once(self.z, self.slope, one, v1, v2, self.target)
        mu_2, _ = self.steady_friction(two, v2)
        final = step_friction(self.after, two.f, self.slope, 0)
        rows = relaxation(self.after, self.z, self.slope, one, self.target, STEPS)
        curve = [mu_2 + mu - final for mu, _ in rows]
        return mu_1, mu_2, mu_0 - summed, curve, one.d, [d for _, d in rows]

    def steady_friction(self, state, speed):
        """Return mu with its elastic part corrected as in run_case, and without."""
        mu, rate = friction_at_once(self.z, self.slope, state, speed, speed, self.target)
        missing = elastic_correction(self.z, self.slope, state, speed, rate, M)
        share = math.exp(-((M * float(speed)) ** 2))
        if share < 1e-3:
            return mu, mu
        touching = [abs(s) for s, f in zip(self.slope, state.f, strict=True) if f > 0]
        corrected = mu + self.number(share) * missing / self.target
        return min(max(corrected, -max(touching)), max(touching)), mu

    def kernels(self):
        """Return the same from the kernels."""
        kept_steps = np.arange(1, STEPS + 1)
        case = Case(self.load, self.speed, (self.ratio,), (kept_steps,), self.scheme)
        found = run_case(self.line, case, Quantities())
        n = self.line.z.size
        state, _ = steady_sliding(self.law(1.0), self.line.z, self.load * n)
        law = self.law(self.ratio)
        weight = lagged_slope(self.line.slope, law.lag)
        control = ConstantForce(self.load * n)
        _, depth, _, _ = march(law, control, self.line.z, weight, state, kept_steps, np.inf)
        return found.mu_1, found.mu_2[0], found.jump[0], found.curves[0], state.d, depth

    def law(self, ratio):
        """Return the law of the elastomer of the kernels."""
        return SCHEMES[self.scheme](1.0 / (M * self.speed * ratio))


def assert_equal(both):
    """Compare all results: friction relative to the steepest slope, depths to the height."""
    steepest = float(np.abs(both.line.slope).max())
    height = float(np.ptp(both.line.z)) + both.load
    names = ("mu_1", "mu_2", "jump", "mu after the jump", "d", "d after the jump")
    units = (steepest,) * 4 + (height,) * 2
    for name, unit, exact, found in zip(names, units, both.exact(), both.kernels(), strict=True):
        difference = np.abs(np.array(exact, dtype=float) - np.array(found))
        assert difference.max() <= TOLERANCE * unit, name


@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize("scheme", NUMBERS)
def test_a_velocity_step_is_exact(scheme, load, speed):
    for seed, ratio in ((1, 1.25), (2, 0.5), (3, 8.0)):
        both = Both(tiny_line(seed), scheme, LOADS[load], SPEEDS[speed], ratio)
        assert_equal(both)


@pytest.mark.parametrize("scheme", NUMBERS)
@pytest.mark.parametrize("seed", range(4))
def test_lines_with_ties_are_exact(scheme, seed):
    assert_equal(Both(tiny_line(seed, ties=True), scheme, 0.05, 0.5, 1.5))
