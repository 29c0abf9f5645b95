"""Comparisons: each has numerics and a material of its own."""

from tests.support.small import small_study
from workflow.study.effects.material import Material

BRANCHED = "compare.glassy={branches=[[5e6, 1e-2]], relaxation_time=0}"


def test_a_comparison_has_the_material_of_the_study_but_for_its_keys():
    study = small_study(BRANCHED, 'scene.quantities=["steady"]')
    assert study.materials[""] == study.material == Material(1e7, 1e-3)
    assert study.materials["coarse"] == study.material
    assert study.materials["glassy"] == Material(1e7, 0.0, ((5e6, 1e-2),))
    assert study.variants["glassy"] == study.variants[""]
    assert list(study.materials) == list(study.variants)


def test_branches_and_a_file_of_them_take_each_others_place():
    own = 'material.branches_file="branches.csv"'
    study = small_study(own, "compare.glassy.branches=[[5e6, 1e-2]]")
    assert len(study.material.branches) == 2
    assert len(study.materials["glassy"].branches) == 1
    study = small_study("material.branches=[[5e6, 1e-2]]", f"compare.two.{own[9:]}")
    assert len(study.materials["two"].branches) == 2
    study = small_study(own, "compare.kelvin.branches=[]")
    assert study.materials["kelvin"] == Material(1e7, 1e-3)


def test_a_comparison_shifts_with_constants_of_its_own():
    wlf = "{{c1={}, c2=101.6, reference=20}}"
    study = small_study(
        f"material.wlf={wlf.format(8.86)}",
        "material.temperature=[20, 50]",
        f"compare.other.wlf={wlf.format(17.4)}",
    )
    assert study.materials["other"].temperatures == (20.0, 50.0)
    assert study.materials["other"].tau_at(50.0) < study.material.tau_at(50.0)
