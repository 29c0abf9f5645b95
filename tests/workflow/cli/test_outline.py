"""What `plan` prints: points, problems, effects, costs; it computes and writes nothing."""

import json
import re

import numpy as np
import pytest

from elastomer_friction.workflow.cli import outline
from elastomer_friction.workflow.cli.outline import effects, march_lines
from elastomer_friction.workflow.plan.foreseen import expected_errors
from elastomer_friction.workflow.study.effects.quantities import QUANTITIES
from tests.support.commands import facts, output
from tests.support.documents import without
from tests.support.small import TEXT, small_plan, small_study


def test_plan_prints_axes_points_problems_and_realizations(capsys, study):
    settings = ["--set", "grid.roughness=[1e-5, 1e-6]", "--set", "grid.normal_force=[0.04, 0.4]"]
    found = facts(output(capsys, "plan", study, *settings))
    assert found["points"].split() == ["points", "16"]
    assert found["problems"].startswith("problems    12 distinct dimensionless problems (1.33 ")
    assert found["realizations"] == "realizations 16 each, 384 in all"
    assert found["variants"].split(maxsplit=1)[1] == "study, coarse"
    assert found["normal_force"].split() == ["normal_force", "2", "0.04", "...", "0.4"]
    assert found["spacing"].split() == ["spacing", "1", "0.0001"]


def test_plan_says_which_effects_are_simulated(capsys, study):
    everything = output(capsys, "plan", study)
    assert re.search("^not simulated .* models, .*--json says why", everything, re.MULTILINE)
    why = json.loads(output(capsys, "plan", study, "--json"))["not_simulated"]
    assert why["models"] == "it is not asked for"
    assert "indentation rate in the force: kept" in everything
    settings = ["--set", STEADY, "--set", "scene.indentation_rate=false"]
    steady = output(capsys, "plan", study, *settings)
    assert "simulated     steady: steady sliding" in steady
    assert re.search("^not simulated .* jump, relaxation, ", steady, re.MULTILINE)
    assert "indentation rate in the force: dropped" in steady


def test_plan_says_what_was_read_of_a_file_of_lines():
    left_out = ("surface.length", "grid.hurst", "grid.spacing", "grid.roughness")
    study = small_study(
        'surface.file="hole.csv"',
        'surface.gaps="fill"',
        'compare.like.lines="random-phase"',
        text=without(*left_out, "study.realizations"),
    )
    own, like = outline.read_lines_of(study)
    assert own.startswith(
        "lines       hole.csv: 1 line of 10 samples, 1e-06 m apart in the mean, hei"
    )
    assert "; columns 0 x, 1 z, by their names; 1 of 10 samples were missing and were fil" in own
    assert own.endswith("a single line has no standard error: errors are NaN")
    assert like.startswith(
        "lines       random lines of the power spectrum of hole.csv: 1 line of 10"
    )
    assert outline.read_lines_of(small_study()) == []


def test_plan_says_what_is_marched_and_how_far_memory_reaches():
    programme = "[{slide={ratio=1, distance=1e-3}}, {hold={duration=1}}]"
    settings = [f"scene.programme={programme}", 'scene.quantities=["steady", "trace"]']
    text = without("grid.velocity_step", "compare.coarse")
    (variant,) = small_plan(*settings, text=text).variants
    marches, reach = march_lines(variant)
    # 10 spacings in 8 steps each; a hold that begins with a quarter of a step
    assert re.fullmatch(r"marches     study: steps: slide 80, hold (\d+) .* in all .*", marches)
    assert reach == "remembers   study: v t_max / L = 0.003 ... 0.01"  # 1 ms at 0.03, 0.1 m/s, 1 cm


STEADY = 'scene.quantities=["steady"]'
RUBBER = ("material.branches=[[5e6, 1e-2]]", "compare.coarse={}")


@pytest.mark.parametrize(
    ("settings", "line", "pattern"),
    [
        ([], "marches", r".*after the velocity step.*"),
        ([STEADY], "marches", r".*none: steady sliding is solved"),
        (["study.realizations=100000"], "predicted", r".* about \d\S* to \d\S* core-(min|hou).*"),
        ([], "memory", r"memory +\d{3,} MiB per worker, .* samples"),
        (RUBBER, "standard", r".*not known before the run.*"),  # a rubber of many times
        (RUBBER, "discretisation", r".*not known before the run.*"),
        (
            ["study.realizations=10"],
            "realizations",
            r"realizations 12 each \(10 rounded up to whole quartets of lines\), 192 in all",
        ),
    ],
)
def test_plan_says_what_is_marched_what_it_costs_and_what_is_not_known(
    capsys, study, settings, line, pattern
):
    options = [word for each in settings for word in ("--set", each)]
    assert re.fullmatch(pattern, facts(output(capsys, "plan", study, *options))[line])


