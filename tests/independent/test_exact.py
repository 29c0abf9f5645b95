"""The kernels against exact arithmetic on tiny lines: steady states, jump and relaxation."""

import math
import random
from decimal import Decimal, localcontext
from fractions import Fraction
from typing import NamedTuple

import numpy as np
import pytest

from elastomer_friction.kernels import (
    Case,
    ConstantForce,
    Line,
    Quantities,
    lagged_slope,
    march,
    run_case,
)
from elastomer_friction.studies.stability.probe import Motion
from tests.independent.exact import (
    Exponential,
    ImplicitEuler,
    elastic_correction,
    friction_at_once,
    relaxation,
    steady,
    step_friction,
)
from tests.support.sweeps import sweep

DIGITS = 60
STEPS = 10
TOLERANCE = 1e-12
NUMBERS = {"implicit-euler": (Fraction, ImplicitEuler), "exponential": (Decimal, Exponential)}
LOADS = {"one asperity": 2**-20, "light": 2**-4, "middle": 0.75, "full contact": 64.0}
SPEEDS = {"slow": 2**-6, "middle": 0.5, "fast": 16.0}
M = 2


@pytest.fixture(autouse=True)
def digits():
    """Set the precision of decimals to DIGITS."""
    with localcontext() as context:
        context.prec = DIGITS
        yield


def tiny_line(seed, samples=6, ties=False):
    """Return a line with heights and slopes in multiples of 1/32, exact in all number types."""
    rng = random.Random(seed)
    span = 3 if ties else 64
    z = np.array([rng.randint(-span, span) / 32 for _ in range(samples)])
    slope = np.array([rng.randint(-64, 64) / 32 for _ in range(samples)])
    return Line.from_samples(z, slope, M)


class Both(NamedTuple):
    """One velocity step on a tiny line, by the kernels and in exact arithmetic."""

    line: Line
    scheme: str
    load: float
    speed: float
    ratio: float

    def exact(self):
        """Return mu_1, mu_2, jump, the curve of mu as run_case defines it, d before and after."""
        number, law = NUMBERS[self.scheme]
        z, slope = ([number(x) for x in values.tolist()] for values in self.line[:2])
        load, v1 = number(self.load) * len(z), number(self.speed)
        v2 = number(self.ratio) * v1
        before, after = law(1 / (M * v1)), law(1 / (M * v2))

        def steady_friction(state, speed):
            """Return mu with the elastic correction of run_case, and mu without it."""
            mu, rate = friction_at_once(z, slope, state, speed, speed, load)
            share = math.exp(-((M * float(speed)) ** 2))
            if share < 1e-3:
                return mu, mu
            missing = elastic_correction(z, slope, state, speed, rate, M)
            steepest = max(abs(s) for s, f in zip(slope, state.f, strict=True) if f > 0)
            corrected = mu + number(share) * missing / load
            return min(max(corrected, -steepest), steepest), mu

        one, two = steady(before, z, load), steady(after, z, load)
        mu_1, summed = steady_friction(one, v1)
        mu_2, _ = steady_friction(two, v2)
        mu_0, _ = friction_at_once(z, slope, one, v1, v2, load)
        final = step_friction(after, two.f, slope, 0)
        rows = relaxation(after, z, slope, one, load, STEPS)
        curve = [mu_2 + mu - final for mu, _ in rows]
        return mu_1, mu_2, mu_0 - summed, curve, one.d, [d for _, d in rows]

    def kernels(self):
        """Return the same values from the kernels."""
        kept_steps = np.arange(1, STEPS + 1)
        case = Case(self.load, self.speed, (self.ratio,), (kept_steps,), self.scheme)
        actual = run_case(self.line, case, Quantities())
        motion = Motion(self.line, self.load, self.speed, self.ratio, self.scheme)
        state, _ = motion.steady(motion.step(1.0)[1])
        law = motion.step(self.ratio)[1]
        weight, control = lagged_slope(self.line.slope, law.lag), ConstantForce(motion.total)
        _, depth, _, _ = march(law, control, self.line.z, weight, state, kept_steps, np.inf)
        return actual.mu_1, actual.mu_2[0], actual.jump[0], actual.curves[0], state.d, depth


def assert_equal(both):
    """Compare all results; friction is relative to the largest slope, depths to the height."""
    steepest = float(np.abs(both.line.slope).max())
    height = float(np.ptp(both.line.z)) + both.load
    names = ("mu_1", "mu_2", "jump", "mu after the jump", "d", "d after the jump")
    units = (steepest,) * 4 + (height,) * 2
    for name, unit, exact, actual in zip(names, units, both.exact(), both.kernels(), strict=True):
        difference = np.abs(np.array(exact, dtype=float) - np.array(actual))
        assert difference.max() <= TOLERANCE * unit, name


@sweep("lines", {1: 1.25}, {2: 0.5, 3: 8.0})
@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize("scheme", NUMBERS)
def test_a_velocity_step_is_exact(scheme, load, speed, lines):
    for seed, ratio in lines.items():
        assert_equal(Both(tiny_line(seed), scheme, LOADS[load], SPEEDS[speed], ratio))


@pytest.mark.parametrize("scheme", NUMBERS)
@pytest.mark.parametrize(("seed", "ratio"), [(0, 1.5), (1, 0.5), (2, 8.0), (3, 1.5)])
def test_lines_with_ties_are_exact(scheme, seed, ratio):
    assert_equal(Both(tiny_line(seed, ties=True), scheme, 0.05, 0.5, ratio))
