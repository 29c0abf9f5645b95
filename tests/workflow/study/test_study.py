"""A study of a grid: values of the file, defaults, shape, elements."""

import json

from tests.support.small import TEXT, small_study
from workflow.study.numerics import Numerics


def test_values_of_the_file_reach_the_study():
    study = small_study()
    assert (study.name, study.title, study.seed) == ("small", "small", 1)
    assert (study.realizations, study.realizations_per_block, study.blocks) == (4, 1, 4)
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
