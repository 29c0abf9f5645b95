"""What is said of doubled keys of [material] is so, exactly: other problems are planned."""

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
