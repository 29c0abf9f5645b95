"""What `plan` prints: points, problems, effects, costs; it computes and writes nothing."""

import re

from elastomer_friction.workflow.cli import outline
from elastomer_friction.workflow.cli.outline import march_lines
from tests.support.commands import facts, output
from tests.support.documents import without
from tests.support.small import small_plan


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
    assert "not simulated models: it is not asked for" in everything
    assert "indentation rate in the force: kept" in everything
    settings = ["--set", 'scene.quantities=["steady"]', "--set", "scene.indentation_rate=false"]
    steady = output(capsys, "plan", study, *settings)
    assert "simulated     steady: steady sliding" in steady
    assert "not simulated jump: it is not asked for" in steady
    assert "not simulated relaxation: it is not asked for" in steady
    assert "indentation rate in the force: dropped" in steady


def test_plan_says_what_is_marched_and_how_far_memory_reaches():
    programme = "[{slide={ratio=1, distance=1e-3}}, {hold={duration=1}}]"
    settings = [f"scene.programme={programme}", 'scene.quantities=["steady", "trace"]']
    text = without("grid.velocity_step", "compare.coarse")
    (variant,) = small_plan(*settings, text=text).variants
    marches, reach = march_lines(variant)
    # 10 spacings in 8 steps each; a hold that begins with a quarter of a step
    assert re.fullmatch(r"marches     study: steps: slide 80, hold (\d+) .* in all .*", marches)
    assert reach == "remembers   study: v t_max / L = 0.003 ... 0.01"  # 1 ms at 0.03, 0.1 m/s, 1 cm


def test_plan_says_that_nothing_is_marched_where_steady_sliding_is_solved(capsys, study):
    found = facts(output(capsys, "plan", study))
    assert "after the velocity step" in found["marches"]
    found = facts(output(capsys, "plan", study, "--set", 'scene.quantities=["steady"]'))
    assert found["marches"].endswith("none: steady sliding is solved")


def test_plan_predicts_time_and_memory(capsys, study):
    found = facts(output(capsys, "plan", study, "--set", "study.realizations=100000"))
    assert re.fullmatch(r"predicted +about \d\S* to \d\S* core-(minutes|hours)", found["predicted"])
    assert int(found["memory"].split()[1]) > 100
    assert found["memory"].endswith("samples")


def test_plan_computes_and_writes_nothing(capsys, study, tmp_path):
    found = facts(output(capsys, "plan", study, "--out", str(tmp_path / "out")))
    assert found["result"].split()[1] == str(tmp_path / "out" / "small.nc")
    assert not (tmp_path / "out").exists()


def test_plan_says_when_realizations_are_rounded_up(capsys, study):
    found = facts(output(capsys, "plan", study, "--set", "study.realizations=10"))
    words = "realizations 12 each (10 rounded up to whole quartets of lines), 192 in all"
    assert found["realizations"] == words


def test_a_plan_of_many_points_is_announced(capsys, monkeypatch):
    plan = small_plan()
    for seconds, said in ((0.9, ""), (2.1, "Planning 16 points, about 2 s.\n")):
        monkeypatch.setattr(outline, "SECONDS_PER_POINT", seconds / 16)
        assert outline.announced_plan(plan.study, plan.pace).points == plan.points
        assert capsys.readouterr().err == said
