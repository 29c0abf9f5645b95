"""Relaxations by the plain march: on many lines as on single lines, below and above the cap."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, ConstantForce, lagged_slope, march, step_average
from elastomer_friction.kernels.quick.contacts.steady_friction import (
    LineSet,
    SpeedConstants,
    steady_friction,
)
from elastomer_friction.kernels.quick.relaxation import SteadyEnds, plain_relaxations
from tests.cases import KEPT, M, line_of

SPEEDS, LOAD = (3.0, 3.6), 0.3


class Given:
    """Two lines, steady sliding at two speeds, and relaxations between these states."""

    def __init__(self, scheme):
        self.lines = [line_of(), line_of(shift=5)]
        self.line_set = LineSet.of(self.lines, marched=True)
        constants = [SpeedConstants.of(scheme, M, speed) for speed in SPEEDS]
        self.law, load = constants[1].law, LOAD * self.lines[0].z.size
        self.sliding = [
            steady_friction(self.line_set, at_speed, np.array([load])) for at_speed in constants
        ]
        self.ends = [
            SteadyEnds(sliding.decay, sliding.thresholds, sliding.d[:, 0].copy())
            for sliding in self.sliding
        ]
        self.control = ConstantForce(load)

    def relaxations(self, *ends):
        """Return (curves, updates) between two SteadyEnds on all the lines."""
        return plain_relaxations(self.line_set.stack, self.law, *ends, self.control, KEPT)

    def marched(self, j, start, end, cap):
        """Return the curve of line j between two states, and element updates."""
        line = self.lines[j]
        weight = lagged_slope(line.slope, self.law.lag)
        mu, _, passes, inside = march(self.law, self.control, line.z, weight, start, KEPT, cap)
        assert inside
        return mu - step_average(weight, line.z - end.w, end.d), passes * line.z.size


@pytest.fixture(params=SCHEMES)
def given(request):
    """Return the lines in each scheme."""
    return Given(request.param)


def test_a_relaxation_is_a_march_between_steady_states(given):
    curves, updates = given.relaxations(*given.ends)
    for j in range(2):
        start, end = (sliding.state(j, 0) for sliding in given.sliding)
        expected, work = given.marched(j, start, end, 1.02 * max(start.d, end.d))
        np.testing.assert_allclose(curves[j], expected, rtol=1e-12, atol=1e-15)
        assert updates[j] == work


def test_an_indentation_beyond_the_cap_is_marched_again(given):
    """If the march starts from a far too small indentation, d rises above the first cap."""
    shallow = np.full(2, 1e-3)
    curves, updates = given.relaxations(*[end._replace(d=shallow) for end in given.ends])
    most = 1.001 * given.control.load
    for j in range(2):
        start, end = (sliding._replace(d=shallow[:, None]).state(j, 0) for sliding in given.sliding)
        expected, work = given.marched(j, start, end, most)
        np.testing.assert_allclose(curves[j], expected, rtol=1e-12, atol=1e-15)
        assert updates[j] > work
