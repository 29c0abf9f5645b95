"""Reading study.toml: scales, --set, comparisons, and where a study is looked for."""

import pytest

from elastomer_friction.workflow.study.read import find_study, read_study
from tests.support.small import TEXT, small_study, write_study


def test_scale_overrides_what_it_names_only():
    wide = small_study(scale="wide")
    assert wide.grid["normal_force"] == (0.04, 0.4, 4.0)
    assert wide.grid["velocity"] == small_study().grid["velocity"]


def test_scale_replaces_a_generated_axis_whole():
    text = TEXT.replace("[0.04, 0.4]\n", "{geomspace = [0.01, 1.0, 3]}\n")
    text = text.replace("[0.04, 0.4, 4.0]", "{linspace = [1.0, 2.0, 2]}")
    assert small_study(text=text, scale="wide").grid["normal_force"] == (1.0, 2.0)


def test_settings_override_the_scale_and_the_last_of_them_holds():
    study = small_study("grid.normal_force=7", "grid.normal_force=8", scale="wide")
    assert study.grid["normal_force"] == (8.0,)


@pytest.mark.parametrize("text", ["exponential", '"exponential"', " exponential "])
def test_a_setting_may_leave_the_quotes_of_a_word_out(text):
    study = small_study(f"numerics.scheme={text}")
    assert study.variants[""].scheme == "exponential"


def test_study_is_found_by_name():
    assert find_study("fig7").parts[-3:] == ("studies", "fig7", "study.toml")


def test_studies_of_the_current_folder_come_first(tmp_path, monkeypatch):
    mine = tmp_path / "studies" / "fig7" / "study.toml"
    mine.parent.mkdir(parents=True)
    mine.write_text(TEXT)
    monkeypatch.chdir(tmp_path)
    assert find_study("fig7") == mine


def test_a_study_is_named_after_its_file_or_its_folder(tmp_path):
    study = read_study(write_study(tmp_path))
    assert (study.name, study.folder) == ("small", tmp_path)
    (tmp_path / "study.toml").write_text(TEXT)
    assert read_study(str(tmp_path / "study.toml")).name == tmp_path.name


@pytest.mark.parametrize("name", ["my_study", "my-study"])
def test_a_hyphen_stands_for_an_underscore(tmp_path, monkeypatch, name):
    folder = tmp_path / "studies" / "my_study"
    folder.mkdir(parents=True)
    (folder / "study.toml").write_text(TEXT, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert find_study(name) == folder / "study.toml"
