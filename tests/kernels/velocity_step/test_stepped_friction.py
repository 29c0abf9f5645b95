"""Friction and jumps of the steps of implicit Euler are those of a long march."""

import numpy as np
import pytest

from elastomer_friction.kernels import Case, Quantities, Spectrum, run_case
from tests.cases import line_of
from tests.reference_march import Elements, RigidElements, constants

TURNS = 12  # of the march at each speed
RATIO = 1.2
STEADY_AND_JUMP = Quantities(relaxation=False)
JUMP_ALONE = Quantities(steady=False, relaxation=False)


def marched(line, load, speed, kind=Elements):
    """Return mu at the end of sliding at v1, of the first step at v2, and at its end."""
    z, m, direction = line.z, line.steps_per_spacing, 1 if speed > 0.0 else -1
    one, two = (constants("implicit-euler", 1.0 / (m * abs(v))) for v in (speed, RATIO * speed))
    elements = kind(z, line.slope, np.zeros(z.size), 0.0, load, one, direction)
    before = [elements.advance() for _ in range(TURNS * z.size)]
    elements.decay, elements.stiffness, elements.lag = two
    after = [elements.advance() for _ in range(TURNS * z.size)]
    return before[-1], after[0], after[-1]


@pytest.mark.parametrize(("load", "speed", "m"), [(0.1, 0.05, 1), (0.1, 3.0, 1), (2.0, 0.5, 2)])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_friction_and_jump_are_those_of_a_long_march(load, speed, m, sign):
    line, kept = line_of(60, steps=m), (np.array([1, TURNS * 60 * m]),)
    case = Case(load, sign * speed, (RATIO,), kept, "implicit-euler", refine=False, stepped=True)
    before, first, end = marched(line, load, sign * speed)
    outcome = run_case(line, case, Quantities())
    actual = outcome.mu_1, outcome.mu_1 + outcome.jump[0], outcome.mu_2[0]
    assert actual == pytest.approx((before, first, end), rel=1e-9)
    assert outcome.curves[0] == pytest.approx([first, end], rel=1e-9)
    for requested in (STEADY_AND_JUMP, JUMP_ALONE):
        assert run_case(line, case, requested).jump == pytest.approx(outcome.jump, rel=1e-9)
    converged = run_case(line, case._replace(stepped=False), Quantities())
    assert abs(converged.mu_1 / before - 1.0) > 1e-5  # the step matters


def test_the_first_step_of_eq_3_as_printed():
    line, load, speed = line_of(60, steps=1), 0.1, 2.0
    case = Case(load, speed, (RATIO,), (), "implicit-euler", refine=False, stepped=True)
    outcome = run_case(line, case, STEADY_AND_JUMP._replace(indentation_rate=False))
    before, first, end = marched(line, load, speed, RigidElements)
    actual = outcome.mu_1, outcome.mu_1 + outcome.jump[0], outcome.mu_2[0]
    assert actual == pytest.approx((before, first, end), rel=1e-6)


def test_friction_of_branches_is_that_of_the_steps():
    """A branch that is far shorter than a step is a spring that has vanished."""
    line, kept = line_of(60, steps=1), (np.array([1, 2000]),)
    short = Spectrum((1.0,), (1e-9,), 1.0)
    case = Case(0.1, 1.0, (RATIO,), kept, "implicit-euler", refine=False, stepped=True)
    plain, branched = (
        run_case(line, case._replace(spectrum=s), Quantities()) for s in (case.spectrum, short)
    )
    assert branched.mu_1 == pytest.approx(plain.mu_1, rel=1e-7)
    assert branched.jump == pytest.approx(plain.jump, rel=1e-6)
    assert branched.curves[0] == pytest.approx(plain.curves[0], rel=1e-7)
