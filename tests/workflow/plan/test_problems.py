"""Exact similarity: copies of one dimensionless problem are found, and nothing else is merged."""

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.kernels import Hold, Slide
from elastomer_friction.workflow.plan.motion import canonical, rounded
from elastomer_friction.workflow.plan.problems import (
    distinct_problems,
    nominal_pressure,
    speed_ratio,
    stack_problems,
    viscous_pressure,
)
from elastomer_friction.workflow.study.axes import COMMON_AXES, axes_of
from tests.support.documents import without
from tests.support.small import HOLDING, PROGRAMME, TEXT, complaint, keys, small_plan, small_study

ONE_POINT = "grid.hurst=0.5", "grid.normal_force=0.04", "grid.velocity=0.03"
NORMAL = st.floats(1e-100, 1e100)


def problems(*settings):
    """Return the distinct problems of the small study."""
    return distinct_problems(small_study(*settings))[0]


@given(NORMAL, st.integers(-80, 80))
def test_canonical_commutes_with_powers_of_two(value, power):
    assert canonical(value * 2.0**power) == canonical(value) * 2.0**power


@given(NORMAL, st.floats(-1e-13, 1e-13))
def test_canonical_merges_rounding_about_its_values_which_are_near(value, relative):
    centre = canonical(value)
    assert centre == pytest.approx(value, rel=1e-12)
    assert canonical(centre * (1.0 + relative)) == centre


@given(NORMAL, st.floats(4e-12, 1e-3))
def test_canonical_keeps_different_values_apart(value, relative):
    assert canonical(value * (1.0 + relative)) > canonical(value)


def test_every_point_is_mapped_to_its_own_problem_and_copies_to_one():
    loads = "grid.normal_force=[0.1, 0.3]", "grid.roughness=[1e-5, 3e-5, 7e-5]"
    study = small_study(*loads, "grid.spacing=[1e-4, 2e-4]", "grid.velocity=[0.03, 0.06]")
    found, index = distinct_problems(study)
    assert index.shape == study.shape
    assert set(index.ravel()) == set(range(len(found)))
    assert len(found) == index.size * 5 // 6  # of six loads two are one
    for place in itertools.product(*(range(n) for n in study.shape)):
        point = {axis: study.grid[axis][i] for axis, i in zip(COMMON_AXES, place, strict=True)}
        load = point["normal_force"] / (4 * 1e7 * 0.01 * point["roughness"])
        speed = point["velocity"] * 1e-3 / point["spacing"]
        problem = found[index[place]]
        assert problem.hurst == point["hurst"]
        assert problem.elements == round(0.01 / point["spacing"])
        expected = (load, speed, 1.0 + point["velocity_step"])
        assert problem[2:5] == pytest.approx(expected, rel=1e-11)


@given(st.floats(1e-9, 0.9), st.sampled_from([-1.0, 1.0]))
def test_a_velocity_step_is_carried_as_it_is_given(size, sign):
    """Only the rounding of 1 + dv/v1 remains: 1e-7 of a step of 1e-9."""
    (found,) = problems(*ONE_POINT, f"grid.velocity_step={sign * size!r}")
    assert found.ratio - 1.0 == pytest.approx(sign * size, rel=2e-16 / size)


@given(st.floats(1e-300, 0.999e-9), st.sampled_from([-1.0, 1.0]))
def test_a_velocity_step_that_rounding_would_change_is_refused(size, sign):
    assert "lost in rounding" in complaint(*ONE_POINT, f"grid.velocity_step={sign * size!r}")


@pytest.mark.parametrize("axis", ["hurst", "velocity_step"])
def test_minus_zero_is_zero(axis):
    minus, plus = (small_plan(*ONE_POINT, f"grid.{axis}={zero}") for zero in ("-0.0", "0.0"))
    assert keys(minus) == keys(plus)


@pytest.mark.parametrize("surface", ["surface.normalisation=modal", "surface.cutoff=1e-3"])
def test_stacked_problems_keep_their_numbers_slopes_and_speeds(surface):
    grid = "grid.spacing=[1e-4, 2e-4]", "grid.velocity_step=[0.2, -0.2]"
    each = problems(*grid, surface)
    ((rows, many),) = stack_problems(each)
    assert rows.tolist() == list(range(len(each)))
    assert list(zip(*(column.tolist() for column in many[:5]), strict=True)) == [
        problem[:5] for problem in each
    ]
    for law in (speed_ratio, viscous_pressure):
        assert law(many) == pytest.approx([law(problem) for problem in each])


def programmes(text, *settings):
    """Return the distinct problems of a study and the index of each point."""
    return distinct_problems(small_study(*settings, text=text))


def test_lengths_are_in_spacings_and_times_in_tau():
    found, index = programmes(HOLDING, PROGRAMME, "material.temperature=20.0", "grid.velocity=0.03")
    assert index.shape == (1, 1, 1, 1, 1, 1, 2)
    tau = 2e-3
    for problem, hold in zip(found, (1e-3, 1e-2), strict=True):
        first, held, last = problem.programme
        assert first == Slide(rounded(0.03 * tau / 1e-4), 10.0)
        assert held == Hold(rounded(hold / tau))
        assert last.speed == rounded(0.06 * tau / 1e-4)
        assert problem.speed == first.speed


