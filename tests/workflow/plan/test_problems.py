"""Exact similarity: copies of one dimensionless problem are found, and nothing else is merged."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.small import small_study
from workflow.plan.problems import canonical, distinct_problems, speed_ratio
from workflow.simulate.tasks import Problem
from workflow.study.grid import AXES

NORMAL = st.floats(1e-100, 1e100)


def problems(*settings):
    """Return the distinct problems of the small study."""
    return distinct_problems(small_study(*settings))[0]


def test_force_and_roughness_scaled_together_are_one_problem():
    found, index = distinct_problems(
        small_study("grid.normal_force=[0.1, 0.3]", "grid.roughness=[1e-5, 3e-5, 7e-5]")
    )
    loads = {force / roughness for force, roughness in [(1, 1), (3, 1), (1, 3), (1, 7), (3, 7)]}
    assert len(found) == len(loads) * 4
    assert np.array_equal(index[:, 0, :, 0], index[:, 1, :, 1])
    assert not np.any(index[:, 0, :, 0] == index[:, 1, :, 0])


def test_spacing_and_velocity_scaled_together_differ_in_the_number_of_elements():
    found, index = distinct_problems(
        small_study("grid.spacing=[1e-4, 5e-5]", "grid.velocity=[0.06, 0.03]")
    )
    assert len(found) == index.size
    one, other = found[index[0, 0, 0, 0, 0, 0]], found[index[0, 0, 1, 0, 1, 0]]
    assert one.speed == other.speed
    assert (one.elements, other.elements) == (100, 200)


SCALED = [
    "surface.length=0.02 grid.spacing=2e-4 grid.velocity=[0.06,0.2] grid.normal_force=[0.08,0.8]",
    "surface.length=0.03 grid.spacing=3e-4 grid.velocity=[0.09,0.3] grid.normal_force=[0.12,1.2]",
    "material.shear_modulus=2e7 grid.normal_force=[0.08,0.8]",
    "material.shear_modulus=1.1e7 grid.normal_force=[0.044,0.44]",
    "material.relaxation_time=5e-4 grid.velocity=[0.06,0.2]",
    "material.relaxation_time=1e-2 grid.velocity=[0.003,0.01]",
    "grid.roughness=4e-5 grid.normal_force=[0.16,1.6]",
    "grid.roughness=1.7e-6 grid.normal_force=[0.0068,0.068]",
]


@pytest.mark.parametrize("settings", SCALED)
def test_other_units_give_the_identical_problems(settings):
    assert problems(*settings.split()) == problems()


@given(NORMAL, st.integers(-80, 80))
def test_canonical_commutes_with_powers_of_two(value, power):
    assert canonical(value * 2.0**power) == canonical(value) * 2.0**power


@given(NORMAL, st.floats(-1e-13, 1e-13))
def test_canonical_merges_rounding_about_its_values(value, relative):
    centre = canonical(value)
    assert canonical(centre * (1.0 + relative)) == centre


@given(NORMAL)
def test_canonical_moves_a_value_by_less_than_its_precision(value):
    assert canonical(value) == pytest.approx(value, rel=1e-12)


@given(NORMAL, st.floats(4e-12, 1e-3))
def test_canonical_keeps_different_values_apart(value, relative):
    assert canonical(value * (1.0 + relative)) > canonical(value)


def test_every_point_is_mapped_to_its_own_problem():
    study = small_study("grid.spacing=[1e-4, 2e-4]", "grid.roughness=[1e-5, 2e-5, 5e-5]")
    found, index = distinct_problems(study)
    assert index.shape == study.shape
    for place in itertools.product(*(range(n) for n in study.shape)):
        point = {axis: study.grid[axis][i] for axis, i in zip(AXES, place, strict=True)}
        load = point["normal_force"] / (4 * 1e7 * 0.01 * point["roughness"])
        speed = point["velocity"] * 1e-3 / point["spacing"]
        problem = found[index[place]]
        assert problem.hurst == point["hurst"]
        assert problem.elements == round(0.01 / point["spacing"])
        expected = (load, speed, 1.0 + point["velocity_step"])
        assert problem[2:] == pytest.approx(expected, rel=1e-11)


def test_every_problem_belongs_to_a_point():
    found, index = distinct_problems(small_study("grid.roughness=[1e-5, 2e-5]"))
    assert set(index.ravel()) == set(range(len(found)))


def test_speed_ratio_is_the_abscissa_of_figure_7():
    velocity, tau, spacing = 0.05, 1e-3, 1e-5
    q_max = math.pi / spacing
    assert speed_ratio(Problem(0.7, 100, 0.1, velocity * tau / spacing, 1.2)) == pytest.approx(
        velocity * tau * q_max
    )
