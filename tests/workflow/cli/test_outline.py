"""What `plan` prints: points, problems, errors, cost; it computes and writes nothing."""

import json
import re

import numpy as np
import pytest

from elastomer_friction.workflow.cli import run_options
from elastomer_friction.workflow.cli.outline import absent_effects, outline_grid
from elastomer_friction.workflow.study.effects.quantities import QUANTITIES
from tests.support.commands import facts, output, refusal
from tests.support.small import TEXT, small_plan, small_study

STEADY = 'scene.quantities=["steady"]'
RUBBER = ("material.branches=[[5e6, 1e-2]]", "compare.coarse={}")
WLF = "material.wlf={c1=8.86, c2=101.6, reference=20}"


def test_plan_prints_axes_points_problems_and_realizations(capsys, study):
    settings = ["--set", "grid.roughness=[1e-5, 1e-6]", "--set", "grid.normal_force=[0.04, 0.4]"]
    table = facts(output(capsys, "plan", study, *settings))
    assert table["points"] == "points      16, 12 distinct problems"
    assert table["realizations"] == "realizations 16 each, 384 in all"
    assert table["normal_force"].split() == ["normal_force", "2", "0.04", "...", "0.4"]
    assert table["spacing"].split() == ["spacing", "1", "0.0001"]


def test_plan_is_a_short_table_in_a_fixed_order(capsys, study):
    lines = output(capsys, "plan", study).splitlines()
    firsts = list(dict.fromkeys(line.split()[0] for line in lines if not line.startswith(" ")))
    order = "study result computes body points realizations steps predicted memory errors model "
    order += "material not"
    assert firsts == [*order.split(), "settings"]
    assert len(lines) <= 24


@pytest.mark.parametrize(
    ("settings", "line", "pattern"),
    [
        ([], "steps", r".*marches of .* steps"),
        ([STEADY], "steps", r".*no march"),
        (["study.realizations=100000"], "predicted", r".* about \d\S* to \d\S* core-.*"),
        (["grid.roughness=0.01"], "warning", r"warning .* slope is \d.*, .* small"),
        ([], "memory", r"memory +\d{3,} MiB per worker, .* samples"),
        (RUBBER, "errors", r".*unknown before the run.*"),  # a rubber of several times
        (
            ["study.realizations=10"],
            "realizations",
            r"realizations 12 each \(10 rounded up to 3 blocks of 4\), 192 in all",
        ),
        (
            ["numerics.accuracy=0.05"],
            "accuracy",
            r"accuracy +0\.05 coarse: .* realizations each; .*",
        ),
    ],
)
def test_lines_of_the_table(capsys, study, settings, line, pattern):
    options = [word for setting in settings for word in ("--set", setting)]
    assert re.fullmatch(pattern, facts(output(capsys, "plan", study, *options))[line])


def test_plan_samples_the_cost(capsys, study):
    table = facts(output(capsys, "plan", study, "--sample", "0.05"))
    assert re.fullmatch(r"sampled     .* core-seconds from \d+ samples?.*", table["sampled"])
    data = json.loads(output(capsys, "plan", study, "--sample", "0.05", "--json"))
    assert data["samples"] >= 1
    assert data["sampled_core_seconds"] > 0.0
    assert data["sampled_core_seconds_error"] is None or data["sampled_core_seconds_error"] >= 0.0
    assert "samples" not in json.loads(output(capsys, "plan", study, "--json"))


@pytest.mark.parametrize("seconds", ["0", "-1", "nan", "inf"])
def test_a_sample_takes_a_positive_time(capsys, study, seconds):
    words = refusal(capsys, "plan", study, "--sample", seconds)
    assert re.match(r"error: --sample \S+: must be a positive number of seconds", words)


def test_a_measured_study_has_no_batches_to_sample(capsys, powers):
    assert powers.is_dir()
    assert "--sample" in refusal(capsys, "plan", "powers", "--sample", "1")


def test_a_plan_of_many_points_is_announced(capsys, monkeypatch):
    plan = small_plan()
    for seconds, message in ((0.9, ""), (2.1, "Planning 16 points, about 2 s.\n")):
        monkeypatch.setattr(run_options, "SECONDS_PER_POINT", seconds / 16)
        assert run_options.announced_plan(plan.study).points == plan.points
        assert capsys.readouterr().err == message