def test_a_temperature_is_a_velocity_so_that_points_are_one_problem():
    """log10 a_T = 2.5 at 10 °C: 0.03 m/s there is 9.49 m/s at 20 °C, slide by slide."""
    found, index = programmes(HOLDING, "scene.programme=[{slide={ratio=1.0, distance=1e-3}}]")
    assert index.size == 4
    assert len(found) == 3


def test_material_and_programme_enter_the_key():
    plans = [
        small_plan(*settings, text=HOLDING)
        for settings in (
            (PROGRAMME,),
            (PROGRAMME.replace("1e-2", "2e-2"),),
            (PROGRAMME, "material.branches=[[2e7, 2e-3]]"),
            (PROGRAMME, "scene.repeat=2"),
            (PROGRAMME, 'numerics.record="log"'),
        )
    ]
    found = [set(keys(plan)) for plan in plans]
    assert found[0] & found[1]  # the hold that both have
    for other in found[2:]:
        assert found[0].isdisjoint(other)


def test_parts_are_those_of_every_point_the_last_axis_fastest():
    study = small_study(PROGRAMME, text=HOLDING)
    assert axes_of(study.grid, "material", "scene") == ["temperature", "hold"]
    assert axes_of(study.grid, "grid") == list(COMMON_AXES)
    found = study.parts("", ["temperature", "hold"])
    values = [(own.material.temperature, own.scene.segments[1].durations) for own in found]
    assert values == [(10.0, (1e-3,)), (10.0, (1e-2,)), (20.0, (1e-3,)), (20.0, (1e-2,))]


# What follows from a body: the normal force of a pressure, and the modulus E*.
PRESSED = TEXT.replace(
    "normal_force = [0.04, 0.4]\nspacing", "normal_pressure = [2e4, 4e4]\nspacing"
)


def loads(*settings, label="", **how):
    """Return F_N/(E* L h) of the two pressures, or forces, of the small study."""
    problems, index = distinct_problems(small_study(*settings, **how), label)
    return np.array([problems[row].load for row in index[0, :, 0, 0, 0, 0]])


@pytest.mark.parametrize(("surface", "longest"), [([], 0.01), (["surface.rolloff=1e-3"], 1e-3)])
def test_a_pressure_acts_on_the_longest_wave_times_the_length(surface, longest):
    found = small_study(*surface, "scene.body=foundation", text=PRESSED).grid["normal_force"]
    assert found == pytest.approx([2e4 * longest * 0.01, 4e4 * longest * 0.01], rel=1e-15)


def test_a_pressure_on_a_half_space_acts_on_the_square_for_any_rolloff():
    study = small_study("surface.rolloff=1e-3", "scene.body=half-space", text=PRESSED)
    assert study.grid["normal_force"] == pytest.approx([2.0, 4.0], rel=1e-15)


@pytest.mark.parametrize("periodic", ["mirror", "none"])
@pytest.mark.parametrize("lines", ["measured", "random-phase", "equivalent"])
@pytest.mark.parametrize(("rolloff", "longest"), [([], 1e-5), (["surface.rolloff=4e-6"], 4e-6)])
def test_a_pressure_on_a_measured_line_is_that_of_its_longest_wave(
    rolloff, longest, lines, periodic
):
    left_out = (
        "surface.length",
        "grid.hurst",
        "grid.spacing",
        "grid.roughness",
        "grid.normal_force",
    )
    settings = *rolloff, 'surface.file="two.csv"', "surface.columns=[0,1,2]"
    settings += f"surface.lines={lines}", f"surface.periodic={periodic}", "study.realizations=2"
    study = small_study(*settings, "grid.normal_pressure=1e5", text=without(*left_out))
    (force,) = study.grid["normal_force"]
    assert force == pytest.approx(1e5 * longest * 1e-5, rel=1e-12)
    ((problem, *_), _), surface = distinct_problems(study), study.surface.profile
    unit = study.material.contact_modulus * surface.roughness / surface.spacing
    assert nominal_pressure(problem) * unit == pytest.approx(1e5, rel=1e-12)


def test_compared_bodies_have_the_same_pressure():
    rolled = ("surface.rolloff=1e-3", "scene.body=half-space")
    both = (*rolled, "compare.coarse.body=foundation")
    assert loads(*both, text=PRESSED) == pytest.approx(loads(*rolled, text=PRESSED), rel=1e-12)
    alone = loads("surface.rolloff=1e-3", "scene.body=foundation", text=PRESSED)
    assert loads(*both, label="coarse", text=PRESSED) == pytest.approx(alone, rel=1e-12)


def test_a_compressible_elastomer_is_softer_in_contact():
    """E* = 2 G/(1 - nu): 4 G at 1/2, half of it at 0."""
    assert np.array_equal(loads("material.poisson=0.5"), loads())
    assert loads("material.poisson=0.0") == pytest.approx(2.0 * loads(), rel=1e-12)
    assert loads("material.poisson=0.3") == pytest.approx(1.4 * loads(), rel=1e-12)
