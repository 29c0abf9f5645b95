"""A study of a grid: values of the file, defaults, shape, elements."""

import copy
import json
import math
import tomllib
from pathlib import Path

import numpy as np
import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.study.numerics import Numerics
from elastomer_friction.workflow.study.study import read_grid_study
from tests.support.small import TEXT, small_study


def test_values_of_the_file_reach_the_study():
    study = small_study()
    assert (study.name, study.title, study.seed) == ("small", "small", 1)
    assert (study.realizations, study.realizations_per_block, study.blocks) == (16, 4, 4)
    assert (study.material.shear_modulus, study.material.tau, study.surface.length) == (
        1e7,
        1e-3,
        0.01,
    )
    assert study.grid["normal_force"] == (0.04, 0.4)
    assert study.shape == (2, 2, 1, 1, 2, 1)


def test_what_is_left_out_takes_its_default():
    study = small_study(text=TEXT.replace("seed = 1", "").replace('title = "small"', ""))
    assert (study.seed, study.title, study.surface.normalisation) == (0, "small", "modal")
    assert study.scene.quantities == ("steady", "jump", "relaxation")
    assert study.scene.indentation_rate
    assert study.variants[""] == Numerics(curve_samples=16)


def test_steady_states_alone_need_no_velocity_step():
    study = small_study('scene.quantities=["steady"]', text=TEXT.replace("velocity_step = 0.2", ""))
    assert study.grid["velocity_step"] == (0.0,)


def test_settings_in_force_are_kept_as_text():
    text = json.loads(small_study("grid.hurst=0.25", scale="wide").text)
    assert text["grid"]["hurst"] == 0.25
    assert text["grid"]["normal_force"] == [0.04, 0.4, 4.0]
    assert "scales" not in text


def test_snapping_moves_the_spacing_to_one_that_divides():
    study = small_study("surface.snap_spacing=true", "grid.spacing=9.9e-5")
    assert round(study.surface.length / study.grid["spacing"][0]) == 100


def measured_study(tmp_path, lines, settings="", **how):
    """Return a study of measured lines that a text file holds."""
    x = np.arange(16)
    heights = 1e-6 * np.sin(2.0 * np.pi * (x[:, None] + np.arange(lines)) / 16.0)
    np.savetxt(tmp_path / "lines.txt", np.c_[1e-5 * x, heights])
    columns = list(range(lines + 1))
    text = f"""
        {settings}
        material = {{shear_modulus = 1e7, relaxation_time = 1e-3}}
        grid = {{normal_force = 0.04, velocity = 0.1, velocity_step = 0.2}}
        surface = {{file = "lines.txt", columns = {columns}, units = ["m", "m"], periodic = "none"}}
    """
    return read_grid_study("measured", tmp_path, tomllib.loads(text), **how)


def test_there_are_as_many_realizations_as_measured_lines(tmp_path):
    study = measured_study(tmp_path, 4)
    assert study.realizations == 4
    assert study.grid["spacing"] == (pytest.approx(1e-5),)
    assert study.grid["roughness"] == (study.surface.profile.roughness,)
    assert math.isnan(study.grid["hurst"][0])
    assert measured_study(tmp_path, 4, "study.realizations = 2").realizations == 2
    with pytest.raises(UserError, match=r"^study\.realizations = 5: only 4 lines were measured$"):
        measured_study(tmp_path, 4, "study.realizations = 5")


def test_a_scene_is_a_study_of_one_point():
    tables = tomllib.loads(TEXT.partition("[compare")[0])
    tables["study"] = {}
    tables["grid"] |= {"hurst": 0.7, "normal_force": 0.04, "velocity": 0.1}
    scene = read_grid_study("scene", Path(), copy.deepcopy(tables), one_point=True)
    assert (scene.realizations, scene.blocks) == (1, 1)
    assert set(scene.shape) == {1}
    tables["grid"]["hurst"] = [0.3, 0.7]
    with pytest.raises(UserError, match=r"^grid\.hurst = \[0\.3, 0\.7\]: a scene has one value"):
        read_grid_study("scene", Path(), tables, one_point=True)


def test_one_line_can_be_asked_for_its_state():
    tables = tomllib.loads(SCENE)
    scene = read_grid_study("scene", Path(), copy.deepcopy(tables), one_point=True)
    assert scene.scene.quantities == ("trace", "snapshots", "state")
    tables["study"] = {"realizations": 2}
    with pytest.raises(UserError, match='"snapshots": is there for a single line alone'):
        read_grid_study("scene", Path(), tables, one_point=True)


SCENE = """
material = {shear_modulus = 1e7, relaxation_time = 1e-3}
surface.length = 0.01
grid = {hurst = 0.7, spacing = 1e-4, roughness = 1e-5, normal_force = 0.04}
scene.quantities = ["state", "snapshots", "trace"]
scene.programme = [{slide = {velocity = 0.1, distance = 1e-3}}]
"""


@pytest.mark.parametrize(
    ("asked", "block", "found"),
    [(10, 1, (12, 4)), (2, 1, (8, 4)), (200, 10, (204, 12)), (64, 8, (64, 8)), (6, 3, (8, 4))],
)
def test_random_lines_are_counted_in_whole_quartets_and_blocks(asked, block, found):
    study = small_study(f"study.realizations={asked}", f"study.realizations_per_block={block}")
    assert (study.realizations, study.realizations_per_block) == found
    assert study.realizations_asked == asked
