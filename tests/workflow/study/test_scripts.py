"""Scripts of a study's folder: loaded anew each time, from any folder, with their neighbours."""

import pytest

from workflow.errors import UserError
from workflow.study.scripts import load_script


@pytest.fixture
def script(tmp_path):
    """Return a script that uses its neighbour."""
    (tmp_path / "helper.py").write_text("VALUE = 1\n")
    (tmp_path / "figure.py").write_text("from .helper import VALUE\n")
    return tmp_path / "figure.py"


def test_a_script_reaches_its_neighbours(script):
    assert load_script(script).VALUE == 1


def test_an_edited_neighbour_is_loaded_anew(script):
    load_script(script)
    (script.parent / "helper.py").write_text("VALUE = -20  # edited\n")
    assert load_script(script).VALUE == -20


def test_scripts_of_one_name_in_two_folders_do_not_meet(script, tmp_path):
    other = tmp_path / "other"
    other.mkdir()
    (other / "helper.py").write_text("VALUE = 2\n")
    (other / "figure.py").write_text("from .helper import VALUE\n")
    assert (load_script(script).VALUE, load_script(other / "figure.py").VALUE) == (1, 2)


def test_a_script_that_is_not_there_is_named(tmp_path):
    with pytest.raises(UserError, match=r"figure\.py: not found$"):
        load_script(tmp_path / "figure.py")
