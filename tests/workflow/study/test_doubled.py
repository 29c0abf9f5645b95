"""What is said of doubled keys is so: other problems are planned, or more of them."""

import numpy as np
import pytest

from elastomer_friction.workflow.plan.error_laws import LAWS
from elastomer_friction.workflow.plan.problems import line_slope, speed_ratio
from elastomer_friction.workflow.simulate import programme_steps
from tests.support.documents import without
from tests.support.small import keys, small_plan

BRANCHES = without("material.relaxation_time")


def test_a_modulus_doubled_is_forces_halved():
    doubled = keys(small_plan("material.shear_modulus=2e7"))
    assert doubled == keys(small_plan("grid.normal_force=[0.02, 0.2]"))
    assert doubled != keys(small_plan())


def test_a_relaxation_time_doubled_is_velocities_doubled():
    doubled = keys(small_plan("material.relaxation_time=2e-3"))
    assert doubled == keys(small_plan("grid.velocity=[0.06, 0.2]"))


def test_times_of_branches_doubled_are_velocities_doubled():
    asked = 'scene.quantities=["steady", "relaxation"]'
    doubled = small_plan("material.branches=[[5e6, 2e-2]]", asked, text=BRANCHES)
    faster = small_plan(
        "material.branches=[[5e6, 1e-2]]", asked, "grid.velocity=[0.06, 0.2]", text=BRANCHES
    )
    assert keys(doubled) == keys(faster)


def test_c1_doubled_shifts_by_twice_as_many_decades():
    shift = "material.temperature=30.0"
    once, twice = (
        small_plan(f"material.wlf={{c1={c1}, c2=50.0, reference=20.0}}", shift).study.material
        for c1 in (1.2, 2.4)
    )
    assert abs((1e-3 / once.tau) ** 2 / (1e-3 / twice.tau) - 1.0) < 1e-12


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


def test_steps_doubled_at_least_halve_the_error_of_steady_friction():
    (problem, *_) = [task.problem for task in small_plan().variants[0].tasks]
    eight, sixteen = (LAWS["mu_1"].error(problem, m, refine=False) for m in (8, 16))  # a number
    assert eight >= 2.0 * sixteen


def test_a_horizon_doubled_doubles_the_march():
    once, twice = (
        np.array(
            [task.march_steps for task in small_plan(f"numerics.horizon={h}").variants[0].tasks]
        )
        for h in (8, 16)
    )
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


def test_a_programme_repeated_twice_as_often_takes_twice_the_steps():
    assert steps(SLIDE % 1e-3, "scene.repeat=2") == 2 * steps(SLIDE % 1e-3)


def test_a_distance_doubled_takes_twice_the_steps():
    assert steps(SLIDE % 2e-3) == 2 * steps(SLIDE % 1e-3)


def test_realizations_doubled_double_the_records():
    assert small_plan("study.realizations=32").records == 2 * small_plan().records


def test_realizations_per_block_doubled_halve_the_records():
    wide = small_plan("study.realizations_per_block=8")
    assert 2 * wide.records == small_plan("study.realizations_per_block=4").records
    assert keys(wide) != []


def test_a_title_and_a_cluster_change_no_number():
    same = small_plan('study.title="another"', "cluster.jobs=7", 'cluster.memory="4GB"')
    assert keys(same) == keys(small_plan())
    assert keys(small_plan("study.seed=2")) != keys(small_plan())
