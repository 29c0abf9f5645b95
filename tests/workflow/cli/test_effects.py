"""What `plan` says of every effect: simulated, or not and why."""

from elastomer_friction.workflow.cli.outline import effect_lines
from elastomer_friction.workflow.study.effects.quantities import QUANTITIES
from tests.support.small import TEXT, small_study

PROGRAMME = """
[[scene.programme]]
slide = {ratio = 1, distance = 1e-3}
[[scene.programme]]
hold = {duration = [1, 10]}
[[scene.programme]]
slide = {ratio = 1, distance = 1e-3}
"""
SCENE = TEXT.replace("velocity_step = 0.2\n", "") + PROGRAMME


def said(*settings, text=TEXT):
    """Return (what is simulated, what is not): why, by the words that the line begins with."""
    lines = effect_lines(small_study(*settings, text=text))
    found = ({}, {})
    for line in lines[:-1]:
        known = line.startswith("simulated")
        assert known or line.startswith("not simulated ")
        name, _, rest = line[14:].partition(":")
        assert name not in found[0] | found[1]
        found[not known][name] = rest.strip()
    return found


def test_every_quantity_is_named_once_with_its_reason():
    simulated, absent = said()
    assert set(QUANTITIES) <= set(simulated) | set(absent)
    assert {"steady", "jump", "relaxation"} <= set(simulated)
    assert absent["models"] == "it is not asked for"
    assert absent["trace"] == "there is no [[scene.programme]]"
    assert absent["state"].startswith("is there for a single line alone")
    assert absent["programme"] == "there is no [[scene.programme]]; v1 steps to v2"
    assert absent["rolloff"] == "surface.rolloff is not given"


def test_materials_and_temperatures():
    simulated, absent = said()
    assert simulated["rheology"] == "Kelvin element, tau = 0.001 s"
    assert absent["branches of relaxation"] == "material.branches is not given"
    assert absent["temperature"] == "material.temperature and wlf are not given"
    simulated, absent = said(
        "compare.sls={branches=[[5e6, 1e-2]], relaxation_time=0}",
        "compare.both={branches=[[5e6, 1e-2], [1e7, 1e-3]]}",
        "material.temperature=[0, 20]",
        "material.wlf={c1=8.86, c2=101.6, reference=20}",
        'scene.quantities=["steady"]',
    )
    assert simulated["rheology of sls"].startswith("standard linear solid without a dashpot")
    assert simulated["rheology of both"].startswith("Prony series of 2 branches with a dashpot")
    assert simulated["2 temperatures"] == "all times shifted by WLF"
    assert "branches of relaxation" not in absent
    assert "rheology of coarse" not in simulated  # that of the study


def test_one_temperature():
    wlf = "material.wlf={c1=8.86, c2=101.6, reference=20}"
    simulated, _ = said("material.temperature=50", wlf)
    assert simulated["one temperature"] == "all times shifted by WLF"


def test_programme_and_control():
    simulated, absent = said(text=SCENE)
    assert simulated["programme from steady"] == "slide, hold, slide"
    assert "constant normal force" in simulated
    assert absent["prescribed indentation"] == 'scene.control is "force"'
    assert absent["loop"] == "the programme has no oscillation"
    assert absent["healing"] == "it is not asked for"
    indentation = SCENE.replace("normal_force = [0.04, 0.4]", "prescribed_indentation = 1e-5", 1)
    indentation = indentation.partition("[scales")[0] + PROGRAMME
    simulated, absent = said("scene.control=indentation", text=indentation)
    assert "prescribed indentation, constant" in simulated
    assert absent["constant normal force"] == 'scene.control is "indentation"'
    assert absent["steady"].startswith("is defined at a given normal force")


def test_a_rolloff_is_simulated():
    simulated, absent = said("surface.rolloff=2e-3", "surface.cutoff=4e-4")
    assert (simulated["rolloff"], simulated["cutoff"]) == ("0.002 m", "0.0004 m")
    assert "measured lines" in absent