def test_absent_quantities_have_reasons(capsys, study):
    absent = absent_effects(small_study())
    assert set(QUANTITIES) - set(absent) == {"steady", "jump", "relaxation"}
    assert absent["models"] == "it is not requested"
    assert absent["trace"] == "needs a [[scene.programme]]"
    assert absent["state"].startswith("needs a single line")
    assert absent["programme"] == "there is no [[scene.programme]]; v1 steps to v2"
    assert absent["rolloff"] == "surface.rolloff is not given"
    assert json.loads(output(capsys, "plan", study, "--json"))["not_simulated"] == absent
    (line,) = re.findall("^not simulated (.*) [(]--json", output(capsys, "plan", study), re.M)
    assert line.split(", ") == list(absent)


@pytest.mark.parametrize(
    ("settings", "present"),
    [
        (("surface.rolloff=2e-3", "surface.cutoff=4e-4"), {"rolloff", "cutoff"}),
        ((*RUBBER, STEADY), {"branches of relaxation"}),
        (("material.temperature=[0, 20]", WLF), {"temperature"}),
        (("material.temperature=50", WLF), {"temperature"}),
        (("scene.body=half-space",), {"half-space"}),
        (("scene.body=half-space", "scene.shear.stress=1e5"), {"shear"}),
    ],
)
def test_effects_that_are_simulated_are_not_absent(settings, present):
    plain = absent_effects(small_study())
    assert present <= set(plain)
    assert not present & set(absent_effects(small_study(*settings)))


PROGRAMME = """
[[scene.programme]]
slide = {ratio = 1, distance = 1e-3}
[[scene.programme]]
hold = {duration = [1, 10]}
[[scene.programme]]
slide = {ratio = 1, distance = 1e-3}
"""
SCENE = TEXT.replace("velocity_step = 0.2\n", "") + PROGRAMME


def test_programmes_and_controls():
    absent = absent_effects(small_study(text=SCENE))
    assert "programme" not in absent
    assert "constant normal force" not in absent
    assert absent["prescribed indentation"] == 'scene.control is "force"'
    assert absent["loop"] == "needs a segment oscillate in the programme"
    indentation = SCENE.replace("normal_force = [0.04, 0.4]", "prescribed_indentation = 1e-5", 1)
    indentation = indentation.partition("[scales")[0] + PROGRAMME
    absent = absent_effects(small_study("scene.control=indentation", text=indentation))
    assert "prescribed indentation" not in absent
    assert absent["constant normal force"] == 'scene.control is "indentation"'
    assert absent["steady"].startswith("needs a given normal force")


def test_the_plan_states_the_shear_and_a_surface_without_a_cutoff(tmp_path):
    own = ("scene.body=half-space", "scene.shear.stress=1e5", "grid.normal_force=1e4")
    for cutoff, count in ((), 2), (("surface.cutoff=4e-4",), 0):
        lines = outline_grid(small_study(*own, *cutoff), tmp_path / "small.nc")[0]
        assert sum(line.startswith("shear       ") and "100000 Pa" in line for line in lines) == 2
        assert sum(line.startswith("warning     ") for line in lines) == count


MAP = """
[material]
shear_modulus = 1e7
relaxation_time = 1e-3
[surface]
file = "map.txt"
step = 1e-5
units = ["m", "m"]
[grid]
normal_pressure = 1e5
velocity = 0.1
[scene]
quantities = ["steady"]
"""


@pytest.mark.parametrize(("height", "warned"), [(2.3e-5, True), (1.4e-5, False)])
def test_a_mirrored_map_has_the_slope_of_the_measured_one(tmp_path, capsys, height, warned):
    x = 2.0 * np.pi * np.arange(64) / 8.0
    np.savetxt(tmp_path / "map.txt", height * np.add.outer(np.cos(x), np.cos(x)))
    study = tmp_path / "study.toml"
    study.write_text(MAP, encoding="utf-8")
    for periodic in ("none", "mirror"):
        table = facts(output(capsys, "plan", str(study), "--set", f"surface.periodic={periodic}"))
        assert ("warning" in table) == warned
