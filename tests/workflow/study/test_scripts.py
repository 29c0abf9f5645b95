"""Scripts of a study's folder: loaded anew each time; a measure.py says what may be set."""

import os
import pwd

import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.measured import Measured
from elastomer_friction.workflow.study.read import read_study
from elastomer_friction.workflow.study.scripts import BUILT_IN_STUDIES, load_script
from tests.support.commands import refusal


def write(folder, value):
    """Write a script that uses its neighbour."""
    folder.mkdir(exist_ok=True)
    (folder / "helper.py").write_text(f"VALUE = {value}\n")
    (folder / "figure.py").write_text("from .helper import VALUE\n")
    return folder / "figure.py"


def test_an_edited_neighbour_is_loaded_anew(tmp_path):
    assert load_script(write(tmp_path, 1)).VALUE == 1
    assert load_script(write(tmp_path, "-20  # edited")).VALUE == -20


def test_scripts_of_one_name_in_two_folders_do_not_meet(tmp_path):
    scripts = [write(tmp_path / str(value), value) for value in (1, 2)]
    assert [load_script(script).VALUE for script in scripts] == [1, 2]


def test_a_script_that_is_not_there_is_named(tmp_path):
    with pytest.raises(UserError, match=r"figure\.py: not found$"):
        load_script(tmp_path / "figure.py")


def test_a_script_of_the_program_runs_without_a_note(capsys):
    load_script(BUILT_IN_STUDIES / "fig7" / "figure.py")
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize("owner", [os.getuid(), 54321])
def test_another_script_is_named_with_its_owner_before_it_runs(tmp_path, capsys, owner):
    """And so are those of studies/ in the working folder, which come before our own."""
    script = tmp_path / "figure.py"
    script.write_text("import sys\nsys.stderr.write('it runs\\n')\n")
    if owner != os.getuid():
        if os.getuid() != 0:
            pytest.skip("only root can give a file away")
        os.chown(script, owner, -1)
    load_script(script)
    load_script(script)
    name = pwd.getpwuid(owner).pw_name if owner == os.getuid() else f"user {owner}"
    lines = capsys.readouterr().err.splitlines()
    assert lines == [f"note: running {script}, owned by {name}", "it runs", "it runs"]


@pytest.mark.parametrize("line", ["from workflow.scene import run", "import workflow.scene"])
def test_a_script_that_imports_an_old_name_is_told_the_new_one(tmp_path, line):
    script = tmp_path / "figure.py"
    script.write_text(f"import json\n\n{line}\n")
    new = r"figure.py, line 3: imports workflow.scene; import elastomer_friction\.workflow"
    with pytest.raises(UserError, match=new):
        load_script(script)


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
    message = f"error: measure.base: missing ({path}, line 1)\n"
    assert refusal(capsys, "run", "powers") == message


def test_a_setting_that_is_a_check_alone_is_told_what_it_is_now(powers, capsys):
    script = powers / "measure.py"
    script.write_text(script.read_text() + '\nSETTINGS = {"powers": int, "base": float}\n')
    message = refusal(capsys, "plan", "powers").splitlines()[-1]
    assert message.startswith(f"error: {script}: SETTINGS['powers'] is a bare check; write Key(")
