"""`animate SCENE.toml` draws one line of a scene; what is no scene is refused beforehand."""

from pathlib import Path

import pytest
from PIL import Image

from elastomer_friction.workflow.cli.commands import main
from elastomer_friction.workflow.study import read_scene
from tests.support.commands import output

CREEP = str(Path(__file__).parents[3] / "docs" / "creep.toml")
SMALL = ["--set", "numerics.samples=8", "--set", "surface.rolloff=5e-4", "--set"]
SMALL += ["grid.spacing=2e-5", "--set", "surface.cutoff=5e-5"]


@pytest.mark.exhaustive  # compiles kernels of its own; what is drawn, report/test_animation.py asks
def test_the_scene_of_the_readme_is_drawn(capsys, tmp_path):
    path = tmp_path / "made" / "creep.gif"
    assert output(capsys, "animate", CREEP, *SMALL, "--out", str(path)).strip() == str(path)
    with Image.open(path) as animation:
        assert animation.n_frames == 8


def test_another_kind_of_file_is_refused_before_anything_is_computed(capsys, tmp_path):
    assert main(["animate", CREEP, "--out", str(tmp_path / "creep.avi")]) == 2
    assert "creep.avi: must end in .gif or .mp4" in capsys.readouterr().err


def test_a_grid_is_no_scene(capsys):
    assert main(["animate", CREEP, "--set", "grid.normal_force=[0.1, 0.2]"]) == 2
    assert "a scene has one value of it" in capsys.readouterr().err


def test_a_study_is_animated_without_its_comparisons(tmp_path):
    text = Path(CREEP).read_text(encoding="utf-8")
    path = tmp_path / "study.toml"
    path.write_text(f"{text}\n[compare.coarse]\nsteps_per_spacing = 1\n", encoding="utf-8")
    study = read_scene(str(path), None, [], ["trace", "snapshots"])
    assert list(study.variants) == [""]
    assert study.realizations == 1
    assert study.scene.quantities == ("trace", "snapshots")


def test_a_study_without_a_programme_is_refused(capsys):
    assert main(["animate", "fig7"]) == 2
    assert '"trace": there is no [[scene.programme]]' in capsys.readouterr().err


def test_a_study_that_measures_the_program_is_no_scene(capsys):
    assert main(["animate", "stability"]) == 2
    assert "stability: measures the program itself" in capsys.readouterr().err
