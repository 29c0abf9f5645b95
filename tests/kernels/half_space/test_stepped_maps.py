"""Friction and jumps of the steps of implicit Euler on a map are those of a long march."""

import numpy as np
import pytest

from elastomer_friction.kernels import KELVIN, Case, Quantities
from elastomer_friction.kernels.half_space.body import HalfSpace, Step, rest_on, take_step
from elastomer_friction.kernels.half_space.cases import run_case
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes
from elastomer_friction.kernels.model.friction import mean_slope
from elastomer_friction.kernels.rheology.forms import form_of

RATIO, TURNS = 1.2, 8  # of the march at each speed


def marched(space, speed):
    """Return mu at the end of sliding at v1, of the first step at v2, and at its end."""
    (body, _), mu = rest_on(space), []
    for v in (speed, RATIO * speed):
        step = Step.of(space.form, space.surface, v)
        for _ in range(TURNS * space.surface.z.shape[1]):
            body, _ = take_step(space, body, step, 1e-8)
            mu.append(mean_slope(body.p, step.weight))
    return mu[len(mu) // 2 - 1], mu[len(mu) // 2], mu[-1]


@pytest.mark.parametrize(("load", "speed", "m"), [(0.5, 0.3, 1), (0.5, -2.0, 2), (3.0, 1.0, 1)])
def test_friction_jump_and_curve_are_those_of_a_long_march(load, speed, m):
    amplitudes = ring_amplitudes(0.7, 16)
    surface = Surface.drawn(np.random.default_rng(3), amplitudes, 16, m)
    kept = (np.array([1, TURNS * 16 * m]),)
    case = Case(load, speed, (RATIO,), kept, "implicit-euler", refine=False, stepped=True)
    outcome = run_case(surface, case, Quantities())
    space = HalfSpace.under(form_of(KELVIN, "implicit-euler"), surface, load)
    before, first, end = marched(space, speed)
    actual = outcome.mu_1, outcome.mu_1 + outcome.jump[0], outcome.mu_2[0]
    assert actual == pytest.approx((before, first, end), rel=1e-3)
    assert outcome.curves[0] == pytest.approx([first, end], rel=1e-3)
    converged = run_case(surface, case._replace(stepped=False), Quantities())
    assert abs(converged.jump[0] / outcome.jump[0] - 1.0) > 0.02  # the step matters
