"""`animate SCENE.toml` draws one line of a scene; what is no scene is refused beforehand."""

from pathlib import Path

import pytest
from PIL import Image

from elastomer_friction.workflow.study import read_scene
from tests.support.commands import output, refusal

CREEP = str(Path(__file__).parents[3] / "docs" / "creep.toml")
SMALL = ["--set", "numerics.samples=8", "--set", "surface.rolloff=5e-4", "--set"]
SMALL += ["grid.spacing=2e-5", "--set", "surface.cutoff=5e-5"]


@pytest.mark.exhaustive  # compiles kernels of its own; what is drawn, report/test_animation.py asks
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
        ([CREEP, "--set", "grid.normal_force=[0.1, 0.2]"], "a scene has one value of it"),
        (["fig7"], '"trace": there is no [[scene.programme]]'),
        (["scaling"], "scaling: measures the program itself"),
    ],
)
def test_what_is_no_scene_is_refused_before_anything_is_computed(capsys, arguments, words):
    assert words in refusal(capsys, "animate", *arguments)
