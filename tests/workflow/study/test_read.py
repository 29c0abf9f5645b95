"""Reading study.toml: scales, --set, where a study is looked for, in which line a key stands."""

import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.read import (
    find_study,
    key_of,
    known_studies,
    line_of,
    read_study,
)
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


def test_studies_of_the_current_folder_come_first(tmp_path, monkeypatch):
    mine = tmp_path / "studies" / "fig7" / "study.toml"
    mine.parent.mkdir(parents=True)
    mine.write_text(TEXT)
    assert find_study("fig7").parts[-3:] == ("studies", "fig7", "study.toml")
    monkeypatch.chdir(tmp_path)
    assert find_study("fig7") == mine


def test_a_study_is_named_after_its_file_or_its_folder(tmp_path, monkeypatch):
    study = read_study(write_study(tmp_path))
    assert (study.name, study.folder) == ("small", tmp_path)
    (tmp_path / "study.toml").write_text(TEXT)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder").mkdir()
    for path in (tmp_path / "study.toml", "study.toml", "folder/../study.toml"):
        assert read_study(str(path)).name == tmp_path.name


@pytest.mark.parametrize("name", ["my_study", "my-study"])
def test_a_hyphen_stands_for_an_underscore(tmp_path, monkeypatch, name):
    folder = tmp_path / "studies" / "my_study"
    folder.mkdir(parents=True)
    (folder / "study.toml").write_text(TEXT, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert find_study(name) == folder / "study.toml"


FIG7 = known_studies()["fig7"].read_text()
STEPS = known_studies()["velocity_steps"].read_text()


def at(text: str, line: int | None) -> str:
    """Return a line of a text, by its number from 1."""
    return text.splitlines()[line - 1] if line else ""


@pytest.mark.parametrize(
    ("key", "scale", "line"),
    [
        ("grid.velocity", "", "velocity = {geomspace = [1e-4, 1e-1, 8]}       # m/s"),
        ("grid.velocity.geomspace[2]", "paper", "velocity = {geomspace = [1e-4, 1e-1, 20]}"),
        ("grid.roughness", "paper", "roughness = 1e-5                               # m"),
        ("grid.missing", "paper", "[grid]"),
        ("compare.paper_step.steps_per_spacing", "", "steps_per_spacing = 1"),
        ("scales.paper.study.realizations", "", "realizations = 200"),
        ("gird.hurst", "", ""),
    ],
)
def test_a_key_is_found_where_it_is_in_force(key, scale, line):
    assert at(FIG7, line_of(FIG7, key, scale)) == line


def test_segments_of_a_programme_are_counted():
    lines = [line_of(STEPS, f"scene.programme[{k}].slide.velocity") for k in (0, 1, 11)]
    assert [at(STEPS, line) for line in lines] == [
        "slide = {ratio = 1.0, distance = 1e-3}",
        "slide = {ratio = 1.2, distance = 5e-3}",
        "slide = {ratio = 0.1, distance = 5e-3}",
    ]


@pytest.mark.parametrize(
    ("message", "key"),
    [
        ("grid.velocity.linspace[2] = 20000: must be", "grid.velocity.linspace[2]"),
        ("grid: 200000000 points", "grid"),
        ("scene.programme[0] holds jump: must hold", "scene.programme[0]"),
        ("--set grid.hurst: use table.key=value", ""),
    ],
)
def test_the_key_of_a_message(message, key):
    assert key_of(message) == key


@pytest.mark.parametrize(
    ("setting", "placed"), [("grid.velocity=[0.1]", True), ("grid.hurst=2", False)]
)
def test_a_value_of_the_command_line_stands_in_no_line(setting, placed):
    text = TEXT.replace("hurst = [0.3, 0.7]", "hurst = 1.2")
    with pytest.raises(UserError) as caught:
        small_study(setting, text=text)
    line = text.splitlines().index("hurst = 1.2") + 1
    assert caught.value.place.endswith(f"small.toml, line {line})") == placed
