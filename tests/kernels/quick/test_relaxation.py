"""Relaxations that are marched plainly: on many lines as on each, within a cap or beyond it."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, ConstantForce, lagged_slope, march, step_average
from elastomer_friction.kernels.quick.contacts.steady_friction import (
    AtSpeed,
    Grounds,
    steady_friction,
)
from elastomer_friction.kernels.quick.relaxation import Ends, plain_relaxations
from elastomer_friction.kernels.quick.steady.stack import alone
from tests.cases import KEPT, M, line_of

SPEEDS, LOAD = (3.0, 3.6), 0.3


class Given:
    """Two lines, steady sliding at two speeds, and what a relaxation between them is."""

    def __init__(self, scheme):
        self.lines = [line_of(), line_of(shift=5)]
        self.grounds = Grounds.of(self.lines, marched=True)
        at_speeds = [AtSpeed.of(scheme, M, speed) for speed in SPEEDS]
        self.law, load = at_speeds[1].law, LOAD * self.lines[0].z.size
        self.found = [
            steady_friction(self.grounds, at_speed, np.array([load])) for at_speed in at_speeds
        ]
        self.ends = [Ends(own.decay, own.stay, own.d[:, 0].copy()) for own in self.found]
        self.control = ConstantForce(load)

    def relaxations(self, *ends):
        """Return what begins and ends with what is known of all the lines."""
        return plain_relaxations(self.grounds.stack, self.law, *ends, self.control, KEPT)

    def marched(self, j, start, end, cap):
        """Return the curve of line j between two states, and element updates."""
        line = self.lines[j]
        weight = lagged_slope(line.slope, self.law.lag)
        mu, _, passes, inside = march(self.law, self.control, line.z, weight, start, KEPT, cap)
        assert inside
        return mu - step_average(weight, line.z - end.w, end.d), passes * line.z.size


@pytest.fixture(params=SCHEMES)
def given(request):
    """Return it for each scheme."""
    return Given(request.param)


def test_a_relaxation_is_a_march_between_steady_states(given):
    curves, updates = given.relaxations(*given.ends)
    for j in range(2):
        start, end = (own.state(j, 0) for own in given.found)
        expected, work = given.marched(j, start, end, 1.02 * max(start.d, end.d))
        np.testing.assert_allclose(curves[j], expected, rtol=1e-12, atol=1e-15)
        assert updates[j] == work


def test_what_a_line_gives_does_not_depend_on_the_others(given):
    curves, updates = given.relaxations(*given.ends)
    for j in range(2):
        own = [at._replace(stay=at.stay[j : j + 1], d=at.d[j : j + 1]) for at in given.ends]
        stack = alone(given.grounds.stack, j)
        curve, work = plain_relaxations(stack, given.law, *own, given.control, KEPT)
        assert curve[0].tolist() == curves[j].tolist()
        assert work.tolist() == [updates[j]]


def test_an_indentation_beyond_the_cap_is_marched_again(given):
    """From far too small an indentation on, d rises above what the cap is at first."""
    shallow = np.full(2, 1e-3)
    curves, updates = given.relaxations(*[at._replace(d=shallow) for at in given.ends])
    most = 1.001 * given.control.load
    for j in range(2):
        start, end = (own._replace(d=shallow[:, None]).state(j, 0) for own in given.found)
        expected, work = given.marched(j, start, end, most)
        np.testing.assert_allclose(curves[j], expected, rtol=1e-12, atol=1e-15)
        assert updates[j] > work
