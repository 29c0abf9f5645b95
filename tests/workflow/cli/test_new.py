"""Commands beside those of a run: studies, new, schema, verify, merge, animate."""

import json
import re
from pathlib import Path

import pytest
from PIL import Image

from elastomer_friction.workflow.cli import main
from elastomer_friction.workflow.cli.commands import STUDY_TEMPLATE
from elastomer_friction.workflow.store.store import Store
from elastomer_friction.workflow.study import read_scene
from elastomer_friction.workflow.study.read import known_studies, read_study
from tests.support.commands import facts, output, refusal
from tests.support.shards import WORK, filled, shard_of
from tests.support.small import TEXT, write_study


def test_control_characters_are_escaped(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "studies" / "own"
    folder.mkdir(parents=True)
    write_study(folder, TEXT.replace('"small"', r'"red \u001b[31m \u0007 \u009b"'))
    (folder / "small.toml").rename(folder / "study.toml")
    for command in (["studies"], ["plan", "own"], ["status", "own"]):
        said = output(capsys, *command)
        assert not set(said) - {"\n"} & {chr(code) for code in (*range(32), *range(127, 160))}
        assert (r"red \x1b[31m \x07 \x9b" in said) == (command != ["status", "own"])


def test_studies_are_listed_with_their_titles(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name, text in (("own", '[study]\ntitle = "Mine"'), ("broken", "="), ("nameless", "")):
        (tmp_path / "studies" / name).mkdir(parents=True)
        (tmp_path / "studies" / name / "study.toml").write_text(text)
    lines = dict(line.split(maxsplit=1) for line in output(capsys, "studies").splitlines())
    assert set(lines) == set(known_studies())
    assert lines["own"] == "Mine"
    assert lines["broken"] == lines["nameless"] == "(its study.toml cannot be read)"
    assert lines["fig7"] == read_study("fig7").title


def test_a_new_study_can_be_read_at_every_scale(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    said = output(capsys, "new", "my-rubber")
    path = tmp_path / "studies" / "my_rubber" / "study.toml"
    assert (
        said == "studies/my_rubber/study.toml: edit it, then: python -m workflow plan my-rubber\n"
    )
    study, small = read_study("my-rubber"), read_study("my-rubber", "smoke")
    assert study.title.startswith("my-rubber: ")
    assert all(set(small.grid[axis]) <= set(study.grid[axis]) for axis in study.axes)
    written = path.read_text()
    assert "the study exists already, " in refusal(capsys, "new", "my-rubber")
    assert path.read_text() == written


@pytest.mark.parametrize(
    ("name", "reason"), [("fig7", "the study exists already"), ("../x", "must be letters")]
)
def test_existing_and_invalid_names_are_refused(capsys, tmp_path, monkeypatch, name, reason):
    monkeypatch.chdir(tmp_path)
    assert reason in refusal(capsys, "new", name)
    assert not list(tmp_path.iterdir())


def test_every_key_that_is_commented_out_can_be_given(tmp_path):
    """A pressure replaces the force; a measured line needs its file, an accuracy no branches."""
    text = STUDY_TEMPLATE.read_text(encoding="utf-8")
    given = re.sub(r"^# (?!file|accuracy)(\w+ = )", r"\1", text, flags=re.MULTILINE)
    path = tmp_path / "all.toml"
    path.write_text(re.sub(r"^normal_force", "# normal_force", given, flags=re.MULTILINE))
    study = read_study(str(path))
    assert study.surface.body == "half-space"
    assert study.grid["temperature"] == (20.0, 60.0)
    assert study.pressures == (3e5,)
    assert len(study.material.branches) == 2


def test_the_schema_is_printed_as_json(capsys):
    schema = json.loads(output(capsys, "schema"))
    assert schema["properties"]["grid"]["properties"]["hurst"]["description"]


@pytest.fixture
def results(tmp_path, monkeypatch):
    """Return a folder of results, in the working folder, with a store of three shards."""
    monkeypatch.chdir(tmp_path)
    filled(tmp_path / "results" / "store", WORK[:3])
    return tmp_path / "results"


def test_a_store_is_verified_by_folder_and_by_study(capsys, results, study):
    said = output(capsys, "verify")
    assert facts(said)["shards"].split() == ["shards", "3", "of", "3", "sound"]
    for what in (("results",), ("results/store",), (study,), (study, "--out", "results/small.nc")):
        assert facts(output(capsys, "verify", *what))["shards"] == facts(said)["shards"]


def test_a_fault_is_printed_and_is_exit_status_three(capsys, results):
    path = shard_of(Store(results / "store"), WORK[1])
    path.write_bytes(b"")
    assert main(["verify", "results"]) == 3
    out, err = capsys.readouterr()
    assert err == ""
    assert f"fault       {path.name}: damaged" in out


def test_stores_are_merged_by_folder(capsys, results, tmp_path):
    said = output(capsys, "merge", "results", "other")
    assert said == "merged      3 of 3 shards, 3 new records\n"
    assert len(list((tmp_path / "other" / "store").glob("*.npz"))) == 3
    assert "0 of 3 shards" in output(capsys, "merge", "other/store", "results/store")


def test_folders_without_a_store_are_refused(capsys, results):
    (results / "empty").mkdir()
    for command in (("verify", "results/empty"), ("merge", "results/empty", "results")):
        assert "holds no store of finished work" in refusal(capsys, *command)


CREEP = str(Path(__file__).parents[3] / "docs" / "creep.toml")
SMALL = ["--set", "numerics.samples=8", "--set", "surface.rolloff=5e-4", "--set"]
SMALL += ["grid.spacing=2e-5", "--set", "surface.cutoff=5e-5"]


@pytest.mark.exhaustive  # compiles kernels; report/test_animation.py tests the drawing
def test_the_scene_of_the_readme_is_drawn(capsys, tmp_path):
    path = tmp_path / "made" / "creep.gif"
    assert output(capsys, "animate", CREEP, *SMALL, "--out", str(path)).strip() == str(path)
    with Image.open(path) as animation:
        assert animation.n_frames == 8


def test_a_study_is_animated_without_its_comparisons(tmp_path):
    text = Path(CREEP).read_text(encoding="utf-8")
    path = tmp_path / "study.toml"
    path.write_text(f"{text}\n[compare.coarse]\nsteps_per_spacing = 1\n", encoding="utf-8")
    study = read_scene(str(path), None, [], ["trace", "snapshots"])
    assert list(study.variants) == [""]
    assert study.realizations == 1
    assert study.scene.quantities == ("trace", "snapshots")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([CREEP, "--out", "creep.avi"], "creep.avi: must end in .gif or .mp4"),
        ([CREEP, "--set", "grid.normal_force=[0.1, 0.2]"], "must be one value in a scene"),
        (["fig7"], "has no motion over time; add a [[scene.programme]]"),
        (["stability"], "stability: measures the program itself"),
    ],
)
def test_invalid_scenes_are_refused_before_computation(capsys, arguments, words):
    assert words in refusal(capsys, "animate", *arguments)
