"""Friction of artificial lines: flat, teeth, ties. See also test_corners.py."""

import itertools

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, Case, Line, Quantities, run_case
from elastomer_friction.studies.stability.probe import line_through, shapes
from tests.sizes import size

SHAPES = shapes(size(48, 24))
LOADS = (1e-6, 1e-2, 1.0, 1e4)
SPEEDS = (1e-4, 0.3, 30.0, 3e5)


def run(line, load, speed, scheme="exponential"):
    """Return the outcome of a case with all quantities."""
    ratios = (1e-3, 1.5, 101.0)
    case = Case(load, speed, ratios, (np.array([1, 2, 5, 20, 50]),) * 3, scheme)
    return run_case(line, case, Quantities())


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize("speed", SPEEDS)
def test_a_flat_line_has_no_friction_and_no_jump(load, speed, scheme):
    actual = run(SHAPES["flat"], load, speed, scheme)
    assert not np.any([actual.mu_1, *actual.mu_2, *actual.jump, *np.ravel(actual.curves)])
    assert actual.contact_fraction == 1.0
    # All u = -d, so d = Fbar; K (1 - E) = 1 holds to eps K.
    step = SCHEMES[scheme](0.5 / speed)
    assert actual.indentation == pytest.approx(load, rel=4e-16 * (4.0 + step.stiffness))


def test_a_symmetric_tooth_has_the_friction_of_its_flanks():
    """For v -> 0, mu = vbar mean(z'^2 in contact) n_c / (n Fbar), exact on straight flanks."""
    load, speed = 0.5, 1e-6
    actual = run(line_through(np.abs(np.arange(64) - 32.0), 1), load, speed)
    d = np.sqrt(load * 64.0)  # F = sum of a triangle of depth d: d^2 = 64 Fbar
    # One of the 2 d = 11 samples, that at the vertex, has slope 0 instead of 1.
    assert actual.contact_fraction == pytest.approx(2.0 * d / 64.0, rel=0.02)
    assert actual.mu_1 == pytest.approx(speed * (2.0 * d - 1.0) / (64.0 * load), rel=0.02)


@pytest.mark.parametrize("name", ["ties at the bottom", "quantised", "step", "comb"])
def test_ties_give_the_result_of_heights_a_little_apart(name):
    """The balance is continuous in the heights, so the order of equal heights does not matter."""
    line = SHAPES[name]
    noise = 1e-10 * np.random.default_rng(1).uniform(-1.0, 1.0, line.z.size)
    apart = Line.from_samples(line.z + noise, line.slope, line.steps_per_spacing)
    for load, speed in itertools.product(LOADS[1:], SPEEDS):
        one, other = run(line, load, speed), run(apart, load, speed)
        depth = one.indentation - line.datum  # the other line has its datum near the bottom
        assert other.indentation == pytest.approx(depth, abs=1e-9 * (line.z.max() + load))
