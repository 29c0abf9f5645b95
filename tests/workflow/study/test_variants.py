"""Comparisons: each has numerics and a material of its own."""

from elastomer_friction.workflow.study.effects.material import Material
from tests.support.documents import without
from tests.support.small import complaint, small_study

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
    warm = [study.parts(label, ["temperature"])[1].material for label in ("other", "")]
    assert [own.temperature for own in warm] == [50.0, 50.0]
    assert warm[0].tau < warm[1].tau


MEASURED = without("surface.length", "grid.hurst", "grid.spacing", "grid.roughness")
OWN_LINE = ('surface.file="two.csv"', "surface.columns=[0, 1, 2]", "study.realizations=2")


def test_a_comparison_has_lines_like_the_measured_ones():
    study = small_study(
        *OWN_LINE,
        'compare.spectrum.lines="random-phase"',
        'compare.fractal={lines="self-affine", hurst=0.9}',
        text=MEASURED,
    )
    assert study.surfaces[""] == study.surface
    assert study.surfaces["coarse"].lines == study.surface.lines == "measured"
    assert study.surfaces["spectrum"] == study.surface._replace(lines="random-phase")
    assert study.surfaces["fractal"] == study.surface._replace(lines="self-affine", hurst=0.9)
    assert list(study.surfaces) == list(study.variants)


def test_measured_lines_limit_the_realizations_of_all():
    settings = (*OWN_LINE, 'surface.lines="random-phase"', 'compare.own.lines="measured"')
    answer = complaint(*settings, "study.realizations=4", text=MEASURED)
    assert answer == "study.realizations = 4: only 2 lines were measured"
    lines = OWN_LINE[:2]
    assert complaint(*lines, "study.realizations=4", text=MEASURED) == answer
