"""What is said of doubled keys of [surface] and [grid] is so."""

import numpy as np
import pytest

from elastomer_friction.workflow.plan.problems import line_slope, speed_ratio
from tests.support.small import keys, small_plan


def problems(*settings):
    """Return the problems of the small study at one point."""
    one = ("grid.hurst=0.7", "grid.normal_force=0.04", "grid.velocity=0.1", *settings)
    return [task.problem for task in small_plan(*one).variants[0].tasks]


def of(*settings):
    """Return (elements, load, x, rms slope) of the small study at one point."""
    (problem,) = problems(*settings)
    spacing = 0.01 / problem.elements  # not of a line whose length is changed
    slope = line_slope(problem, "modal") / spacing
    return np.array([problem.elements, problem.load, speed_ratio(problem), slope])


def test_a_roughness_doubled_is_a_force_halved():
    doubled = keys(small_plan("grid.roughness=2e-5"))
    assert doubled == keys(small_plan("grid.normal_force=[0.02, 0.2]"))


def test_a_spacing_doubled_halves_elements_and_x():
    change = of("grid.spacing=2e-4") / of()
    assert change == pytest.approx([0.5, 1.0, 0.5, 2.0**-0.3], rel=0.05)


def test_a_length_doubled_doubles_elements_and_halves_the_load():
    change = of("surface.length=0.02") / of()
    assert change[:3] == pytest.approx([2.0, 0.5, 1.0])
    assert 0.5 * change[3] == pytest.approx(2.0**-0.7, rel=0.05)


def test_a_cutoff_doubled_halves_x_and_lowers_the_slope():
    change = of("surface.cutoff=8e-4") / of("surface.cutoff=4e-4")
    assert change == pytest.approx([1.0, 1.0, 0.5, 2.0**-0.3], rel=0.05)


def test_a_rolloff_doubled_lowers_the_slope():
    change = of("surface.rolloff=8e-4") / of("surface.rolloff=4e-4")
    assert change[3] == pytest.approx(2.0**-0.7, rel=0.15)


def test_a_velocity_doubled_doubles_x():
    (slow,), (fast,) = problems(), problems("grid.velocity=0.2")
    assert speed_ratio(fast) == pytest.approx(2.0 * speed_ratio(slow))
