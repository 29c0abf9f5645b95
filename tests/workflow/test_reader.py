"""Reading study.toml: scales, --set, comparisons, and where a study is looked for."""

import json

import pytest

from tests.workflow.small import TEXT, small_study, write_study
from workflow.study.numerics import Numerics
from workflow.study.read import find_study, read_study


def test_values_of_the_file_reach_the_study():
    study = small_study()
    assert (study.name, study.title, study.seed) == ("small", "small", 1)
    assert (study.realizations, study.realizations_per_block, study.blocks) == (4, 1, 4)
    assert (study.shear_modulus, study.relaxation_time, study.length) == (1e7, 1e-3, 0.01)
    assert study.grid["normal_force"] == (0.04, 0.4)
    assert study.shape == (2, 2, 1, 1, 2, 1)


def test_what_is_left_out_takes_its_default():
    study = small_study(text=TEXT.replace("seed = 1", "").replace('title = "small"', ""))
    assert (study.seed, study.title, study.normalisation) == (0, "small", "modal")
    assert study.scene.quantities == ("steady", "jump", "relaxation")
    assert study.scene.indentation_rate
    assert study.variants[""] == Numerics(curve_samples=16)


def test_quantities_come_in_their_own_order():
    study = small_study('scene.quantities=["relaxation","steady"]')
    assert study.scene.quantities == ("steady", "relaxation")


def test_steady_states_alone_need_no_velocity_step():
    study = small_study('scene.quantities=["steady"]', text=TEXT.replace("velocity_step = 0.2", ""))
    assert study.grid["velocity_step"] == (0.0,)


def test_scale_overrides_what_it_names_only():
    wide = small_study(scale="wide")
    assert wide.grid["normal_force"] == (0.04, 0.4, 4.0)
    assert wide.grid["velocity"] == small_study().grid["velocity"]


def test_scale_replaces_a_generated_axis_whole():
    text = TEXT.replace("[0.04, 0.4]\n", "{geomspace = [0.01, 1.0, 3]}\n")
    text = text.replace("[0.04, 0.4, 4.0]", "{linspace = [1.0, 2.0, 2]}")
    assert small_study(text=text, scale="wide").grid["normal_force"] == (1.0, 2.0)


def test_settings_override_the_scale():
    study = small_study("grid.normal_force=7", scale="wide")
    assert study.grid["normal_force"] == (7.0,)


def test_the_last_of_two_settings_holds():
    assert small_study("study.seed=7", "study.seed=8").seed == 8


@pytest.mark.parametrize("text", ["exponential", '"exponential"', " exponential "])
def test_a_setting_may_leave_the_quotes_of_a_word_out(text):
    study = small_study(f"numerics.scheme={text}")
    assert study.variants[""].scheme == "exponential"


def test_comparison_inherits_the_numerics_it_does_not_name():
    coarse = small_study("numerics.horizon=7.0").variants["coarse"]
    assert coarse == Numerics("implicit-euler", 1, 16, 7.0)


def test_automatic_steps_are_kept_as_a_question():
    assert small_study("numerics.steps_per_spacing=auto").variants[""].steps_per_spacing is None


def test_settings_in_force_are_kept_as_text():
    text = json.loads(small_study("grid.hurst=0.25", scale="wide").text)
    assert text["grid"]["hurst"] == 0.25
    assert text["grid"]["normal_force"] == [0.04, 0.4, 4.0]
    assert "scales" not in text


def test_snapping_moves_the_spacing_to_one_that_divides():
    study = small_study("surface.snap_spacing=true", "grid.spacing=9.9e-5")
    assert study.elements(study.grid["spacing"][0]) == 100


def test_study_is_found_by_name():
    assert find_study("fig7").parts[-3:] == ("studies", "fig7", "study.toml")


def test_studies_of_the_current_folder_come_first(tmp_path, monkeypatch):
    mine = tmp_path / "studies" / "fig7" / "study.toml"
    mine.parent.mkdir(parents=True)
    mine.write_text(TEXT)
    monkeypatch.chdir(tmp_path)
    assert find_study("fig7") == mine


def test_study_is_found_by_path(tmp_path):
    path = write_study(tmp_path)
    study = read_study(path)
    assert (study.name, study.folder) == ("small", tmp_path)


def test_study_toml_is_named_after_its_folder(tmp_path):
    path = tmp_path / "mine" / "study.toml"
    path.parent.mkdir()
    path.write_text(TEXT)
    assert read_study(str(path)).name == "mine"
