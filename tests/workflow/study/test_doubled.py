"""What is said of doubled keys is so: other problems are planned, or more of them."""

import numpy as np
import pytest

from elastomer_friction.workflow.plan.error_laws import LAWS
from elastomer_friction.workflow.plan.problems import line_slope, speed_ratio
from elastomer_friction.workflow.simulate import programme_steps
from tests.support.documents import without
from tests.support.small import keys, small_plan

BRANCHES = without("material.relaxation_time")
FASTER, LIGHTER = "grid.velocity=[0.06, 0.2]", "grid.normal_force=[0.02, 0.2]"


@pytest.mark.parametrize(
    ("doubled", "other"),
    [
        ("material.shear_modulus=2e7", LIGHTER),
        ("grid.roughness=2e-5", LIGHTER),
        ("material.relaxation_time=2e-3", FASTER),
    ],
)
def test_one_key_doubled_is_another_one_doubled_or_halved(doubled, other):
    assert keys(small_plan(doubled)) == keys(small_plan(other)) != keys(small_plan())


def test_times_of_branches_doubled_are_velocities_doubled():
    asked = 'scene.quantities=["steady", "relaxation"]'
    doubled = small_plan("material.branches=[[5e6, 2e-2]]", asked, text=BRANCHES)
    faster = small_plan("material.branches=[[5e6, 1e-2]]", asked, FASTER, text=BRANCHES)
    assert keys(doubled) == keys(faster)


@pytest.mark.parametrize(
    "law",
    ["wlf={{c1={}, c2=50.0, reference=20}}", "arrhenius={{activation_energy={}e4, reference=20}}"],
)
def test_a_constant_doubled_shifts_by_twice_as_many_decades(law):
    shift = "material.temperature=30.0"
    once, twice = (
        small_plan(f"material.{law.format(value)}", shift).study.material for value in (1.2, 2.4)
    )
    assert abs((1e-3 / once.tau) ** 2 / (1e-3 / twice.tau) - 1.0) < 1e-12


def of(*settings):
    """Return (elements, load, x, rms slope) of the small study at one point."""
    one = ("grid.hurst=0.7", "grid.normal_force=0.04", "grid.velocity=0.1", *settings)
    (problem,) = (task.problem for task in small_plan(*one).variants[0].tasks)
    spacing = 0.01 / problem.elements  # not of a line whose length is changed
    slope = line_slope(problem, "modal") / spacing
    return np.array([problem.elements, problem.load, speed_ratio(problem), slope])


@pytest.mark.parametrize(
    ("doubled", "once", "change"),
    [
        ("grid.velocity=0.2", "grid.velocity=0.1", (1.0, 1.0, 2.0, 1.0)),
        ("grid.spacing=2e-4", "grid.spacing=1e-4", (0.5, 1.0, 0.5, 2.0**-0.3)),
        ("surface.length=0.02", "surface.length=0.01", (2.0, 0.5, 1.0, 2.0**0.3)),
        ("surface.cutoff=8e-4", "surface.cutoff=4e-4", (1.0, 1.0, 0.5, 2.0**-0.3)),
        ("surface.rolloff=8e-4", "surface.rolloff=4e-4", (1.0, 1.0, 1.0, 2.0**-0.7)),
    ],
)
def test_elements_load_x_and_slope_change_as_is_said(doubled, once, change):
    actual = of(doubled) / of(once)
    assert actual[:3] == pytest.approx(change[:3], rel=0.05)
    assert actual[3] == pytest.approx(change[3], rel=0.15 if "rolloff" in doubled else 0.05)


def test_steps_doubled_at_least_halve_the_error_of_steady_friction():
    (problem, *_) = [task.problem for task in small_plan().variants[0].tasks]
    eight, sixteen = (LAWS["mu_1"].error(problem, m, refine=False) for m in (8, 16))  # a number
    assert eight >= 2.0 * sixteen


def test_a_horizon_doubled_doubles_the_march():
    plans = (small_plan(f"numerics.horizon={horizon}") for horizon in (8, 16))
    once, twice = (np.array([task.march_steps for task in p.variants[0].tasks]) for p in plans)
    assert np.all(np.abs(twice / once - 2.0) < 0.3)


def test_an_accuracy_doubled_takes_a_quarter_of_the_lines():
    fine, coarse = (
        sum(small_plan(f"numerics.accuracy={a}", "numerics.steps_per_spacing=8").expected.values())
        for a in (0.01, 0.02)
    )
    assert 3.5 < fine / coarse < 4.5


WITHOUT_STEP = without("grid.velocity_step", "grid.velocity")
SLIDE = "scene.programme=[{slide={velocity=0.1, distance=%g}}]"


def steps(*settings):
    """Return the time steps of a scene of one slide."""
    task = small_plan(*settings, text=WITHOUT_STEP).variants[0].tasks[0]
    return programme_steps(task.problem, task.steps_per_spacing).leg.size


def test_a_programme_repeated_or_twice_as_long_takes_twice_the_steps():
    once = steps(SLIDE % 1e-3)
    assert steps(SLIDE % 1e-3, "scene.repeat=2") == steps(SLIDE % 2e-3) == 2 * once


def test_realizations_doubled_double_the_records_and_those_of_a_block_halve_them():
    assert small_plan("study.realizations=32").records == 2 * small_plan().records
    assert 2 * small_plan("study.realizations_per_block=8").records == small_plan().records
