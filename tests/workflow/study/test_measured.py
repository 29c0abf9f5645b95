"""A measured study: its measure.py says which settings there are and what they may be."""

import pytest

from elastomer_friction.workflow.study.measured import Measured
from elastomer_friction.workflow.study.read import read_study
from tests.support.commands import refusal


def test_scale_and_set_apply(powers):
    assert read_study("powers", "smoke").settings == {"powers": 1, "base": 2.0}
    assert read_study("powers", "smoke", ["measure.base=3"]).settings["base"] == 3.0
    assert isinstance(read_study(str(powers / "study.toml")), Measured)


@pytest.mark.parametrize(
    ("setting", "line"),
    [
        ("measure.other=1", "measure.other: unknown key; known are powers, base"),
        ("measure.powers=0", "measure.powers = 0: must be a whole number, at least 1"),
        ("measure=1", "measure = 1: must be a table"),
        ("study.realizations=9", "study.realizations: unknown key; known are title, seed"),
        ("grid.hurst=0.5", "grid: unknown key; known are study, measure"),
        ("study.seed=-1", "study.seed = -1: must be a whole number, at least 0"),
    ],
)
def test_wrong_settings_are_refused_in_one_line(powers, capsys, setting, line):
    assert refusal(capsys, "plan", "powers", "--set", setting) == f"error: {line}\n"


def test_a_missing_setting_is_named(powers, capsys):
    path = powers / "study.toml"
    path.write_text("[measure]\npowers = 2\n")
    said = f"error: measure.base: missing ({path}, line 1)\n"
    assert refusal(capsys, "run", "powers") == said


def test_a_missing_script_is_named(powers, capsys):
    (powers / "measure.py").unlink()
    assert "measure.py: not found" in refusal(capsys, "run", "powers")


def test_a_setting_that_is_a_check_alone_is_told_what_it_is_now(powers, capsys):
    script = powers / "measure.py"
    script.write_text(script.read_text() + '\nSETTINGS = {"powers": int, "base": float}\n')
    said = refusal(capsys, "plan", "powers").splitlines()[-1]
    assert said.startswith(f"error: {script}: SETTINGS['powers'] is a check alone; it is now Key(")
