"""The elastic body that a study computes unless scene.body names one."""

import numpy as np
import pytest

import elastomer_friction as ef
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study import read_study
from tests.support.small import TEXT, small_study, write_study

PRESSED = TEXT.replace("normal_force = [0.04, 0.4]", "normal_pressure = [2e4, 4e4]")
MEASURED = TEXT.replace("length = 0.01", 'file = "map.csv"').replace("hurst = [0.3, 0.7]\n", "")
MEASURED = MEASURED.replace("spacing = 1e-4\nroughness = 1e-5\n", "").replace(
    "realizations = 16\n", ""
)
ON_MAP = MEASURED.replace("normal_force = [0.04, 0.4]", "normal_pressure = 2e4")
SLIDES = (
    "scene.programme=[{slide={velocity=0.1, distance=1e-3}}, {slide={velocity=0.2, distance=1e-3}}]"
)
SIDE = 12
STRIP = 1e-6 * np.random.default_rng(0).standard_normal((3 * SIDE, SIDE))
HEIGHTS = STRIP[:SIDE]


def study_of(folder, text, *settings, rows=SIDE, row_step=1):
    """Return a study with the small surface file map.csv, a list of points of ``rows`` rows."""
    points = [f"{x},{row_step * y},{STRIP[y, x]}" for y in range(rows) for x in range(SIDE)]
    (folder / "map.csv").write_text("\n".join(["x [mm],y [mm],z [m]", *points]), encoding="utf-8")
    return read_study(write_study(folder, text), None, list(settings))


@pytest.mark.parametrize(
    ("settings", "text", "body"),
    [
        ([], TEXT, "foundation"),
        ([], PRESSED, "half-space"),
        (["scene.body=foundation"], PRESSED, "foundation"),
        (["scene.body=half-space"], TEXT, "half-space"),
    ],
)
def test_random_surfaces(settings, text, body):
    study = small_study(*settings, text=text)
    assert study.surface.body == body
    assert study.body_choice.startswith(f"{body}: ")
    assert ("scene.body" in study.body_reason) == bool(settings)


def test_body_in_place_of_the_default_is_stated_with_the_default():
    forced = small_study("scene.body=foundation", text=PRESSED).body_reason
    assert forced.startswith("given by scene.body, in place of the half-space (default: a nominal")
    assert small_study("scene.body=half-space", text=PRESSED).body_reason == "given by scene.body"


def test_measured_map_under_a_pressure_is_a_map_of_a_half_space(tmp_path):
    study = study_of(tmp_path, ON_MAP)
    assert study.surface.body == "half-space"
    assert study.surface.profile.heights.shape == (1, 2 * SIDE, 2 * SIDE)
    assert study.body_reason == "the measured heights are a map"


def test_lines_of_a_measured_map_are_those_of_a_foundation(tmp_path):
    for setting in ("surface.lines=measured", "surface.lines=equivalent", "scene.body=foundation"):
        study = study_of(tmp_path, ON_MAP, setting, "study.realizations=8")
        assert study.surface.body == "foundation"
        assert study.surface.profile.heights.ndim == 2


def test_prescribed_indentation_is_that_of_lines(tmp_path):
    text = MEASURED.replace("normal_force = [0.04, 0.4]", "prescribed_indentation = 1e-6")
    text = text.replace("velocity_step = 0.2\n", "").replace("velocity = [0.03, 0.1]\n", "")
    settings = ("scene.control=indentation", SLIDES, "scene.start=relaxed")
    assert study_of(tmp_path, text, *settings).surface.body == "foundation"


def test_strip_is_lines_under_a_force_and_a_map_under_a_pressure(tmp_path):
    pressed = study_of(tmp_path, ON_MAP, rows=3 * SIDE)
    assert pressed.surface.body == "half-space"
    assert "the middle of 36 x 12" in dict(pressed.descriptions)["lines"]
    loaded = study_of(tmp_path, MEASURED, "study.realizations=32", rows=3 * SIDE)
    assert (loaded.surface.body, loaded.surface.profile.heights.shape[0]) == ("foundation", 36)


def test_few_measured_rows_are_lines(tmp_path):
    study = study_of(tmp_path, ON_MAP, rows=2)
    assert (study.surface.body, study.body_reason) == (
        "foundation",
        "the measured heights are lines",
    )


def test_map_under_a_force_is_ambiguous(tmp_path):
    """The force per line and the pressure F_N/L^2 are both named as remedies."""
    with pytest.raises(UserError) as error:
        study_of(tmp_path, MEASURED)
    side = 1e-3 * SIDE
    pressure = f"grid.normal_pressure = {0.04 / side**2:.4g}"
    for term in ("grid.normal_force = 0.04", pressure, 'scene.body = "foundation"'):
        assert term in str(error.value)
    assert study_of(tmp_path, MEASURED, "scene.body=foundation").surface.body == "foundation"


def test_map_of_unequal_steps_names_the_foundation(tmp_path):
    with pytest.raises(UserError, match=r'square cells; resample it, or set scene.body = "found'):
        study_of(tmp_path, ON_MAP, row_step=2)


SCENE = {
    "material": {"shear_modulus": 1e6, "relaxation_time": 1e-3},
    "programme": [{"slide": {"velocity": 0.1, "distance": 1e-3}}],
    "length": 1e-3 * SIDE,
    "quantities": ["steady"],
    "numerics": {"steps_per_spacing": 2},
}


def test_scene_on_an_array_of_heights():
    with pytest.raises(UserError, match=r"grid.normal_pressure = 6944, F_N/L\^2"):
        ef.scene.run(profile=HEIGHTS, normal_force=1.0, **SCENE)
    on_map = ef.scene.run(profile=HEIGHTS, normal_pressure=1e3, **SCENE)
    assert on_map.attrs["body"] == "half-space"
    assert on_map.attrs["body_reason"] == "the measured heights are a map"
    lines = ef.scene.run(profile=HEIGHTS[:4], normal_force=1.0, realizations=4, **SCENE)
    assert lines.attrs["body"] == "foundation"


def test_square_at_the_centre_of_a_rectangular_array():
    """The side is that of the square, so that slopes are those of the samples."""
    wide = np.concatenate([HEIGHTS[:, -2:], HEIGHTS, HEIGHTS[:, :2]], axis=1)
    scene = SCENE | {"body": "half-space", "normal_pressure": 1e3}
    whole = ef.scene.run(profile=HEIGHTS, **scene)
    cut = ef.scene.run(profile=wide, **(scene | {"length": 1e-3 * (SIDE + 4)}))
    assert float(cut.mu_1) == pytest.approx(float(whole.mu_1), rel=1e-12)
    assert "the middle 12 x 12" in cut.attrs["lines"]