def test_plan_leads_with_what_is_computed_what_it_costs_and_the_three_errors(capsys, study):
    lines = output(capsys, "plan", study).splitlines()
    firsts = [line.split()[0] for line in lines if not line.startswith(" ")]
    order = "study result computes points problems variants realizations predicted time memory"
    assert firsts[:13] == [*order.split(), "standard", "discretisation", "model"]
    assert sum(line.startswith("not simulated") for line in lines) == 1


def test_expected_errors_fall_with_the_lines_and_with_the_steps():
    few, many = (expected_errors(small_plan(f"study.realizations={n}")) for n in (16, 64))
    coarse, fine = (
        expected_errors(small_plan(f"numerics.steps_per_spacing={m}")) for m in (64, 256)
    )
    assert few.keys() == {"mu_1", "jump", "relaxation_rate"}
    for name in few:
        np.testing.assert_allclose(few[name].chance, 2.0 * many[name].chance)
        assert np.all(fine[name].discretisation < coarse[name].discretisation)


def test_a_long_run_is_offered_a_first_look_at_steady_friction(capsys, study, monkeypatch):
    assert "first look" not in output(capsys, "plan", study)
    monkeypatch.setattr(outline, "PATIENCE", 0.0)
    monkeypatch.setattr(outline, "MUCH", 1.0)
    found = facts(output(capsys, "plan", study))
    assert "steady friction alone takes about " in found["first"]
    steady = output(capsys, "plan", study, "--set", STEADY)
    assert "first look" not in steady  # it is one


def test_a_plan_of_many_points_is_announced(capsys, monkeypatch):
    plan = small_plan()
    for seconds, said in ((0.9, ""), (2.1, "Planning 16 points, about 2 s.\n")):
        monkeypatch.setattr(outline, "SECONDS_PER_POINT", seconds / 16)
        assert outline.announced_plan(plan.study, plan.pace).points == plan.points
        assert capsys.readouterr().err == said


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
    found = ({}, {})
    for known, what in effects(small_study(*settings, text=text)):
        name, _, rest = what.partition(":")
        assert name not in found[0] | found[1]
        found[not known][name] = rest.strip()
    return found


def test_every_quantity_is_named_once_with_its_reason():
    simulated, absent = said()
    assert set(QUANTITIES) <= set(simulated) | set(absent)
    assert {"steady", "jump", "relaxation"} <= set(simulated)
    assert absent["models"] == "it is not asked for"
    assert absent["trace"] == "needs a [[scene.programme]]"
    assert absent["state"].startswith("needs a single line")
    assert absent["programme"] == "there is no [[scene.programme]]; v1 steps to v2"
    assert absent["rolloff"] == "surface.rolloff is not given"


WLF = "material.wlf={c1=8.86, c2=101.6, reference=20}"


def test_materials_and_temperatures():
    simulated, absent = said()
    assert simulated["rheology"] == "Kelvin element, tau = 0.001 s"
    assert absent["branches of relaxation"] == "material.branches is not given"
    assert absent["temperature"] == "material.temperature and wlf are not given"
    simulated, absent = said(
        "compare.sls={branches=[[5e6, 1e-2]], relaxation_time=0}",
        "compare.both={branches=[[5e6, 1e-2], [1e7, 1e-3]]}",
        "material.temperature=[0, 20]",
        WLF,
        STEADY,
    )
    assert simulated["rheology of sls"].startswith("standard linear solid without a dashpot")
    assert simulated["rheology of both"].startswith("Prony series of 2 branches with a dashpot")
    assert simulated["2 temperatures"] == "all times shifted by WLF"
    assert "branches of relaxation" not in absent
    assert "rheology of coarse" not in simulated  # that of the study
    table = 'material.shifts_file="shifts.csv"'
    for law, words in ((WLF, "by WLF"), (table, "by a table (shifts.csv: 3 rows; column 0")):
        simulated, _ = said("material.temperature=50", law)
        assert f"all times shifted {words}" in simulated["one temperature"]


def test_programme_and_control():
    simulated, absent = said(text=SCENE)
    assert simulated["programme from steady"] == "slide, hold, slide"
    assert "constant normal force" in simulated
    assert absent["prescribed indentation"] == 'scene.control is "force"'
    assert absent["loop"] == "needs a segment oscillate in the programme"
    assert absent["healing"] == "it is not asked for"
    indentation = SCENE.replace("normal_force = [0.04, 0.4]", "prescribed_indentation = 1e-5", 1)
    indentation = indentation.partition("[scales")[0] + PROGRAMME
    simulated, absent = said("scene.control=indentation", text=indentation)
    assert "prescribed indentation, constant" in simulated
    assert absent["constant normal force"] == 'scene.control is "indentation"'
    assert absent["steady"].startswith("needs a given normal force")


def test_a_rolloff_is_simulated():
    simulated, absent = said("surface.rolloff=2e-3", "surface.cutoff=4e-4")
    assert (simulated["rolloff"], simulated["cutoff"]) == ("0.002 m", "0.0004 m")
    assert "measured lines" in absent
