"""Lines of any shape: flat, spikes, steps, teeth, ties. And what is no line."""

import itertools

import numpy as np
import pytest

from kernels import SCHEMES, Case, Line, Quantities, run_case
from studies.stability.probe import Motion, probe
from studies.stability.shapes import line_through, shapes
from tests.hard.bounds import assert_stable
from tests.sizes import size

SHAPES = shapes(size(48, 24))
LOADS = (1e-6, 1e-2, 1.0, 1e4)
SPEEDS = (1e-4, 0.3, 30.0, 3e5)
RECORD = np.array([1, 2, 5, 20, 50])


def run(line, load, speed, ratios=(1e-3, 1.5, 101.0), scheme="exponential"):
    """Return the outcome of a case with all quantities."""
    case = Case(load, speed, ratios, (RECORD,) * len(ratios), scheme)
    return run_case(line, case, Quantities())


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("name", SHAPES)
def test_every_shape_is_stable(name, scheme):
    for load, speed, ratio in itertools.product(LOADS, SPEEDS, (1e-3, 101.0)):
        motion = Motion(SHAPES[name], load, speed, ratio, scheme)
        assert_stable(motion, probe(motion, size(40, 12)))


@pytest.mark.parametrize("name", SHAPES)
def test_every_shape_gives_friction_within_its_slopes(name):
    line = SHAPES[name]
    steepest = np.abs(line.slope).max() * (1.0 + 1e-9)
    for load, speed in itertools.product(LOADS, SPEEDS):
        found = run(line, load, speed)
        assert np.all(np.abs([found.mu_1, *found.mu_2]) <= steepest)
        # Differences of two such means, added to a third.
        assert np.all(np.abs(found.mu_1 + found.jump) <= 3.0 * steepest)
        assert np.all(np.abs(found.curves) <= 3.0 * steepest)
        assert 0.0 < found.contact_fraction <= 1.0 + 1e-12


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize("speed", SPEEDS)
def test_a_flat_line_has_no_friction_and_no_jump(load, speed, scheme):
    found = run(SHAPES["flat"], load, speed, scheme=scheme)
    assert found.mu_1 == 0.0
    assert np.all(found.mu_2 == 0.0)
    assert np.all(found.jump == 0.0)
    assert np.all(np.array(found.curves) == 0.0)
    assert found.contact_fraction == 1.0
    # u = -d for all: d = Fbar; K (1 - E) = 1 to eps K.
    step = SCHEMES[scheme](0.5 / speed)
    assert found.indentation == pytest.approx(load, rel=4e-16 * (4.0 + step.stiffness))


def test_a_symmetric_tooth_has_the_friction_of_its_flanks():
    """v -> 0: mu = vbar mean(z'^2 in contact) n_c / (n Fbar), on straight flanks exact."""
    z = np.abs(np.arange(64) - 32.0)
    line = line_through(z, 1)
    load, speed = 0.5, 1e-6
    found = run(line, load, speed, ratios=(2.0,))
    d = np.sqrt(load * 64.0)  # F = sum of a triangle of depth d: d^2 = 64 Fbar
    # The one sample at the vertex has slope 0 instead of 1: 1 of 2 d = 11.
    assert found.contact_fraction == pytest.approx(2.0 * d / 64.0, rel=0.02)
    assert found.mu_1 == pytest.approx(speed * (2.0 * d - 1.0) / (64.0 * load), rel=0.02)


@pytest.mark.parametrize("name", ["ties at the bottom", "quantised", "step", "comb"])
def test_ties_give_the_result_of_heights_a_little_apart(name):
    """The balance is continuous in the heights: no choice among equals can matter."""
    line = SHAPES[name]
    noise = 1e-10 * np.random.default_rng(1).uniform(-1.0, 1.0, line.z.size)
    apart = Line.from_samples(line.z + noise, line.slope, line.steps_per_spacing)
    for load, speed in itertools.product(LOADS[1:], SPEEDS):
        one, other = run(line, load, speed), run(apart, load, speed)
        depth = one.indentation - line.datum  # the other counts from near the bottom
        assert other.indentation == pytest.approx(depth, abs=1e-9 * (line.z.max() + load))


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("where", ["z", "slope"])
def test_numbers_that_are_none_are_refused(bad, where):
    values = {"z": np.zeros(8), "slope": np.zeros(8)}
    values[where][3] = bad
    with pytest.raises(ValueError, match="not finite"):
        Line.from_samples(values["z"], values["slope"], 1)


@pytest.mark.parametrize("n", [1, 2, 3])
def test_lines_of_few_samples_are_stable(n):
    line = Line.from_samples(np.arange(float(n)), np.zeros(n), 1)
    for load, speed in itertools.product(LOADS, SPEEDS):
        motion = Motion(line, load, speed, 1.5, "exponential")
        assert_stable(motion, probe(motion, 12))
