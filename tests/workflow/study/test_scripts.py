"""Scripts of a study's folder: loaded anew each time, from any folder, with their neighbours."""

import pytest

from workflow.errors import UserError
from workflow.study.scripts import load_script


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
